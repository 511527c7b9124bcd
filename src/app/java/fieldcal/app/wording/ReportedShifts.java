package fieldcal.app.wording;

import fieldcal.camera.Camera;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.ObservedCamera;
import fieldcal.kick.Observations;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** By how much an effect moves what cameras report of balls on the carpet, where they saw the ball. */
final class ReportedShifts {
  /** More places hardly change the result. */
  private static final int PLACES = 2000;

  private final List<ObservedCamera> observers;
  private final List<KickResiduals> kicks;

  private final double sessionStart;

  /** The session's begin is on the clock of the kicks, s. */
  ReportedShifts(
      Collection<ObservedCamera> observers, List<KickResiduals> kicks, double sessionStart) {
    this.observers = List.copyOf(observers);
    this.kicks = List.copyOf(kicks);
    this.sessionStart = sessionStart;
  }

  /**
   * The shift.
   *
   * @param typical root mean square over the places that it changes, mm
   * @param largest mm
   */
  record Shift(double typical, double largest) {}

  /** How many cameras look at the field; 0 when not known. */
  int cameras() {
    return observers.isEmpty() ? 0 : observers.get(0).cameraCount();
  }

  /** How high a camera, or the first of all, hangs, m; empty when not known. */
  OptionalDouble height(int camera) {
    return observers.stream()
        .filter(o -> camera == EffectParameters.ALL_CAMERAS || o.id() == camera)
        .flatMap(o -> o.camera().stream())
        .mapToDouble(Camera::positionZ)
        .findFirst();
  }

  /** The other one of two cameras. */
  Optional<Integer> otherCamera(int camera) {
    List<Integer> others =
        observers.stream().map(ObservedCamera::id).filter(id -> id != camera).toList();
    return others.size() == 1 ? Optional.of(others.get(0)) : Optional.empty();
  }

  /** Empty when no camera is known that saw a ball and is concerned. */
  Optional<Shift> of(Effect effect) {
    if (!(effect instanceof MeasurementEffect measurement)) {
      return Optional.empty();
    }
    MeasurementEffects with = MeasurementEffects.of(observers, List.of(measurement));
    MeasurementEffects without = MeasurementEffects.of(observers, List.of());
    long all = kicks.stream().mapToLong(k -> k.kick().observations().size()).sum();
    int step = (int) Math.max(1, all / PLACES);
    double sum = 0;
    double largest = 0;
    int count = 0;
    double[] a = new double[2];
    double[] b = new double[2];
    for (KickResiduals kick : kicks) {
      Observations o = kick.kick().observations();
      for (int i = 0; i < o.size(); i += step) {
        double[] ball = {o.x(i), o.y(i), 0};
        double stamp = o.time(i) - sessionStart;
        with.report(o.camera(i), stamp, ball, a);
        without.report(o.camera(i), stamp, ball, b);
        double squared = Math.pow(a[0] - b[0], 2) + Math.pow(a[1] - b[1], 2);
        if (squared > 0) {
          sum += squared;
          largest = Math.max(largest, squared);
          count++;
        }
      }
    }
    return count == 0
        ? Optional.empty()
        : Optional.of(new Shift(1000 * Math.sqrt(sum / count), 1000 * Math.sqrt(largest)));
  }
}
