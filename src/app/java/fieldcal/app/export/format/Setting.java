package fieldcal.app.export.format;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;

/**
 * A value that a file shall hold.
 *
 * @param path names of what it stands in, from the outside in, and its own
 * @param value the number in the file's unit
 * @param unit the file's unit; empty for a pure number
 * @param min the least value that the program takes, which some forms state beside the value; −∞ when there is none
 * @param max the largest; ∞ when there is none
 * @param whole whether the program takes whole numbers alone
 */
public record Setting(
    List<String> path, double value, String unit, double min, double max, boolean whole) {
  /** Parameters are known to four digits at best; two more keep rounding out of every comparison. */
  private static final MathContext DIGITS = new MathContext(6);

  /**
   * Copies the path. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the value is not finite
   */
  public Setting {
    path = List.copyOf(path);
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("value must be finite, but is " + value);
    }
  }

  /**
   * The value as a file holds it.
   *
   * @return a decimal number of six digits, without an exponent; with a decimal point, as every form takes it for a real number, or rounded to a whole number without one
   */
  public String text() {
    return whole ? String.valueOf(Math.round(value)) : text(value);
  }

  static String text(double value) {
    String text = new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString();
    return text.contains(".") ? text : text + ".0";
  }
}
