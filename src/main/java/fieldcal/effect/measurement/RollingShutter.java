package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect.Timing;
import fieldcal.effect.ObservedCamera;
import java.util.List;

/**
 * The exposure moves from the first to the last image row within a given time, in all cameras; time stamps are those of the first row. So the ball was where it is reported at stamp + ms·row/rows, with the detection's row (0 = first, at the top of the image) and the
 * height of the image. A detection without pixels counts as first row.
 *
 * @param ms time from the first to the last row, ms; negative = exposed from the last row on, stamps still the first row's
 */
public record RollingShutter(double ms) implements Timing {
  private static final String ID = "rolling_shutter";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public RollingShutter {
    EffectParameters.requireFinite(ID, ms);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The cameras expose their image rows one after another, so a ball low in the image is"
        + " seen later.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "ms", "ms", ms, 2, -30, 30, true, "read-out of CMOS sensors takes 5 to 15 ms"));
  }

  @Override
  public RollingShutter withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new RollingShutter(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return ms == 0;
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return true;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return observer.imageHeight() > 0;
  }

  @Override
  public double timeError(
      ObservedCamera observer, double sessionTime, double pixelRow, double speed) {
    // Of a detection without pixels nothing is known.
    double row = pixelRow > 0 ? Math.min(1, pixelRow / observer.imageHeight()) : 0;
    return -1e-3 * ms * row;
  }
}
