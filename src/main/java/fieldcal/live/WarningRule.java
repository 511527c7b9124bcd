package fieldcal.live;

import java.util.Arrays;

/**
 * Decides when the ball no longer moves as published.
 *
 * <p>The rule of the league's teams is that the median of 31 samples is more than 20 % off. After a change of the carpet by 30 % that takes 16 to 21 samples, and only about half of a match's kicks are long
 * enough to show how the ball rolls. So a warning also begins when the median of the newest 15 is that far off and the step from the older ones cannot be due to scatter: 5 standard errors of the difference of both
 * medians, from the median deviation of each part. Measured as in {@link SampleTree}: samples until the warning (in 5 % more than) fall from 16 (17) to 8 (9) where samples scatter by 3 %, from 19 (23) to 11
 * (16) at 8 %, from 21 (27) to 15 (26) at 12 %. Series of 200 samples without a change that were warned about: none at 3 and 8 % of scatter; at 12 % 0.3 % where the model is as published and 0.7 % where it is 8 %
 * off. Four standard errors gain one sample.
 *
 * <p>On real carpets most of that scatter of accRoll is not random: the faster the ball rolls, the more it is braked, and kicks differ in speed. So the step is looked for in samples as they would be at the speed that is
 * usual in this match ({@link EqualSpeeds}, {@link UsualSpeed}), and the median of all must be 20 % off at that speed, too: who happens to pass faster than usual has not changed the carpet. Measured on twelve matches
 * each on the simulated carpets of two tournaments of 2026, where a rolling ball is braked 30 % more from half time on: 10 … 21 and 9 … 22 kicks until the warning, and none before ({@code ./gradlew benchmark
 * -PbenchmarkArgs="live-carpets --runs 6"}). Of series of 150 samples whose model is 10 % off, and whose balls
 * roll at 1 to 3 m/s, 6 % are warned about instead of 48 %.
 *
 * <p>Before there are 31 samples, a warning begins as soon as those that there are prove that the parameter is more than 20 % off ({@link EarlyProof}). The limit for such warnings is a budget of false alarms, not a number of samples: in
 * {@link LiveSettings#falseWarnings} of the matches, at most, one begins though no parameter is more than 20 % off, where the worst case is that all of them are off by just that. The budget is divided among the parameters and the two signs of a deviation.
 *
 * <p>A warning ends when all these medians are back below another limit, by two standard errors where samples scatter much, so that a parameter near the limit does not flicker.
 */
final class WarningRule {
  static final int NEWEST = 15;
  private static final double SIGNIFICANT = 5;

  /** Number of standard errors of its median by which a parameter must have come back before a warning ends. */
  private static final double BACK = 2;

  /** Standard deviation of a Gaussian over the median of its absolute deviations. */
  private static final double NORMAL_MEDIAN = 1.4826;

  /** Standard error of a Gaussian's median over that of its mean. */
  static final double MEDIAN_ERROR = 1.2533;

  /** Signs of a deviation: a parameter may be too large or too small. */
  private static final int SIGNS = 2;

  private final LiveSettings settings;
  private final EarlyProof proof;

  WarningRule(LiveSettings settings) {
    this.settings = settings;
    proof = new EarlyProof(settings.falseWarnings() / (SIGNS * BallParameter.values().length));
  }

  /**
   * What the samples say.
   *
   * @param warn whether a warning is active now
   * @param median the median that says so
   * @param samples how many it is from
   */
  record Verdict(boolean warn, double median, int samples) {}

  /** Judges the samples of a tree, of which {@code usual} is the squared speed that balls usually have, m²/s²; NaN where none is known. */
  Verdict judge(SampleTree tree, double usual, double published, boolean on) {
    Verdict all = new Verdict(false, tree.median(), tree.size());
    if (Double.isNaN(published)) {
      return all;
    }
    if (!tree.enough()) {
      boolean early =
          on ? off(all.median, published) > settings.clearBelow() : proves(tree, published);
      return new Verdict(early, all.median, all.samples);
    }
    EqualSpeeds parts = new EqualSpeeds(tree.samples(), tree.size() - NEWEST, usual);
    double limit = on ? end(parts, published) : settings.warnAbove();
    boolean asTheyWere = off(all.median, published) > limit;
    boolean atUsualSpeed = off(parts.median(), published) > limit;
    if (on ? asTheyWere || atUsualSpeed : asTheyWere && atUsualSpeed) {
      return new Verdict(true, all.median, all.samples);
    }
    double newest = parts.medianOfNewer();
    boolean moved = off(newest, published) > limit;
    return moved && (on || isStep(parts, published)) ? new Verdict(true, newest, NEWEST) : all;
  }

  private static double off(double median, double published) {
    return Math.abs(median / published - 1);
  }

  /** Whether fewer samples than a median needs prove that the parameter is too far off. */
  private boolean proves(SampleTree tree, double published) {
    double off = tree.median() / published - 1;
    if (!(Math.abs(off) > settings.warnAbove())) {
      return false;
    }
    double[] beyond =
        tree.samples().stream()
            .mapToDouble(s -> Math.signum(off) * (s.value() / published - 1) - settings.warnAbove())
            .toArray();
    double variance =
        tree.samples().stream()
            .mapToDouble(s -> s.standardError() / published)
            .map(e -> e * e)
            .average()
            .orElseThrow();
    return proof.isAboveZero(beyond, Math.sqrt(variance));
  }

  /** The deviation below which a warning ends. */
  private double end(EqualSpeeds parts, double published) {
    double back = settings.warnAbove() - BACK * parts.errorOfMedian() / Math.abs(published);
    return Math.min(settings.clearBelow(), Math.max(0.5 * settings.warnAbove(), back));
  }

  private static boolean isStep(EqualSpeeds parts, double published) {
    double newest = parts.medianOfNewer();
    double older = parts.medianOfOlder();
    return Math.abs(newest - older) > SIGNIFICANT * parts.errorOfStep()
        && off(newest, published) > off(older, published);
  }

  /** Standard deviation of a Gaussian whose deviations from the median these are; they are sorted. */
  static double scatter(double[] deviations) {
    Arrays.sort(deviations);
    int n = deviations.length;
    return NORMAL_MEDIAN * 0.5 * (deviations[(n - 1) / 2] + deviations[n / 2]);
  }

  /** Standard error of the difference of the medians of two groups of samples that scatter alike. */
  static double errorOfDifference(double scatter, int first, int second) {
    return MEDIAN_ERROR * scatter * Math.sqrt(1.0 / first + 1.0 / second);
  }
}
