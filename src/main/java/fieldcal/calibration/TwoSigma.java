package fieldcal.calibration;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;

/**
 * The 2σ rule: samples of one parameter that are more than two standard deviations from the mean are excluded; repeated
 * until none is.
 *
 * <p>A sample's standard deviation is that of its own fit and the scatter between kicks together, so that an imprecise sample is
 * not dropped for being imprecise. Of Gaussian samples 5 % are excluded in the first round.
 */
public final class TwoSigma {
  /** Fewer samples do not determine a scatter. */
  private static final int FEWEST = 4;

  /** Standard deviations beyond which a sample is excluded. */
  public static final double LIMIT = 2;

  private TwoSigma() {}

  /**
   * Applies the rule once.
   *
   * @param samples of one parameter
   * @return the same samples in the same order, those that are excluded with a reason
   */
  public static List<Sample> once(List<Sample> samples) {
    Average average = Average.of(samples);
    if (average.n() < FEWEST) {
      return samples;
    }
    List<Sample> next = new ArrayList<>();
    for (Sample s : samples) {
      double sigmas = average.sigmas(s);
      boolean leaves = s.dropped().isEmpty() && sigmas > LIMIT;
      next.add(leaves ? s.dropForItsValue(distance(s, sigmas)) : s);
    }
    return next;
  }

  /**
   * The same samples with reasons that refer to the final mean. The mean by which a sample was excluded changes with every further sample that is excluded.
   *
   * @param samples of one parameter, after all rounds
   * @return the same samples in the same order
   */
  public static List<Sample> restated(List<Sample> samples) {
    Average average = Average.of(samples).robust(samples);
    return samples.stream()
        .map(
            s ->
                s.leftForItsValue() && average.n() > 0
                    ? s.dropForItsValue(distance(s, average.sigmas(s)))
                    : s)
        .toList();
  }

  private static String distance(Sample s, double sigmas) {
    return sigmas > LIMIT
        ? String.format(Locale.ROOT, "%s is %.1f σ from the mean", s.fieldName(), sigmas)
        : s.fieldName() + " was excluded earlier; the mean has moved since";
  }

  /**
   * Applies the rule the given number of times, or fewer when no further sample is excluded.
   *
   * @param samples of one parameter
   * @param rounds 0 or more; empty for as many as it takes
   * @return the same samples in the same order, those that are excluded with a reason
   */
  public static List<Sample> rounds(List<Sample> samples, OptionalInt rounds) {
    if (rounds.isEmpty()) {
      return repeated(samples);
    }
    List<Sample> now = samples;
    for (int round = 0; round < rounds.getAsInt(); round++) {
      List<Sample> next = once(now);
      if (next.equals(now)) {
        return now;
      }
      now = next;
    }
    return now;
  }

  /**
   * Applies the rule until no further sample is excluded.
   *
   * @param samples of one parameter
   * @return the same samples in the same order, those that are excluded with a reason
   */
  public static List<Sample> repeated(List<Sample> samples) {
    List<Sample> now = samples;
    while (true) {
      List<Sample> next = once(now);
      if (next.equals(now)) {
        return now;
      }
      now = next;
    }
  }
}
