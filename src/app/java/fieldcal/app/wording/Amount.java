package fieldcal.app.wording;

import java.util.Locale;

/** Numbers as operators read them: with a true minus sign, and no more digits than they are worth. */
public final class Amount {
  private static final int MOST_DECIMALS = 5;

  private Amount() {}

  /**
   * A number for a sentence: whole from 10 on, one decimal from 1 on, else two digits.
   *
   * @param value any number
   * @return for example "21", "4.2", "0.35"; a dash for one that is not finite
   */
  public static String of(double value) {
    double size = Math.abs(value);
    if (size == 0 || !Double.isFinite(size)) {
      return decimals(value, 0);
    }
    int places = (int) Math.floor(Math.log10(size));
    return decimals(value, Math.max(0, Math.min(MOST_DECIMALS, 1 - places)));
  }

  /**
   * A number with its standard error, which has two digits when it begins with 1 to 3, else one.
   *
   * @param value any number
   * @param error NaN when unknown
   * @return for example "21.3 ± 0.4"
   */
  public static String withError(double value, double error) {
    if (!(error > 0) || Double.isInfinite(error)) {
      return of(value);
    }
    int places = (int) -Math.floor(Math.log10(error));
    int digits = error * Math.pow(10, places) < 3.55 ? places + 1 : places;
    int shown = Math.max(0, Math.min(MOST_DECIMALS, digits));
    return decimals(value, shown) + " ± " + decimals(error, shown);
  }

  /**
   * The minus signs of formatted numbers as they are printed for people.
   *
   * @param text with hyphens for minus signs, and for nothing else
   * @return with minus signs
   */
  public static String minus(String text) {
    return text.replace('-', '−');
  }

  /**
   * A number with so many decimals.
   *
   * @param value any number
   * @param digits 0 or more
   * @return the text; a dash for one that is not finite
   */
  public static String decimals(double value, int digits) {
    if (!Double.isFinite(value)) {
      return "–";
    }
    String text = String.format(Locale.ROOT, "%." + digits + "f", value);
    return text.matches("-0(\\.0*)?") ? text.substring(1) : minus(text);
  }
}
