package fieldcal.app.play;

import fieldcal.app.play.CameraOffsets.View;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import java.util.Map;
import java.util.TreeMap;

/**
 * Follows one robot: for each camera an α-β filter on position and orientation (Benedict and Bordner 1962), joined where cameras overlap, less the cameras' offsets. Cameras that disagree, at the same
 * time stamp above all, do not make a robot that stands move.
 */
final class RobotTracker {
  /** Gains for 3 mm of noise at 70 Hz and robots that accelerate at 3 m/s². */
  private static final double ALPHA = 0.3;

  private static final double BETA = 0.06;

  /** Farther off than that is another pattern taken for this robot, m. */
  private static final double GATE = 0.3;

  private static final int ENOUGH_ELSEWHERE = 4;
  private static final double FORGET = 0.5;

  /**
   * A robot that is not seen drives on as it did for so long, s: so long may robots drive unseen before the play stops them, and what was thought to stand where it was seen last would not be braked
   * before the edge.
   */
  private static final double GOES_ON = 0.25;

  /** A camera that has not seen it for so long while another has does not see it any more, s: three frames at 50 Hz. */
  private static final double PRESENT = 0.06;

  /** A camera's velocity counts after so many detections as much as any other's. */
  private static final int SETTLED = 20;

  private final RobotId id;
  private final CameraOffsets offsets;
  private final Map<Integer, Track> tracks = new TreeMap<>();
  private double time = Double.NaN;

  /** The robot as one camera sees it. */
  private static final class Track {
    private double x;
    private double y;
    private double orientation;
    private double vx;
    private double vy;
    private double angular;
    private double time = Double.NaN;
    private int seen;
    private int elsewhere;

    /** Takes a detection; false when it is another pattern. */
    boolean accept(RobotDetection detection, double t) {
      double dt = t - time;
      if (Double.isNaN(time) || dt > FORGET || elsewhere >= ENOUGH_ELSEWHERE) {
        start(detection, t);
        return true;
      }
      if (dt <= 0) {
        return false;
      }
      double errorX = detection.x() - (x + dt * vx);
      double errorY = detection.y() - (y + dt * vy);
      double turn =
          Math.IEEEremainder(detection.orientation() - (orientation + dt * angular), 2 * Math.PI);
      if (Math.hypot(errorX, errorY) > GATE) {
        elsewhere++;
        return false;
      }
      elsewhere = 0;
      seen++;
      x += dt * vx + ALPHA * errorX;
      y += dt * vy + ALPHA * errorY;
      orientation += dt * angular + ALPHA * turn;
      vx += BETA / dt * errorX;
      vy += BETA / dt * errorY;
      angular += BETA / dt * turn;
      time = t;
      return true;
    }

    private void start(RobotDetection detection, double t) {
      x = detection.x();
      y = detection.y();
      orientation = detection.orientation();
      vx = 0;
      vy = 0;
      angular = 0;
      time = t;
      seen = 1;
      elsewhere = 0;
    }
  }

  /** A robot that no camera has seen yet. */
  RobotTracker(RobotId id, CameraOffsets offsets) {
    this.id = id;
    this.offsets = offsets;
  }

  void accept(int camera, RobotDetection seen, double t) {
    if (Double.isNaN(seen.orientation())) {
      return;
    }
    Track track = tracks.computeIfAbsent(camera, c -> new Track());
    boolean begins = Double.isNaN(track.time) || t - track.time > FORGET;
    if (!track.accept(seen, t)) {
      return;
    }
    time = Double.isNaN(time) ? t : Math.max(time, t);
    if (begins && time - t < PRESENT) {
      inherit(track);
    }
    offsets.learn(
        view(camera, track),
        tracks.entrySet().stream().map(e -> view(e.getKey(), e.getValue())).toList());
  }

  /** A camera into whose view it drives need not learn its velocity again. */
  private void inherit(Track begun) {
    Track best = best();
    if (best != begun && Math.hypot(best.x - begun.x, best.y - begun.y) < GATE) {
      begun.vx = best.vx;
      begun.vy = best.vy;
      begun.angular = best.angular;
    }
  }

  private static View view(int camera, Track t) {
    return new View(camera, t.time, t.x, t.y, t.vx, t.vy);
  }

  /** Of the cameras that see it now the one that has seen it for longest. */
  private Track best() {
    Track best = null;
    for (Track t : tracks.values()) {
      if (time - t.time < PRESENT && (best == null || t.seen > best.seen)) {
        best = t;
      }
    }
    return best;
  }

  /** Whether any camera has seen it with its orientation. */
  boolean known() {
    return !Double.isNaN(time);
  }

  /** Where it is now, if it went on as it did; beyond {@link #GOES_ON} it is taken to stand. */
  Robot at(double now) {
    Track best = best();
    double[] sum = new double[7];
    for (Map.Entry<Integer, Track> entry : tracks.entrySet()) {
      Track t = entry.getValue();
      boolean here = Math.hypot(t.x - best.x, t.y - best.y) < GATE;
      if (time - t.time < PRESENT && here) {
        double weight = Math.min(SETTLED, t.seen);
        double ahead = now - time < GOES_ON ? Math.max(0, now - t.time) : time - t.time;
        double turned = Math.IEEEremainder(t.orientation - best.orientation, 2 * Math.PI);
        sum[0] += weight;
        sum[1] += weight * (t.x + ahead * t.vx - offsets.x(entry.getKey()));
        sum[2] += weight * (t.y + ahead * t.vy - offsets.y(entry.getKey()));
        sum[3] += weight * (turned + ahead * t.angular);
        sum[4] += weight * t.vx;
        sum[5] += weight * t.vy;
      }
    }
    boolean known = now - time < GOES_ON;
    return new Robot(
        id,
        sum[1] / sum[0],
        sum[2] / sum[0],
        Math.IEEEremainder(best.orientation + sum[3] / sum[0], 2 * Math.PI),
        known ? sum[4] / sum[0] : 0,
        known ? sum[5] / sum[0] : 0,
        time);
  }
}
