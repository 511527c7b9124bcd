package fieldcal.live;

import java.util.Locale;
import java.util.Objects;

/**
 * The ball no longer moves as published.
 *
 * @param parameter which parameter is off
 * @param time of the kick that showed it, Unix time, s
 * @param median of the newest samples, in the parameter's unit
 * @param published value, in the parameter's unit; NaN when a warning ends because none is published any more
 * @param samples how many kicks the median is from
 */
public record LiveWarning(
    BallParameter parameter, double time, double median, double published, int samples) {

  /**
   * Checks that the parameter is there. {@inheritDoc}
   *
   * @throws NullPointerException when the parameter is null
   */
  public LiveWarning {
    Objects.requireNonNull(parameter, "parameter");
  }

  /**
   * How far the median is off.
   *
   * @return as a part of the published value (–); positive when the median has the larger magnitude
   */
  public double deviation() {
    return median / published - 1;
  }

  /**
   * One sentence for the operator.
   *
   * @return for example {@code acc_roll is −0.364 m/s², 30 % more than the published −0.280 m/s² (median of 31 kicks)}
   */
  public String text() {
    String unit = parameter.unit().isEmpty() ? "" : " " + parameter.unit();
    if (Double.isNaN(published)) {
      return String.format(
          Locale.ROOT,
          "%s is %s%s, and nothing is published",
          parameter.id(),
          number(median),
          unit);
    }
    return String.format(
        Locale.ROOT,
        "%s is %s%s, %.0f %% %s than the published %s%s (median of %d kicks)",
        parameter.id(),
        number(median),
        unit,
        100 * Math.abs(deviation()),
        deviation() > 0 ? "more" : "less",
        number(published),
        unit,
        samples);
  }

  /** With a minus sign, not a hyphen. */
  private static String number(double value) {
    return String.format(Locale.ROOT, "%.3f", value).replace('-', '−');
  }

  /**
   * What to do about it.
   *
   * @return one sentence for the operator
   */
  public String advice() {
    if (Double.isNaN(published)) {
      return "Calibrate and publish a ball model.";
    }
    String unit = parameter.unit().isEmpty() ? "" : " " + parameter.unit();
    return String.format(
        Locale.ROOT,
        "Let the AI use %s%s until the ball is calibrated again on this carpet.",
        number(median),
        unit);
  }
}
