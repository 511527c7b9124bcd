package fieldcal.app.play;

import fieldcal.app.play.CameraOffsets.View;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import java.util.Map;
import java.util.TreeMap;

/**
 * Follows one robot: for each camera an α-β filter on position and orientation (Benedict and Bordner 1962), joined where cameras overlap, less the cameras' offsets. Cameras that disagree, at the same
 * time stamp above all, do not make a robot that stands move. A pattern counts as soon as a camera has seen it {@link #SURE} times in a row: vision misreads one now and then.
 */
final class RobotTracker {
  /** Gains for 3 mm of noise at 70 Hz and robots that accelerate at 3 m/s². */
  private static final double ALPHA = 0.3;

  private static final double BETA = 0.06;

  /** Farther off than that is another pattern taken for this robot, m. */
  private static final double GATE = 0.3;

  /** Farther turned than that is a pattern whose colours were mixed up, rad: less than half of the 90° between two neighbouring blobs. */
  private static final double TURN_GATE = 0.6;

  private static final int ENOUGH_ELSEWHERE = 4;
  private static final double FORGET = 0.5;

  /** A pattern that was seen so often in a row is there: of patterns that are misread now and then, none is. */
  private static final int SURE = 4;

  /** What is not sure yet must be seen again within that time, s: three frames at 30 Hz. */
  private static final double SOON = 0.1;

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
  private Robot last;

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

    boolean sure() {
      return seen >= SURE;
    }

    /** Takes a detection; false when it is another pattern. */
    boolean accept(RobotDetection detection, double t) {
      double dt = t - time;
      boolean lost = dt > (sure() ? FORGET : SOON);
      if (Double.isNaN(time) || lost || elsewhere >= ENOUGH_ELSEWHERE) {
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
      if (Math.hypot(errorX, errorY) > GATE || Math.abs(turn) > TURN_GATE) {
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
    if (!track.accept(seen, t)) {
      return;
    }
    if (track.seen == 1 && t - time < PRESENT) {
      inherit(track);
    }
    if (!track.sure()) {
      return;
    }
    time = Double.isNaN(time) ? t : Math.max(time, t);
    last =
        new Robot(
            id,
            track.x - offsets.x(camera),
            track.y - offsets.y(camera),
            track.orientation,
            0,
            0,
            time);
    offsets.learn(
        view(camera, track),
        tracks.entrySet().stream()
            .filter(e -> e.getValue().sure())
            .map(e -> view(e.getKey(), e.getValue()))
            .toList());
  }

  /** A camera into whose view it drives need not learn its velocity again. */
  private void inherit(Track begun) {
    Track best = best();
    if (best != null && Math.hypot(best.x - begun.x, best.y - begun.y) < GATE) {
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
      if (t.sure() && time - t.time < PRESENT && (best == null || t.seen > best.seen)) {
        best = t;
      }
    }
    return best;
  }

  /** Whether any camera has surely seen it with its orientation. */
  boolean known() {
    return !Double.isNaN(time);
  }

  /** Where it is now, if it went on as it did, with a vision that is late by {@code delay}; not seen for {@link #GOES_ON} beyond that, it is taken to stand. */
  Robot at(double now, double delay) {
    Track best = best();
    if (best == null) {
      // It was put elsewhere, where no camera is sure of it yet.
      return last;
    }
    boolean known = now - delay - time < GOES_ON;
    double[] sum = new double[7];
    for (Map.Entry<Integer, Track> entry : tracks.entrySet()) {
      Track t = entry.getValue();
      boolean here = Math.hypot(t.x - best.x, t.y - best.y) < GATE;
      if (t.sure() && time - t.time < PRESENT && here) {
        double weight = Math.min(SETTLED, t.seen);
        double ahead = known ? Math.max(0, now - t.time) : time - t.time;
        double turned = Math.IEEEremainder(t.orientation - best.orientation, 2 * Math.PI);
        sum[0] += weight;
        sum[1] += weight * (t.x + ahead * t.vx - offsets.x(entry.getKey()));
        sum[2] += weight * (t.y + ahead * t.vy - offsets.y(entry.getKey()));
        sum[3] += weight * (turned + ahead * t.angular);
        sum[4] += weight * t.vx;
        sum[5] += weight * t.vy;
      }
    }
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
