package fieldcal.fit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * The centre of samples that may form two groups: kicks with and without spin, for example. The value of the model may then mean either of two things: the average of all kicks, or the value of one group from which the others are drawn away. So the error covers both readings.
 *
 * <p>The second reading is the value on which several kicks agree within their own errors while the others scatter ({@link Agreement}), however many they are. Without such kicks it is the weighted median, where the mean
 * lies farther from it than nineteen in twenty symmetric scatters bring it. The value is that of most samples: the mean where less than half of them agree.
 *
 * @param value of the parameter, in its unit
 * @param standardError in the same unit
 */
public record RobustCentre(double value, double standardError) {
  /** Variance of a median over that of the mean of Gaussian samples: π/2. */
  private static final double MEDIAN_VARIANCE = Math.PI / 2;

  /** Mean and median of Gaussian samples differ by √(π/2 − 1) = 0.756 standard errors; one in twenty by 1.96 times that: the median costs little. */
  private static final double SKEWED = 1.96 * 0.756;

  /**
   * The centre of samples whose mean is known.
   *
   * @param values the samples
   * @param errors their standard errors, positive; same length
   * @param scatter what differs between samples beyond their errors, standard deviation
   * @param mean of the samples
   * @param standardError of the mean; NaN or 0 when it is not known
   * @param agreement on which several of them, and of samples that were excluded as too far from the mean, agree
   * @return the mean, or another value, or the mean with a larger error
   */
  public static RobustCentre of(
      double[] values,
      double[] errors,
      double scatter,
      double mean,
      double standardError,
      Optional<Agreement> agreement) {
    RobustCentre asItIs = new RobustCentre(mean, standardError);
    if (values.length < Agreement.FEWEST || !(standardError > 0)) {
      return asItIs;
    }
    double[] spreads = DoubleStream.of(errors).map(e -> Math.hypot(e, scatter)).toArray();
    double median = weightedMedian(values, spreads);
    double medianError = Math.sqrt(MEDIAN_VARIANCE) * standardError;
    if (agreement.isPresent()) {
      return between(agreement.get(), asItIs, medianError);
    }
    double apart = mean - median;
    return Math.abs(apart) < SKEWED * standardError
        ? asItIs
        : new RobustCentre(median, Math.hypot(medianError, apart));
  }

  /** The centre and its error when several samples agree: two standard errors reach a group of others that agree among themselves, one reaches the mean of all. */
  private static RobustCentre between(Agreement agreed, RobustCentre mean, double medianError) {
    double apart = Math.abs(mean.value() - agreed.value());
    if (agreed.share() < 0.5) {
      return new RobustCentre(mean.value(), Math.hypot(mean.standardError(), apart));
    }
    double half = agreed.othersAgree() ? Math.abs(agreed.others() - agreed.value()) / 2 : 0;
    return new RobustCentre(agreed.value(), Math.hypot(medianError, Math.max(apart, half)));
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
