package fieldcal.benchmark;

import java.util.Locale;
import org.apache.commons.math3.distribution.BetaDistribution;

/**
 * What a share of a number of drawn cases should be, judged with the error of so few: by its interval of 95 % (Clopper and Pearson 1934).
 *
 * @param limit share, 0 … 1
 * @param atLeast whether it is the lowest allowed; else the highest
 */
public record ShareGoal(double limit, boolean atLeast) {
  private static final double CONFIDENCE = 0.95;

  /**
   * At least that.
   *
   * @param limit lowest share allowed
   * @return the goal
   */
  public static ShareGoal atLeast(double limit) {
    return new ShareGoal(limit, true);
  }

  /**
   * At most that.
   *
   * @param limit highest share allowed
   * @return the goal
   */
  public static ShareGoal atMost(double limit) {
    return new ShareGoal(limit, false);
  }

  /**
   * The verdict on a count.
   *
   * @param count of cases
   * @param of how many
   * @return "met" or "NOT met" where so many cases decide it, else what the count alone says with "within its error"
   */
  public String verdict(int count, int of) {
    double[] range = range(count, of);
    boolean holds = atLeast ? count >= limit * of : count <= limit * of;
    if (holds) {
      boolean sure = atLeast ? range[0] >= limit : range[1] <= limit;
      return sure ? "met" : "met, within its error";
    }
    boolean excluded = atLeast ? range[1] < limit : range[0] > limit;
    return excluded ? "NOT met" : "NOT met, within its error";
  }

  /** The verdict on a count, for a table. */
  Findings.Verdict decide(int count, int of) {
    double[] range = range(count, of);
    if (of == 0) {
      return Findings.Verdict.OPEN;
    }
    if (atLeast ? range[0] >= limit : range[1] <= limit) {
      return Findings.Verdict.MET;
    }
    boolean excluded = atLeast ? range[1] < limit : range[0] > limit;
    return excluded ? Findings.Verdict.MISSED : Findings.Verdict.OPEN;
  }

  @Override
  public String toString() {
    String percent = String.format(Locale.ROOT, "%.1f", 100 * limit).replaceFirst("\\.0$", "");
    return (atLeast ? "≥ " : "≤ ") + percent + " %";
  }

  /** The shares that so few cases leave possible, 95 %. */
  static double[] range(int count, int of) {
    if (of == 0) {
      return new double[] {0, 1};
    }
    double tail = (1 - CONFIDENCE) / 2;
    return new double[] {
      count == 0
          ? 0
          : new BetaDistribution(count, of - count + 1).inverseCumulativeProbability(tail),
      count == of
          ? 1
          : new BetaDistribution(count + 1, of - count).inverseCumulativeProbability(1 - tail)
    };
  }

  /**
   * A line with the count, its interval, the goal and the verdict.
   *
   * @param what is counted
   * @param count of cases
   * @param of how many
   * @return the line
   */
  public String row(String what, int count, int of) {
    double[] range = range(count, of);
    return String.format(
        Locale.ROOT,
        "%-36s %4d of %4d  %5.1f %% (%.1f to %.1f)  %s %.0f %%  %s",
        what,
        count,
        of,
        of == 0 ? Double.NaN : 100.0 * count / of,
        100 * range[0],
        100 * range[1],
        atLeast ? "≥" : "≤",
        100 * limit,
        verdict(count, of));
  }
}
