package fieldcal.fit;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A value on which several samples agree within their own errors, while the others scatter: for example kicks without spin among kicks that each have a different spin.
 *
 * <p>Two descriptions are compared by their likelihoods: either all samples scatter about one mean (normally, in addition to their own errors), or a part of them has one value and only the others scatter. The second is a mixture whose likelihood is
 * maximised by expectation and maximisation (Dempster, Laird and Rubin 1977). How much more likely it must be was measured on samples that scatter about one mean ({@code AgreementTest}), since a mixture's likelihood ratio has no chi-square distribution. Immutable and thread-safe.
 *
 * @param value on which they agree, in the unit of the samples
 * @param share of the samples that agree, 0 to 1
 * @param others mean of the others, in the unit of the samples
 * @param othersAgree whether the others are a group of their own, far from the first, neither much smaller nor determined much worse, so that it is not determined which of the two groups is meant
 */
public record Agreement(double value, double share, double others, boolean othersAgree) {
  /** Least expected number of samples that agree (the sum of their probabilities), so half a sample less than three: two may agree by chance, however small their errors are. */
  private static final double FEWEST_AGREEING = 2.5;

  /** Fewer samples do not show two groups. */
  static final int FEWEST = 6;

  /** By how much twice the logarithm of the likelihood must grow; of sets of 6 to 48 samples about one mean, 1 to 7 in 100 reach this (AgreementTest). */
  static final double AHEAD = 10;

  /** Two groups whose centres lie this many times their scatter apart do not overlap: one of 16 000 normal samples lies farther from its mean. */
  private static final double APART = 4;

  /** A group that has a smaller share of the samples is one of outliers, chosen: the 2σ rule excludes a group of less than a fifth, and mostly one of a quarter. */
  private static final double LEAST_SIDE = 0.3;

  /** Others whose errors are this many times as large are not a second group but are drawn to one side by what the model lacks, chosen: slow kicks hardly determine a sliding deceleration. */
  private static final double WORSE_DETERMINED = 3;

  /** Steps of expectation and maximisation, chosen: a search that has not converged has too small a likelihood, so that fewer agreements are found, never more. */
  private static final int STEPS = 50;

  /** Number of samples from which the search starts: those with which the others agree most. */
  private static final int STARTS = 5;

  /** Shares that begin with 0 or 1 stay there. */
  private static final double LEAST_SHARE = 0.02;

  /**
   * Looks for a value on which several samples agree.
   *
   * @param values the samples
   * @param errors their standard errors, positive and finite; same length
   * @return what several agree on; empty where one scatter about one mean explains the samples about as well
   */
  public static Optional<Agreement> of(double[] values, double[] errors) {
    if (values.length < FEWEST) {
      return Optional.empty();
    }
    Mixture best = best(values, errors);
    boolean ahead = 2 * (best.logLikelihood - alone(values, errors)) > AHEAD;
    return ahead && best.share * values.length > FEWEST_AGREEING
        ? Optional.of(best.agreement())
        : Optional.empty();
  }

  private static Mixture best(double[] values, double[] errors) {
    Mixture best = null;
    int[] starts =
        IntStream.range(0, values.length)
            .boxed()
            .sorted(Comparator.comparingDouble(i -> -neighbours(values, errors, i)))
            .limit(STARTS)
            .mapToInt(i -> i)
            .toArray();
    for (int start : starts) {
      Mixture mixture = new Mixture(values, errors, values[start]);
      for (int step = 0; step < STEPS; step++) {
        mixture.step();
      }
      if (best == null || mixture.logLikelihood > best.logLikelihood) {
        best = mixture;
      }
    }
    return best;
  }

  /** How much better the value of sample {@code i} explains the others than the scatter of all does. */
  private static double neighbours(double[] values, double[] errors, int i) {
    double spread = spread(values);
    double gain = 0;
    for (int j = 0; j < values.length; j++) {
      double variance = errors[i] * errors[i] + errors[j] * errors[j];
      double near = logDensity(values[j] - values[i], variance);
      double far = logDensity(values[j] - values[i], variance + spread * spread);
      gain += Math.max(0, near - far);
    }
    return gain;
  }

  /** The largest log likelihood of one normal scatter in addition to the errors, by golden section: as a function of the scatter it has one maximum between zero and twice the spread of the samples. */
  private static double alone(double[] values, double[] errors) {
    double golden = (Math.sqrt(5) - 1) / 2;
    double low = 0;
    double high = 2 * spread(values);
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double ofA = alone(values, errors, a);
    double ofB = alone(values, errors, b);
    for (int step = 0; step < 40; step++) {
      if (ofA > ofB) {
        high = b;
        b = a;
        ofB = ofA;
        a = high - golden * (high - low);
        ofA = alone(values, errors, a);
      } else {
        low = a;
        a = b;
        ofA = ofB;
        b = low + golden * (high - low);
        ofB = alone(values, errors, b);
      }
    }
    return Math.max(alone(values, errors, 0), Math.max(ofA, ofB));
  }

  private static double alone(double[] values, double[] errors, double scatter) {
    double weights = 0;
    double mean = 0;
    for (int i = 0; i < values.length; i++) {
      double weight = 1 / (errors[i] * errors[i] + scatter * scatter);
      weights += weight;
      mean += weight * values[i];
    }
    mean /= weights;
    double sum = 0;
    for (int i = 0; i < values.length; i++) {
      sum += logDensity(values[i] - mean, errors[i] * errors[i] + scatter * scatter);
    }
    return sum;
  }

  /** Standard deviation of the samples. */
  private static double spread(double[] values) {
    double mean = IntStream.range(0, values.length).mapToDouble(i -> values[i]).average().orElse(0);
    double squares = 0;
    for (double value : values) {
      squares += (value - mean) * (value - mean);
    }
    return Math.sqrt(squares / values.length);
  }

  /** Logarithm of the density of a normal distribution, up to a constant. */
  private static double logDensity(double distance, double variance) {
    return -0.5 * (Math.log(variance) + distance * distance / variance);
  }

  /** A part of the samples has one value, the others scatter about a mean of their own. */
  private static final class Mixture {
    private final double[] values;
    private final double[] errors;
    private final double[] agrees;
    private double share;
    private double agreed;
    private double mean;
    private double scatter;
    private double logLikelihood;

    Mixture(double[] values, double[] errors, double start) {
      this.values = values;
      this.errors = errors;
      agrees = new double[values.length];
      agreed = start;
      scatter = spread(values);
      for (int i = 0; i < values.length; i++) {
        // Twice the error, since the start has one as well.
        double sigmas = (values[i] - start) / (2 * errors[i]);
        agrees[i] =
            Math.max(LEAST_SHARE, Math.min(1 - LEAST_SHARE, Math.exp(-sigmas * sigmas / 2)));
      }
    }

    void step() {
      double together = 0;
      double precision = 0;
      double sum = 0;
      double othersPrecision = 0;
      double othersSum = 0;
      for (int i = 0; i < values.length; i++) {
        double own = errors[i] * errors[i];
        together += agrees[i];
        precision += agrees[i] / own;
        sum += agrees[i] / own * values[i];
        double weight = (1 - agrees[i]) / (own + scatter * scatter);
        othersPrecision += weight;
        othersSum += weight * values[i];
      }
      share = Math.max(1e-3, Math.min(1 - 1e-3, together / values.length));
      agreed = precision > 0 ? sum / precision : agreed;
      mean = othersPrecision > 0 ? othersSum / othersPrecision : mean;
      scatter = scatterOfOthers();
      logLikelihood = 0;
      for (int i = 0; i < values.length; i++) {
        double own = errors[i] * errors[i];
        double one = Math.log(share) + logDensity(values[i] - agreed, own);
        double other = Math.log(1 - share) + logDensity(values[i] - mean, own + scatter * scatter);
        double larger = Math.max(one, other);
        double both = larger + Math.log(Math.exp(one - larger) + Math.exp(other - larger));
        agrees[i] = Math.exp(one - both);
        logLikelihood += both;
      }
    }

    Agreement agreement() {
      boolean several = 1 - share > LEAST_SIDE && (1 - share) * values.length > FEWEST_AGREEING;
      boolean apart = APART * scatter < Math.abs(mean - agreed);
      boolean alike = medianError(false) < WORSE_DETERMINED * medianError(true);
      return new Agreement(agreed, share, mean, several && apart && alike);
    }

    /** Median error of the samples that are more likely to agree, or of the others; infinite without any. */
    private double medianError(boolean agreeing) {
      double[] sorted =
          IntStream.range(0, errors.length)
              .filter(i -> agrees[i] > 0.5 == agreeing)
              .mapToDouble(i -> errors[i])
              .sorted()
              .toArray();
      return sorted.length == 0 ? Double.POSITIVE_INFINITY : sorted[sorted.length / 2];
    }

    /** Scatter of the others about their mean beyond what their own errors explain. */
    private double scatterOfOthers() {
      double squares = 0;
      double weights = 0;
      for (int i = 0; i < values.length; i++) {
        double own = errors[i] * errors[i];
        double variance = scatter * scatter;
        double shrunk = variance / (own + variance);
        double deviation = shrunk * (values[i] - mean);
        squares += (1 - agrees[i]) * (deviation * deviation + shrunk * own);
        weights += 1 - agrees[i];
      }
      return weights > 0 ? Math.sqrt(squares / weights) : scatter;
    }
  }
}
