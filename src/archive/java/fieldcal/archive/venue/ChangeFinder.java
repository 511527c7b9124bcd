package fieldcal.archive.venue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Cuts series of measurements where they change. Between changes each series is a straight line over time with a scatter of its own from one measurement to the next.
 *
 * <p>Exact optimal partitioning by dynamic programming (Jackson et al. 2005), all series cut at the same places. The penalty of a cut is that of the Bayesian information criterion (Schwarz 1978; Zhang and Siegmund 2007) for the levels, slopes and
 * the place that it adds. The scatter comes from the median difference of neighbours, which few changes do not touch.
 */
final class ChangeFinder {
  /** A stretch has that many measurements at least: a single one that is off is an outlier, not a change. */
  private static final int SHORTEST = 2;

  /** Fewer do not show a slope. */
  private static final int FEWEST_FOR_A_SLOPE = 4;

  /** Penalty for the place of a cut, which was chosen among many, in logarithms of the number of samples (modified criterion of Zhang and Siegmund 2007). */
  private static final double PLACE = 3;

  /** Standard deviation of a Gaussian over the median of its absolute deviations. */
  private static final double NORMAL_MEDIAN = 1.4826;

  private final double[] times;
  private final List<Measured[]> series;
  private final double[] scatter;

  /**
   * A problem.
   *
   * @param times of the measurements, ascending
   * @param series each with one measurement for each time, null where there is none
   * @param smallest standard deviation from one measurement to the next that each series has at least, whatever few of them show
   */
  ChangeFinder(double[] times, List<Measured[]> series, double[] smallest) {
    this.times = times;
    this.series = series;
    scatter = new double[series.size()];
    for (int s = 0; s < scatter.length; s++) {
      scatter[s] = Math.max(smallest[s] * smallest[s], scatter(series.get(s)));
    }
  }

  /** Variance between neighbours beyond their errors. */
  private static double scatter(Measured[] series) {
    Measured[] known = Arrays.stream(series).filter(m -> m != null).toArray(Measured[]::new);
    if (known.length < 3) {
      return 0;
    }
    double[] differences = new double[known.length - 1];
    double[] variances = new double[known.length - 1];
    for (int i = 0; i < differences.length; i++) {
      differences[i] = Math.abs(known[i + 1].value() - known[i].value());
      variances[i] = Math.pow(known[i].error(), 2) + Math.pow(known[i + 1].error(), 2);
    }
    double spread = NORMAL_MEDIAN * StatUtils.percentile(differences, 50);
    return Math.max(0, (spread * spread - StatUtils.percentile(variances, 50)) / 2);
  }

  /**
   * Finds the changes.
   *
   * @return indices of the first measurement after each change, ascending
   */
  List<Integer> find() {
    int n = times.length;
    double samples = 0;
    for (Measured[] one : series) {
      samples += Arrays.stream(one).filter(m -> m != null).count();
    }
    double penalty = Math.log(Math.max(2, samples));
    double[] best = new double[n + 1];
    int[] from = new int[n + 1];
    Arrays.fill(best, 1, n + 1, Double.POSITIVE_INFINITY);
    for (int end = SHORTEST; end <= n; end++) {
      for (int begin = 0; begin <= end - SHORTEST; begin++) {
        double cost = best[begin] + cost(begin, end, penalty) + (begin > 0 ? PLACE * penalty : 0);
        if (cost < best[end]) {
          best[end] = cost;
          from[end] = begin;
        }
      }
    }
    List<Integer> cuts = new ArrayList<>();
    for (int end = n; end > 0 && from[end] > 0; end = from[end]) {
      cuts.add(0, from[end]);
    }
    return cuts;
  }

  /** Chi-square of a stretch, and the penalty of the parameters that describe it. */
  private double cost(int begin, int end, double penalty) {
    double cost = 0;
    for (int s = 0; s < series.size(); s++) {
      Line line = line(s, begin, end);
      if (line.n > 0) {
        cost += line.chiSquare + line.unknowns * penalty;
      }
    }
    return cost;
  }

  /**
   * The straight line through a stretch of one series.
   *
   * @param index of the series
   * @param begin first measurement
   * @param end behind the last one
   */
  Line line(int index, int begin, int end) {
    double w = 0;
    double wt = 0;
    double wy = 0;
    double wtt = 0;
    double wty = 0;
    double wyy = 0;
    int n = 0;
    for (int i = begin; i < end; i++) {
      Measured m = series.get(index)[i];
      if (m != null) {
        double weight = 1 / (m.error() * m.error() + scatter[index]);
        double t = times[i] - times[begin];
        double y = m.value() - first(index, begin);
        w += weight;
        wt += weight * t;
        wy += weight * y;
        wtt += weight * t * t;
        wty += weight * t * y;
        wyy += weight * y * y;
        n++;
      }
    }
    if (n == 0) {
      return new Line(0, 0, 0, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }
    double mean = first(index, begin) + wy / w;
    double middle = times[begin] + wt / w;
    double spread = wtt - wt * wt / w;
    double flat = wyy - wy * wy / w;
    if (n < FEWEST_FOR_A_SLOPE || !(spread > 0)) {
      return new Line(
          n, 1, Math.max(0, flat), middle, mean, 1 / Math.sqrt(w), Double.NaN, Double.NaN);
    }
    double slope = (wty - wt * wy / w) / spread;
    return new Line(
        n,
        2,
        Math.max(0, flat - slope * slope * spread),
        middle,
        mean,
        1 / Math.sqrt(w),
        slope,
        1 / Math.sqrt(spread));
  }

  /** Near the values, so that squares of small differences do not drown in squares of large values. */
  private double first(int index, int begin) {
    for (int i = begin; i < times.length; i++) {
      if (series.get(index)[i] != null) {
        return series.get(index)[i].value();
      }
    }
    return 0;
  }

  /** The time in the middle between the last measurement before a cut and the first one after it. */
  double between(int cut) {
    return (times[cut - 1] + times[cut]) / 2;
  }

  /** A line: how many measurements, unknowns, chi-square, the time of their middle, level there and slope with errors; NaN where there is none. */
  record Line(
      int n,
      int unknowns,
      double chiSquare,
      double middle,
      double mean,
      double meanError,
      double slope,
      double slopeError) {

    /** Its level at a time; without a slope the same at all times. */
    Measured at(double time) {
      if (Double.isNaN(slope)) {
        return new Measured(mean, meanError);
      }
      double since = time - middle;
      return new Measured(mean + slope * since, Math.hypot(meanError, slopeError * since));
    }
  }
}
