package fieldcal.effect.learned;

import fieldcal.effect.MeasurementEffect.Timing;
import fieldcal.effect.ObservedCamera;

/** A learned error of a camera's time stamps, over the session or the ball's speed. */
final class LearnedTimeError extends LearnedTerm implements Timing {
  private static final double SECONDS_PER_MS = 1e-3;

  private final int camera;
  private final boolean overSpeed;

  LearnedTimeError(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
    camera = family.camera().orElseThrow();
    overSpeed = dependsOn(Variable.SPEED);
  }

  @Override
  public LearnedTimeError withParameters(double... values) {
    return new LearnedTimeError(family(), values);
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public boolean dependsOnSpeed() {
    return overSpeed;
  }

  @Override
  public double timeError(
      ObservedCamera observer, double sessionTime, double pixelRow, double speed) {
    double u = overSpeed ? speed : sessionTime;
    return Double.isNaN(u) ? 0 : SECONDS_PER_MS * valueAt(0, u, 0);
  }
}
