package fieldcal.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.camera.Camera;
import fieldcal.effect.Sightings;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import fieldcal.fit.Whitening;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;

/** The observations of one kick as the joint fits need them: as reported, whitened, without detections of something else. Immutable. */
final class KickData {
  /** Without rest before the kick its time is known from where two lines cross only, s. */
  static final double TIME_PRIOR = 0.004;

  /** A fitted start that far from where the ball lay lost the rest, m; cameras disagree by less. */
  private static final double LOST_REST = 0.1;

  /** Detections from which on they tell where a ball lay. */
  static final int LEAST_REST = 3;

  final Kick kick;
  final KickKind kind;

  /** Where the kick's own fit ended, cameras' offsets taken out: position, velocity, time. */
  final double[] start;

  final int flights;
  final int size;
  final double[] time;
  final double[] x;
  final double[] y;
  final double[] row;
  final int[] camera;
  final double[] cameraHeight;
  final double[] w11;
  final double[] w21;
  final double[] w22;
  final Sightings sightings;
  final boolean[] used;
  final int usedCount;

  /** Whether detections of the resting ball pin where the kick begins. */
  final boolean fromRest;

  /** The same kick with all detections that its own fit used. */
  final KickData whole;

  /**
   * @param stampNoise standard deviation of time stamps, s
   */
  KickData(KickFit fit, CameraViews views, double stampNoise) {
    whole = this;
    kick = fit.kick();
    kind = fit.kind();
    int own = ownSize(kind);
    start = new double[own];
    System.arraycopy(fit.values(), 0, start, 0, own);
    startAtRest();
    flights = fit.statistics().flights();
    Observations seen = kick.observations();
    size = seen.size();
    time = new double[size];
    x = new double[size];
    y = new double[size];
    row = new double[size];
    camera = new int[size];
    cameraHeight = new double[size];
    w11 = new double[size];
    w21 = new double[size];
    w22 = new double[size];
    used = Outliers.kept(fit, views);
    Whitening whitening = new Whitening();
    BallTrajectory path = fit.trajectory();
    int count = 0;
    for (int i = 0; i < size; i++) {
      time[i] = seen.time(i);
      x[i] = seen.x(i);
      y[i] = seen.y(i);
      row[i] = seen.pixelY(i);
      camera[i] = seen.camera(i);
      CameraView view = views.get(camera[i]);
      // Without geometry: infinitely high, so that a ball is reported where it is.
      cameraHeight[i] = view.camera().map(Camera::heightAboveBallPlane).orElse(1e9);
      BallState state = path.stateAt(time[i]);
      whitening.at(view, x[i], y[i], stampNoise * state.vx(), stampNoise * state.vy());
      w11[i] = whitening.w11();
      w21[i] = whitening.w21();
      w22[i] = whitening.w22();
      count += used[i] ? 1 : 0;
    }
    usedCount = count;
    sightings = new Sightings(camera, time, row);
    fromRest = kick.fromRest() && restCount() >= LEAST_REST;
  }

  /** The same without some of the detections. */
  private KickData(KickData of, boolean[] dropped) {
    whole = of;
    kick = of.kick;
    kind = of.kind;
    start = of.start;
    flights = of.flights;
    size = of.size;
    time = of.time;
    x = of.x;
    y = of.y;
    row = of.row;
    camera = of.camera;
    cameraHeight = of.cameraHeight;
    w11 = of.w11;
    w21 = of.w21;
    w22 = of.w22;
    sightings = of.sightings;
    used = of.used.clone();
    int count = 0;
    for (int i = 0; i < size; i++) {
      used[i] &= !dropped[i];
      count += used[i] ? 1 : 0;
    }
    usedCount = count;
    fromRest = kick.fromRest() && restCount() >= LEAST_REST;
  }

  /** A fit that lost the resting ball, because no path of its model leads from there, starts where that lay. */
  private void startAtRest() {
    double[] rest = Outliers.rest(kick);
    if (rest != null && Math.hypot(start[0] - rest[0], start[1] - rest[1]) > LOST_REST) {
      start[0] = rest[0];
      start[1] = rest[1];
      start[timeIndex()] = kick.time();
    }
  }

  private int restCount() {
    int n = 0;
    for (int i = 0; i < size && time[i] < kick.time(); i++) {
      n += used[i] ? 1 : 0;
    }
    return n;
  }

  /** The whole kick without some of its detections. */
  KickData without(boolean[] dropped) {
    return new KickData(whole, dropped);
  }

  /** Whether this is the same kick, taken for the same kind, whatever detections of it count. */
  boolean isSame(KickData other) {
    return kick == other.kick && kind == other.kind;
  }

  /** How many unknowns a kick has of its own: position, velocity, time. */
  static int ownSize(KickKind kind) {
    return kind == KickKind.FLAT ? 5 : 6;
  }

  /** By how much farther from the camera's foot point a ball at a height is reported than one on the ground. */
  double enlargement(int i, double height) {
    double h = cameraHeight[i];
    return h / (h - height);
  }

  int timeIndex() {
    return start.length - 1;
  }
}
