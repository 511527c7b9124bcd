package fieldcal.app.wording;

import java.util.Locale;

/** How a clock of vision runs against that of the recorder. */
public final class ClockWords {
  private ClockWords() {}

  /**
   * By how much it runs too slow or too fast.
   *
   * @param rate seconds of the recorder's clock per second of vision's, positive
   * @return for example {@code runs 3.4 % slower than the recorder's}
   */
  public static String rate(double rate) {
    return String.format(
        Locale.ROOT,
        "runs %.1f %% %s than the recorder's",
        100 * Math.abs(1 / rate - 1),
        rate > 1 ? "slower" : "faster");
  }
}
