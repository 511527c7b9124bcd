package fieldcal.app.cli;

import java.util.Locale;

/** Ranges of numbers that options take, with errors that name the option as it was typed, in its own unit. */
final class OptionRange {
  private OptionRange() {}

  /**
   * Checks a number.
   *
   * @param option its name, for example {@code --margin}
   * @param value in the option's unit; null when it was not given
   * @param min smallest one, in the same unit
   * @param max largest one, in the same unit
   * @param unit for example {@code " m"}; empty for a plain number
   * @throws IllegalArgumentException if the value is out of range or NaN
   */
  static void check(String option, Number value, double min, double max, String unit) {
    if (value != null && !(value.doubleValue() >= min && value.doubleValue() <= max)) {
      throw new IllegalArgumentException(
          option
              + " must be "
              + plain(min)
              + " to "
              + plain(max)
              + unit
              + ", but is "
              + plain(value.doubleValue()));
    }
  }

  /**
   * Checks that a number is positive.
   *
   * @param option its name
   * @param value null when it was not given
   * @throws IllegalArgumentException if the value is zero, negative or NaN
   */
  static void positive(String option, Number value) {
    if (value != null && !(value.doubleValue() > 0)) {
      throw new IllegalArgumentException(
          option + " must be a positive number, but is " + plain(value.doubleValue()));
    }
  }

  private static String plain(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : Double.toString(value);
  }
}
