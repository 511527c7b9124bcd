package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect.Timing;
import fieldcal.effect.ObservedCamera;
import java.util.List;

/**
 * One camera's time stamps are late (+) by a constant: stamp = true time + ms. Those of the other cameras are taken to be right, so it is relative to them and not to a mean.
 *
 * @param ms lateness of the time stamps, ms; negative = early
 * @param camera which camera, by id
 */
public record CameraTimeOffset(double ms, int camera) implements Timing {
  private static final String ID = "camera_time_offset";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CameraTimeOffset {
    EffectParameters.requireFinite(ID, ms);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One camera's time stamps are late or early relative to the other cameras.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "ms",
            "ms",
            ms,
            1,
            -50,
            50,
            true,
            "phases of up to 6 ms between cameras in matches of 2026; design"),
        EffectParameters.camera(camera));
  }

  @Override
  public CameraTimeOffset withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new CameraTimeOffset(v[0], (int) v[1]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.hasSeveralCameras();
  }

  @Override
  public boolean isAbsent() {
    return ms == 0;
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public double timeError(
      ObservedCamera observer, double sessionTime, double pixelRow, double speed) {
    return 1e-3 * ms;
  }
}
