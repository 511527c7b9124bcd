package fieldcal.fit.joint;

import java.util.Arrays;

/**
 * What the bounds of a kick's own parameters mean for a step (active set; Nocedal and Wright, "Numerical optimization", chapter 16): one that is on a bound and would go beyond stays, one that would cross a bound goes up to it. Where steps were only cut off, the other parameters would
 * make up for a way that is not gone, and one kick on a bound would keep all the others from moving. A kick that is fitted alone keeps nobody, and comes off a bound more easily when its steps are only cut off.
 */
final class OwnBounds {
  /** How often a step is computed again because other parameters would now cross a bound. */
  static final int ROUNDS = 3;

  private OwnBounds() {}

  /**
   * The steps that are given from the beginning.
   *
   * @param own where the kick is
   * @param slope downhill, of each own parameter
   * @return 0 for each that is on a bound and would go beyond it, NaN for the others
   */
  static double[] given(KickTerm<?> term, double[] own, double[] slope) {
    double[] given = new double[own.length];
    Arrays.fill(given, Double.NaN);
    double[] moved = own.clone();
    for (int i = 0; i < given.length; i++) {
      moved[i] = slope[i] > 0 ? Math.nextUp(own[i]) : Math.nextDown(own[i]);
      term.clamp(moved);
      if (slope[i] != 0 && moved[i] == own[i]) {
        given[i] = 0;
      }
      moved[i] = own[i];
    }
    return given;
  }

  /**
   * Gives what crosses a bound the step up to it.
   *
   * @param own where the kick is
   * @param step that it would make
   * @param given changed in place
   * @return whether there was any
   */
  static boolean cut(KickTerm<?> term, double[] own, double[] step, double[] given) {
    double[] next = new double[own.length];
    for (int i = 0; i < next.length; i++) {
      next[i] = own[i] + step[i];
    }
    double[] within = next.clone();
    term.clamp(within);
    boolean any = false;
    for (int i = 0; i < next.length; i++) {
      if (within[i] != next[i] && Double.isNaN(given[i])) {
        given[i] = within[i] - own[i];
        any = true;
      }
    }
    return any;
  }
}
