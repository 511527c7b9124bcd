package fieldcal.calibration;

import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;

/**
 * Mean and scatter of samples of unequal precision of which none is excluded: one that lies farther than two standard deviations away counts as if it lay exactly two away.
 *
 * <p>Huber's Proposal 2 (Huber 1964, Annals of Mathematical Statistics 35, 73), with a scatter between samples in addition to their own errors as in {@link Average}: the mean m and the scatter τ solve Σ ψ(dᵢ)/sᵢ = 0 and Σ ψ(dᵢ)² = (n − 1)·β with
 * sᵢ² = σᵢ² + τ², dᵢ = (xᵢ − m)/sᵢ, ψ(d) = d cut at ±2, and β the expectation of ψ² for normal samples. For these the scatter is not biased low, as it is when the outer samples are excluded, and the mean is as precise as the plain one to within a per cent; of twelve samples, two may lie anywhere.
 *
 * @param mean in the samples' unit
 * @param standardError of the mean of normal samples with this scatter, in the same unit
 * @param scatter τ, standard deviation between samples beyond their errors; 0 where their errors alone explain how far they lie apart
 */
record HuberMean(double mean, double standardError, double scatter) {
  /** Where samples are cut, in standard deviations: where the 2σ rule excludes them. */
  private static final double CUT = TwoSigma.LIMIT;

  /** Expectation of ψ² of normal samples, 0.92. */
  private static final double EXPECTED = expected();

  /** Halvings of an interval, until nothing is left of it. */
  private static final int HALVINGS = 40;

  /** Steps to the mean, each of which is at most a few per cent as far from it as the one before. */
  private static final int STEPS = 20;

  /**
   * Estimates both.
   *
   * @param values the samples, at least two
   * @param errors their standard errors, positive; same length
   * @return mean, error and scatter
   */
  static HuberMean of(double[] values, double[] errors) {
    if (within(values, errors, 0)) {
      return at(values, errors, 0);
    }
    double low = 0;
    double high = IntStream.range(0, values.length).mapToDouble(i -> values[i]).max().orElse(0);
    high -= IntStream.range(0, values.length).mapToDouble(i -> values[i]).min().orElse(0);
    // With a scatter as wide as all samples together none is cut, and the sum of squares is smaller
    // than
    // expected.
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      if (within(values, errors, middle)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return at(values, errors, high);
  }

  /** Whether a scatter of this size explains how far the samples lie apart. */
  private static boolean within(double[] values, double[] errors, double scatter) {
    double mean = mean(values, errors, scatter);
    double squares = 0;
    for (int i = 0; i < values.length; i++) {
      double d = (values[i] - mean) / Math.hypot(errors[i], scatter);
      squares += Math.min(d * d, CUT * CUT);
    }
    return squares <= (values.length - 1) * EXPECTED;
  }

  private static HuberMean at(double[] values, double[] errors, double scatter) {
    double weights = 0;
    for (double error : errors) {
      weights += 1 / (error * error + scatter * scatter);
    }
    return new HuberMean(mean(values, errors, scatter), 1 / Math.sqrt(weights), scatter);
  }

  /** The mean by iterated reweighting, beginning with the weighted mean of all. */
  private static double mean(double[] values, double[] errors, double scatter) {
    double mean = Double.NaN;
    for (int step = 0; step < STEPS; step++) {
      double sum = 0;
      double weights = 0;
      for (int i = 0; i < values.length; i++) {
        double spread = Math.hypot(errors[i], scatter);
        double distance = step == 0 ? 0 : Math.abs(values[i] - mean) / spread;
        double weight = (distance > CUT ? CUT / distance : 1) / (spread * spread);
        sum += weight * values[i];
        weights += weight;
      }
      mean = sum / weights;
    }
    return mean;
  }

  private static double expected() {
    NormalDistribution normal = new NormalDistribution(null, 0, 1);
    double outside = 2 * normal.cumulativeProbability(-CUT);
    return 1 - outside - 2 * CUT * normal.density(CUT) + CUT * CUT * outside;
  }
}
