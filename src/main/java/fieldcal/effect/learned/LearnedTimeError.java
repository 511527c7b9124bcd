package fieldcal.effect.learned;

import fieldcal.effect.MeasurementEffect.Timing;
import fieldcal.effect.ObservedCamera;

/** A learned error of a camera's time stamps over the session. */
final class LearnedTimeError extends LearnedTerm implements Timing {
  private static final double SECONDS_PER_MS = 1e-3;

  private final int camera;

  LearnedTimeError(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
    camera = family.camera().orElseThrow();
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
  public double timeError(ObservedCamera observer, double sessionTime, double pixelRow) {
    return SECONDS_PER_MS * valueAt(0, sessionTime, 0);
  }
}
