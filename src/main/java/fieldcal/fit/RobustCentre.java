package fieldcal.fit;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A mean, or the median where the samples come from two sides: kicks with and without spin, for example. Where the mean lies farther from the weighted median than nineteen in twenty symmetric scatters bring it, the median is taken,
 * with an error that covers both, since it is not known which side is meant.
 *
 * @param value of the parameter, in its unit
 * @param standardError in the same unit
 */
public record RobustCentre(double value, double standardError) {
  /** Variance of a median over that of the mean of Gaussian samples: π/2. */
  private static final double MEDIAN_VARIANCE = Math.PI / 2;

  /** Mean and median of Gaussian samples differ by √(π/2 − 1) = 0.756 standard errors; one in twenty by 1.96 times that: the median costs little. */
  private static final double SKEWED = 1.96 * 0.756;

  /** Fewer samples do not show two sides. */
  private static final int FEWEST = 6;

  /**
   * The centre of samples whose mean is known.
   *
   * @param values the samples
   * @param spreads what is expected of each: its own error and the scatter, standard deviations, positive; same length
   * @param mean of the samples
   * @param standardError of the mean; NaN or 0 when it is not known
   * @return the mean, or the median with a larger error
   */
  public static RobustCentre of(
      double[] values, double[] spreads, double mean, double standardError) {
    RobustCentre asItIs = new RobustCentre(mean, standardError);
    if (values.length < FEWEST || !(standardError > 0)) {
      return asItIs;
    }
    double median = weightedMedian(values, spreads);
    double apart = mean - median;
    if (Math.abs(apart) < SKEWED * standardError) {
      return asItIs;
    }
    return new RobustCentre(median, Math.hypot(Math.sqrt(MEDIAN_VARIANCE) * standardError, apart));
  }

  /** Where half of the weight lies on either side; between two samples the middle. */
  private static double weightedMedian(double[] values, double[] spreads) {
    List<Integer> sorted =
        IntStream.range(0, values.length)
            .boxed()
            .sorted(Comparator.comparingDouble(i -> values[i]))
            .toList();
    double[] weights = sorted.stream().mapToDouble(i -> 1 / (spreads[i] * spreads[i])).toArray();
    double half = IntStream.range(0, weights.length).mapToDouble(i -> weights[i]).sum() / 2;
    double below = 0;
    int i = 0;
    while (below + weights[i] < half) {
      below += weights[i++];
    }
    boolean between = Math.abs(below + weights[i] - half) < 1e-9 * half;
    double at = values[sorted.get(i)];
    return between && i + 1 < weights.length ? (at + values[sorted.get(i + 1)]) / 2 : at;
  }
}
