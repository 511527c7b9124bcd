package fieldcal.live;

import java.util.Arrays;
import java.util.List;

/**
 * When the ball no longer does what is published.
 *
 * <p>The rule of the league's teams is that the median of 31 samples is more than 20 % off. After a change of the carpet by 30 % that takes 16 to 21 samples, and only about half of a match's kicks are long
 * enough to show how the ball rolls. So a warning also begins when the median of the newest 15 is that far off and the step from the older ones cannot be scatter: 5 standard errors of the difference of both
 * medians, from the median deviation of each part. Measured as in {@link SampleTree}: samples until the warning (in 5 % more than) fall from 16 (17) to 8 (9) where samples scatter by 3 %, from 19 (23) to 11
 * (16) at 8 %, from 21 (27) to 15 (26) at 12 %. Series of 200 samples without a change that were warned about: none at 3 and 8 % of scatter; at 12 % 0.3 % where the model is as published and 0.7 % where it is 8 %
 * off. Four standard errors gain one sample. A warning ends when both medians are back.
 */
final class WarningRule {
  static final int NEWEST = 15;
  private static final double SIGNIFICANT = 5;

  /** Standard deviation of a Gaussian over the median of its absolute deviations. */
  private static final double NORMAL_MEDIAN = 1.4826;

  /** Standard error of a Gaussian's median over that of its mean. */
  private static final double MEDIAN_ERROR = 1.2533;

  private final LiveSettings settings;

  WarningRule(LiveSettings settings) {
    this.settings = settings;
  }

  /**
   * What the samples say.
   *
   * @param warn whether a warning is on now
   * @param median the median that says so
   * @param samples how many it is from
   */
  record Verdict(boolean warn, double median, int samples) {}

  Verdict judge(SampleTree tree, double published, boolean on) {
    Verdict all = new Verdict(false, tree.median(), tree.size());
    if (!tree.enough() || Double.isNaN(published)) {
      return all;
    }
    double limit = on ? settings.clearBelow() : settings.warnAbove();
    if (off(all.median, published) > limit) {
      return new Verdict(true, all.median, all.samples);
    }
    double newest = tree.newestMedian(NEWEST);
    boolean moved = off(newest, published) > limit;
    return moved && (on || isStep(tree, published)) ? new Verdict(true, newest, NEWEST) : all;
  }

  private static double off(double median, double published) {
    return Math.abs(median / published - 1);
  }

  private static boolean isStep(SampleTree tree, double published) {
    double newest = tree.newestMedian(NEWEST);
    double older = tree.olderMedian(NEWEST);
    List<BallSample> samples = tree.samples();
    int before = samples.size() - NEWEST;
    double[] deviations = new double[samples.size()];
    for (int i = 0; i < deviations.length; i++) {
      deviations[i] = Math.abs(samples.get(i).value() - (i < before ? older : newest));
    }
    double error = errorOfDifference(deviations, before, NEWEST);
    return Math.abs(newest - older) > SIGNIFICANT * error
        && off(newest, published) > off(older, published);
  }

  /** Standard error of the difference of the medians of two groups of samples, from all their deviations from their own median. */
  static double errorOfDifference(double[] deviations, int first, int second) {
    Arrays.sort(deviations);
    int n = deviations.length;
    double scatter = NORMAL_MEDIAN * 0.5 * (deviations[(n - 1) / 2] + deviations[n / 2]);
    return MEDIAN_ERROR * scatter * Math.sqrt(1.0 / first + 1.0 / second);
  }
}
