package fieldcal.diagnosis;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Whether a cause is as strong in each kick as in the others. A cause that is only blamed for another one's doing needs another magnitude in fast kicks than in slow ones, in this direction than in
 * that.
 */
final class Consistency {
  /** No kick counts more than that many times the median one. */
  private static final double MOST_WEIGHT = 3;

  private Consistency() {}

  /** Scatter of the magnitude from kick to kick beyond noise, in shares of the magnitude. */
  static double scatter(ScoreFrame frame, FittedHypothesis at, Chart chart) {
    int from = at.offset(chart);
    int m = chart.size();
    double[] direction = new double[m];
    double size = 0;
    for (int j = 0; j < m; j++) {
      direction[j] = at.shared()[from + j] / chart.scale(j);
      size += direction[j] * direction[j];
    }
    size = Math.sqrt(size);
    if (size == 0) {
      return Double.POSITIVE_INFINITY;
    }
    int n = frame.kicks();
    double[] information = new double[n];
    double[] score = new double[n];
    double length = size;
    IntStream.range(0, n)
        .parallel()
        .forEach(
            k -> {
              ScoreFrame.Part p = frame.part(k, chart);
              if (p == null) {
                return;
              }
              for (int i = 0; i < m; i++) {
                score[k] += direction[i] / length * p.score()[i];
                for (int j = 0; j < m; j++) {
                  information[k] +=
                      direction[i]
                          / length
                          * direction[j]
                          / length
                          * p.information().getEntry(i, j);
                }
              }
            });
    return Math.sqrt(Math.max(0, variance(information, score))) / size;
  }

  private static double variance(double[] information, double[] score) {
    double[] sorted = Arrays.stream(information).filter(v -> v > 0).sorted().toArray();
    if (sorted.length < 2) {
      return 0;
    }
    double most = MOST_WEIGHT * sorted[sorted.length / 2];
    double weights = 0;
    double sum = 0;
    for (int k = 0; k < score.length; k++) {
      if (information[k] > 0) {
        double w = Math.min(information[k], most);
        double away = score[k] / information[k];
        weights += w;
        sum += w * (away * away - 1 / information[k]);
      }
    }
    return sum / weights;
  }
}
