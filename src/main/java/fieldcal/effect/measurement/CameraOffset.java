package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.Sight;
import java.util.List;

/**
 * One camera's reports are shifted relative to the mean of all cameras: it by d, each of the n − 1 others by −d/(n − 1). A sole camera is shifted by d.
 *
 * @param xMm shift along x of the field, mm
 * @param yMm shift along y of the field, mm
 * @param camera which camera, by id
 */
public record CameraOffset(double xMm, double yMm, int camera) implements MeasurementEffect {
  private static final String ID = "camera_offset";
  private static final double MILLI = 1e-3;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CameraOffset {
    EffectParameters.requireFinite(ID, xMm, yMm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One camera reports every position shifted relative to the other cameras.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "x_mm",
            "mm",
            xMm,
            5,
            -500,
            500,
            true,
            "20 to 26 mm between cameras in matches of 2026; design"),
        new Parameter("y_mm", "mm", yMm, 5, -500, 500, true, "as x_mm"),
        EffectParameters.camera(camera));
  }

  @Override
  public boolean isAllowedForByCalibration() {
    return true;
  }

  @Override
  public CameraOffset withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 3);
    return new CameraOffset(v[0], v[1], (int) v[2]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.hasSeveralCameras();
  }

  @Override
  public boolean isAbsent() {
    return xMm == 0 && yMm == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("x_mm", "y_mm");
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return true;
  }

  @Override
  public void report(Sight sight) {
    int others = sight.camera().cameraCount() - 1;
    double share = sight.camera().id() == camera || others == 0 ? MILLI : -MILLI / others;
    sight.shiftReport(share * xMm, share * yMm);
  }
}
