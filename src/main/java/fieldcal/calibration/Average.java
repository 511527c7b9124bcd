package fieldcal.calibration;

import fieldcal.fit.Agreement;
import fieldcal.fit.Estimate;
import fieldcal.fit.RobustCentre;
import java.util.List;
import java.util.Optional;

/**
 * Weighted mean of samples of unequal precision, with its standard error.
 *
 * <p>Random-effects model: a sample scatters about the mean by its own error and by what differs from kick to kick, with variance
 * τ² (DerSimonian and Laird 1986); weights are {@code 1/(σᵢ² + τ²)}. With τ = 0 it is the inverse-variance mean; where kicks differ
 * more than their errors say, it approaches the plain mean. A plain mean of samples whose precision differs tenfold, as with kick
 * speed, would be a poor estimate.
 *
 * @param mean in the parameter's unit; NaN without samples
 * @param standardError of the mean, in the parameter's unit; NaN without samples
 * @param scatter τ, standard deviation from kick to kick beyond the fits' errors, in the parameter's unit; NaN without samples
 * @param n how many samples
 */
public record Average(double mean, double standardError, double scatter, int n) {
  /**
   * Averages: weights 1/(error² + τ²), with the scatter τ from the samples themselves (DerSimonian and Laird 1986).
   *
   * @param values the samples, all in one unit
   * @param errors their standard errors in that unit, positive; same length
   * @return mean, error and scatter in that unit; all NaN when empty; the scatter of a single sample is 0
   */
  public static Average of(double[] values, double[] errors) {
    int n = values.length;
    if (n == 0) {
      return new Average(Double.NaN, Double.NaN, Double.NaN, 0);
    }
    double[] weights = new double[n];
    for (int i = 0; i < n; i++) {
      weights[i] = 1 / (errors[i] * errors[i]);
    }
    double fixed = weightedMean(values, weights);
    double w = 0;
    double w2 = 0;
    double q = 0;
    for (int i = 0; i < n; i++) {
      w += weights[i];
      w2 += weights[i] * weights[i];
      q += weights[i] * (values[i] - fixed) * (values[i] - fixed);
    }
    double tau2 = n > 1 ? Math.max(0, (q - (n - 1)) / (w - w2 / w)) : 0;
    double sum = 0;
    for (int i = 0; i < n; i++) {
      weights[i] = 1 / (errors[i] * errors[i] + tau2);
      sum += weights[i];
    }
    return new Average(weightedMean(values, weights), 1 / Math.sqrt(sum), Math.sqrt(tau2), n);
  }

  /**
   * Averages the samples that are not dropped.
   *
   * @param samples of one parameter
   * @return the average
   */
  public static Average of(List<Sample> samples) {
    List<Sample> used = samples.stream().filter(s -> s.dropped().isEmpty()).toList();
    return of(values(used), errors(used));
  }

  private static double weightedMean(double[] values, double[] weights) {
    double sum = 0;
    double total = 0;
    for (int i = 0; i < values.length; i++) {
      sum += weights[i] * values[i];
      total += weights[i];
    }
    return sum / total;
  }

  /**
   * The same mean with an error that does not shrink with the samples that were excluded: a scatter that is cut at two standard deviations looks smaller than it is, and the mean of what is left moves about more than that of all.
   *
   * <p>For normal samples, the mean of all is independent of the distances between them (Basu 1955, Sankhyā 15, 377), and so of what the 2σ rule excludes. The distance between the mean of what is left and the mean of all is known. So the error combines both in quadrature: that of the mean of all ({@link HuberMean}) and this distance. Where the scatter was estimated from few samples, Student's distribution makes the error of the mean as wide as its 95 %.
   *
   * @param all the samples used and those that were excluded for their value
   * @return this average, or one with a larger standard error
   */
  public Average widened(List<Sample> all) {
    if (all.size() < 2 || !(standardError > 0)) {
      return this;
    }
    HuberMean whole = HuberMean.of(values(all), errors(all));
    double error = Math.hypot(byChance(whole, all.size()), mean - whole.mean());
    return new Average(mean, Math.max(standardError, error), scatter, n);
  }

  private static double byChance(HuberMean whole, int samples) {
    double student = whole.scatter() > 0 ? Estimate.student(samples) : 1;
    return student * whole.standardError();
  }

  /**
   * The error of the mean by chance alone, without the distance between the mean of what the 2σ rule leaves and that of all ({@link #widened}). Two means that differ by several such errors do not describe the same kicks.
   *
   * @param samples that the 2σ rule has judged
   * @return standard error in their unit; infinite where fewer than two kicks can be trusted
   */
  public static double errorByChance(List<Sample> samples) {
    List<Sample> all = spread(samples);
    return all.size() < 2
        ? Double.POSITIVE_INFINITY
        : byChance(HuberMean.of(values(all), errors(all)), all.size());
  }

  /**
   * The same average, robust against samples that form two groups ({@link RobustCentre}).
   *
   * @param samples from which it was averaged, and those that were not
   * @return this average, or another with a larger standard error
   */
  public Average robust(List<Sample> samples) {
    List<Sample> used = samples.stream().filter(s -> s.dropped().isEmpty()).toList();
    RobustCentre centre =
        RobustCentre.of(
            values(used), errors(used), scatter, mean, standardError, agreement(samples));
    return new Average(centre.value(), centre.standardError(), scatter, n);
  }

  /**
   * The value on which several samples agree while others scatter. Those that the 2σ rule excludes count, too, since they may belong to one of the two groups.
   *
   * @param samples of one parameter
   * @return empty where they scatter about one mean
   */
  public static Optional<Agreement> agreement(List<Sample> samples) {
    List<Sample> spread = spread(samples);
    return Agreement.of(values(spread), errors(spread));
  }

  /**
   * The average of a parameter: weighted, robust, with an error that covers what the 2σ rule excludes.
   *
   * @param samples that the 2σ rule has judged
   * @return their average
   */
  public static Average judged(List<Sample> samples) {
    Average mean = of(samples);
    List<Sample> spread = spread(samples);
    // An error that already covers both groups leaves no scatter between them.
    return agreement(samples).isPresent()
        ? mean.widened(spread).robust(samples)
        : mean.robust(samples).widened(spread);
  }

  /** The samples that are used and those that were excluded for their value; not those of kicks that are not trusted. */
  private static List<Sample> spread(List<Sample> samples) {
    return samples.stream().filter(s -> s.dropped().isEmpty() || s.leftForItsValue()).toList();
  }

  private static double[] values(List<Sample> samples) {
    return samples.stream().mapToDouble(Sample::value).toArray();
  }

  private static double[] errors(List<Sample> samples) {
    return samples.stream().mapToDouble(Sample::standardError).toArray();
  }

  /**
   * How far a sample is from the mean, in units of what is expected of it: its own error and the scatter between kicks.
   *
   * @param sample of the same parameter
   * @return distance, 0 or more
   */
  public double sigmas(Sample sample) {
    double spread = Math.hypot(sample.standardError(), scatter);
    return Math.abs(sample.value() - mean) / spread;
  }
}
