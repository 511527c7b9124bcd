package fieldcal.effect.learned;

import fieldcal.camera.Camera;
import fieldcal.effect.MeasurementEffect.Displacement;
import fieldcal.effect.ObservedCamera;

/** A learned error of the position that a camera reports, over the place below it or the session time. */
final class LearnedShift extends LearnedTerm implements Displacement {
  private static final double METRES_PER_MM = 1e-3;

  private final int camera;
  private final boolean overPlace;

  LearnedShift(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
    camera = family.camera().orElseThrow();
    overPlace = dependsOn(Variable.IMAGE_POSITION);
  }

  @Override
  public LearnedShift withParameters(double... values) {
    return new LearnedShift(family(), values);
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return !overPlace || observer.camera().isPresent();
  }

  @Override
  public void displace(
      ObservedCamera observer, double x, double y, double sessionTime, double[] ground, int at) {
    double u = sessionTime;
    double v = 0;
    if (overPlace) {
      Camera below = observer.camera().orElseThrow();
      u = x - below.positionX();
      v = y - below.positionY();
    } else if (Double.isNaN(sessionTime)) {
      return;
    }
    ground[at] += METRES_PER_MM * valueAt(0, u, v);
    ground[at + 1] += METRES_PER_MM * valueAt(1, u, v);
  }
}
