package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect.Timing;
import fieldcal.effect.ObservedCamera;
import java.util.List;

/**
 * A clock that gains: stamp = time·(1 + ppm·10⁻⁶), times since the beginning of the session, when the clock is right. The clocks of the other cameras are taken to be right all the time.
 *
 * @param ppm gain of the clock, 1e-6 (µs per s); positive = fast
 * @param camera which camera, by id
 */
public record ClockSkew(double ppm, int camera) implements Timing {
  private static final String ID = "clock_skew";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public ClockSkew {
    EffectParameters.requireFinite(ID, ppm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One camera's clock runs fast or slow.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "ppm",
            "ppm",
            ppm,
            50,
            -20000,
            20000,
            true,
            "free-running clocks of computers are off by up to 100 ppm"),
        EffectParameters.camera(camera));
  }

  @Override
  public ClockSkew withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new ClockSkew(v[0], (int) v[1]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.hasSeveralCameras();
  }

  @Override
  public boolean isAbsent() {
    return ppm == 0;
  }

  @Override
  public boolean changesWithTime() {
    return true;
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public double timeError(
      ObservedCamera observer, double sessionTime, double pixelRow, double speed) {
    // The stamp reads time·(1 + skew).
    double skew = 1e-6 * ppm;
    return sessionTime * skew / (1 + skew);
  }
}
