package fieldcal.effect;

import fieldcal.camera.Camera;
import fieldcal.effect.MeasurementEffect.Displacement;
import fieldcal.effect.MeasurementEffect.Refraction;
import fieldcal.effect.MeasurementEffect.Timing;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * How one camera reports balls under the effects that concern it. What is the same for every ball is computed once: fits ask for hundreds of millions of
 * reports. Immutable.
 */
final class View {
  private static final double[] UNTURNED = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  final int id;
  private final ObservedCamera observer;
  private final Camera camera;
  private final MeasurementEffect[] effects;
  private final Timing[] timings;
  private final boolean dependsOnSpeed;
  private final Refraction[] refractions;
  private final Displacement[] displacements;

  /** Where vision believes the camera to be, m. */
  private double believedX;

  private double believedY;
  private double believedZ;

  /** True position, m; the ray's turn by rows, null when it is not turned; height of the plane, m; what is added, m. */
  private double x;

  private double y;
  private double z;
  private double[] turn;
  private double plane;
  private double addedX;
  private double addedY;

  View(ObservedCamera observer, List<? extends MeasurementEffect> all) {
    this(observer, concerning(observer, all));
  }

  private View(ObservedCamera observer, MeasurementEffect[] effects) {
    this.observer = observer;
    this.effects = effects;
    id = observer.id();
    camera = observer.camera().orElse(null);
    List<Timing> late = new ArrayList<>(1);
    List<Refraction> bending = new ArrayList<>(1);
    List<Displacement> displacing = new ArrayList<>(1);
    for (MeasurementEffect e : effects) {
      if (e instanceof Timing timing) {
        late.add(timing);
      }
      if (e instanceof Refraction refraction) {
        bending.add(refraction);
      }
      if (e instanceof Displacement displacement) {
        displacing.add(displacement);
      }
    }
    timings = late.toArray(Timing[]::new);
    dependsOnSpeed = late.stream().anyMatch(Timing::dependsOnSpeed);
    refractions = bending.toArray(Refraction[]::new);
    displacements = displacing.toArray(Displacement[]::new);
    prepare(new Sight(observer));
  }

  private static MeasurementEffect[] concerning(
      ObservedCamera observer, List<? extends MeasurementEffect> all) {
    return all.stream()
        .filter(e -> !e.isAbsent() && e.isApplicable(observer) && e.concerns(observer))
        .toArray(MeasurementEffect[]::new);
  }

  /** The same camera under other effects; this where none of those that concern it differs. */
  View under(List<? extends MeasurementEffect> others) {
    MeasurementEffect[] now = concerning(observer, others);
    return Arrays.equals(now, effects) ? this : new View(observer, now);
  }

  private void prepare(Sight sight) {
    for (MeasurementEffect effect : effects) {
      effect.moveCamera(sight);
      effect.report(sight);
    }
    x = sight.cameraX();
    y = sight.cameraY();
    z = sight.cameraZ();
    believedX = sight.believedX();
    believedY = sight.believedY();
    believedZ = sight.believedZ();
    plane = sight.plane();
    addedX = sight.offsetX();
    addedY = sight.offsetY();
    double[] turned = new double[9];
    for (int axis = 0; axis < 3; axis++) {
      sight.turnRay(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
      for (MeasurementEffect effect : effects) {
        effect.turnRay(sight);
      }
      turned[axis] = sight.rayX();
      turned[3 + axis] = sight.rayY();
      turned[6 + axis] = sight.rayZ();
    }
    turn = Arrays.equals(turned, UNTURNED) ? null : turned;
  }

  double timeError(double stamp, double pixelRow, double speed) {
    double error = 0;
    for (Timing effect : timings) {
      error += effect.timeError(observer, stamp, pixelRow, speed);
    }
    return error;
  }

  /** Whether the error of the time stamps depends on the ball's speed. */
  boolean dependsOnSpeed() {
    return dependsOnSpeed;
  }

  /** Whether the time stamps have an error. */
  boolean isLate() {
    return timings.length > 0;
  }

  /** Whether the time stamps have the same error. */
  boolean isAsLateAs(View other) {
    return Arrays.equals(timings, other.timings);
  }

  /** Where a ball is reported: x and y into two places of {@code ground} from {@code at} on; the stamp since the beginning of the session, s, NaN = unknown. */
  void report(double ballX, double ballY, double ballZ, double stamp, double[] ground, int at) {
    project(ballX, ballY, ballZ, ground, at);
    if (displacements.length > 0) {
      double reportedX = ground[at];
      double reportedY = ground[at + 1];
      for (Displacement effect : displacements) {
        effect.displace(observer, reportedX, reportedY, stamp, ground, at);
      }
    }
  }

  /**
   * By how much a report moves with the ball's height, from how it moves over the ground: nothing is reported of a move along the line of sight.
   *
   * @param ball x, y and height of the ball, m, from {@code from} on
   * @param slopes by how much reported x moves with the ball's x and y, then the same of reported y, each followed by the height's, which is filled in
   */
  void addSlopesByHeight(double[] ball, int from, double[] slopes, int at) {
    if (camera == null) {
      return;
    }
    double up = ball[from + 2] + Camera.BALL_RADIUS - z;
    double alongX = (ball[from] - x) / up;
    double alongY = (ball[from + 1] - y) / up;
    slopes[at + 2] = -(slopes[at] * alongX + slopes[at + 1] * alongY);
    slopes[at + 5] = -(slopes[at + 3] * alongX + slopes[at + 4] * alongY);
  }

  private void project(double ballX, double ballY, double ballZ, double[] ground, int at) {
    if (camera == null) {
      ground[at] = ballX + addedX;
      ground[at + 1] = ballY + addedY;
      return;
    }
    double rayX = ballX - x;
    double rayY = ballY - y;
    double rayZ = ballZ + Camera.BALL_RADIUS - z;
    if (turn != null) {
      double[] m = turn;
      double straightX = rayX;
      double straightY = rayY;
      double straightZ = rayZ;
      rayX = m[0] * straightX + m[1] * straightY + m[2] * straightZ;
      rayY = m[3] * straightX + m[4] * straightY + m[5] * straightZ;
      rayZ = m[6] * straightX + m[7] * straightY + m[8] * straightZ;
    }
    if (refractions.length > 0) {
      Sight sight = new Sight(observer);
      sight.turnRay(rayX, rayY, rayZ);
      for (Refraction effect : refractions) {
        effect.refractRay(sight);
      }
      rayX = sight.rayX();
      rayY = sight.rayY();
      rayZ = sight.rayZ();
    }
    // The ray, drawn from the believed position, meets the plane.
    double way = rayZ < 0 ? (plane - believedZ) / rayZ : Double.NaN;
    ground[at] = believedX + way * rayX + addedX;
    ground[at + 1] = believedY + way * rayY + addedY;
  }
}
