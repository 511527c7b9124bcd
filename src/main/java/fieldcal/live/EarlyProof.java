package fieldcal.live;

import org.apache.commons.math3.special.Beta;

/**
 * Whether a few samples prove that their centre lies above zero: a test that may be asked after every sample, because its false-alarm rate holds for all of these questions together.
 *
 * <p>The evidence is a test martingale: under the null hypothesis its expectation never grows, so by Ville's inequality (1939) the probability that it ever reaches 1/α is at most α, whenever one stops. It is the mean of
 * two martingales, which is one again:
 *
 * <ul>
 *   <li>The likelihood ratio of a Gaussian sample of unknown scatter σ with the centre δσ, δ ~ N(0, g), against the centre 0, with the right Haar prior on σ (Robbins 1970; Lai 1976; Wang and Ramdas 2024, <i>Anytime-valid t-tests</i>): (1+ng)^(−1/2) · ((1 + t²/ν) / (1 + t²/(ν(1+ng))))^(n/2), where t is Student's and ν = n − 1.
 *       It holds for every scatter, and proves a clear deviation of samples that scatter little within six.
 *   <li>The likelihood ratio of the number k of positive samples with a probability of q, q uniform on [½, 1], against ½: 2ⁿ⁺¹ ∫ qᵏ(1−q)ⁿ⁻ᵏ dq. It holds for every distribution with the median 0, and needs some seventeen samples, but is hardly affected by a wrong one.
 * </ul>
 *
 * <p>A centre below zero gives fewer alarms still: a shift of all samples downwards lowers t and k, and asks for an alarm only where t is positive. So does an overestimated scatter: the scatter is taken to be at least the samples' own standard errors.
 *
 * <p>The values g only decide which deviations are found soonest, not how many alarms are false.
 */
final class EarlyProof {
  /** Variances of the centre in units of the scatter: deviations about as large as the scatter, three times, and ten times as large. */
  private static final double[] VARIANCES = {1, 10, 100};

  private final double needed;

  /**
   * A test.
   *
   * @param falseAlarms probability α of an alarm, ever, where the centre is zero or below
   */
  EarlyProof(double falseAlarms) {
    needed = -Math.log(falseAlarms);
  }

  /**
   * Whether the samples prove that their centre lies above zero.
   *
   * @param samples all from the first on, in any order
   * @param error standard error of one sample by itself, root mean square
   */
  boolean isAboveZero(double[] samples, double error) {
    return logEvidence(samples, error) >= needed;
  }

  /** Natural logarithm of the evidence; minus infinity where the mean is not positive. */
  static double logEvidence(double[] samples, double error) {
    int n = samples.length;
    double mean = 0;
    int positive = 0;
    for (double s : samples) {
      mean += s / n;
      positive += s > 0 ? 1 : 0;
    }
    if (n < 2 || !(mean > 0)) {
      return Double.NEGATIVE_INFINITY;
    }
    double squares = 0;
    for (double s : samples) {
      squares += (s - mean) * (s - mean);
    }
    double variance = Math.max(squares / (n - 1), error * error);
    double square = n * mean * mean / variance / (n - 1);
    double evidence = 0.5 * Math.exp(logOfSigns(n, positive));
    for (double g : VARIANCES) {
      double spread = 1 + n * g;
      double log =
          0.5 * n * (Math.log1p(square) - Math.log1p(square / spread)) - 0.5 * Math.log(spread);
      evidence += 0.5 / VARIANCES.length * Math.exp(log);
    }
    return Math.log(evidence);
  }

  private static double logOfSigns(int n, int positive) {
    double a = positive + 1.0;
    double b = n - positive + 1.0;
    // ∫ from ½ to 1 is the upper tail of a beta distribution.
    return (n + 1) * Math.log(2) + Beta.logBeta(a, b) + Math.log(Beta.regularizedBeta(0.5, b, a));
  }
}
