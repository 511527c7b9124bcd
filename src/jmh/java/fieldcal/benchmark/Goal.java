package fieldcal.benchmark;

import java.util.Locale;

/**
 * What a measured number should be: within an interval, one end of which may be infinite.
 *
 * @param lowest allowed
 * @param highest allowed
 * @param format of the ends, as for {@link String#format}
 */
public record Goal(double lowest, double highest, String format) {

  /** Column heading that goes with {@link #verdict}. */
  public static final String VERDICT = "verdict";

  /**
   * At most that.
   *
   * @param limit highest value allowed
   * @param format of the limit
   * @return the goal
   */
  public static Goal atMost(double limit, String format) {
    return new Goal(Double.NEGATIVE_INFINITY, limit, format);
  }

  /**
   * At least that.
   *
   * @param limit lowest value allowed
   * @param format of the limit
   * @return the goal
   */
  public static Goal atLeast(double limit, String format) {
    return new Goal(limit, Double.POSITIVE_INFINITY, format);
  }

  /**
   * Whether a value is what it should be.
   *
   * @param value measured; NaN meets no goal
   * @return true within the interval
   */
  public boolean met(double value) {
    return value >= lowest && value <= highest;
  }

  /**
   * The verdict on one value.
   *
   * @param value measured
   * @return "met" or "NOT met"
   */
  public String verdict(double value) {
    return verdict(met(value));
  }

  /**
   * The verdict on several values together.
   *
   * @param met whether all goals are
   * @return "met" or "NOT met"
   */
  public static String verdict(boolean met) {
    return met ? "met" : "NOT met";
  }

  @Override
  public String toString() {
    if (Double.isInfinite(lowest)) {
      return "≤ " + end(highest);
    }
    return Double.isInfinite(highest) ? "≥ " + end(lowest) : end(lowest) + "–" + end(highest);
  }

  private String end(double value) {
    return String.format(Locale.ROOT, format, value);
  }
}
