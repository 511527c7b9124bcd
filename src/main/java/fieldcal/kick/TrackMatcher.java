package fieldcal.kick;

import fieldcal.camera.Camera;
import java.util.Map;

/**
 * Decides whether tracks of two cameras show the same ball.
 *
 * <p>On the ground both cameras report the same place, but for their offset. A ball in the air is projected to different places;
 * then the two rays must meet at one height.
 */
final class TrackMatcher {
  /** Largest distance between two cameras' reports of one ball, m: cameras disagree, and the ball moves between their frames. */
  private static final double TOLERANCE = 0.1;

  /** A frame and a half, since a kick's time is good to some milliseconds only, s. */
  private static final double JUST_BEFORE = 0.02;

  /** A ball that another camera saw farther away just before was not there, m. */
  private static final double ELSEWHERE = 0.2;

  /** No chip goes higher, m, or upwards faster, m/s: the rules allow 6.5. Before the kick the ball is on the ground. */
  private static final double MAX_HEIGHT = 2.5;

  private static final double MAX_SPEED = 7;

  private static final int COMPARED = 3;
  private static final int STRIDE = 4;
  private static final double LOOK_BACK = 0.25;

  private final Map<Integer, Camera> views;
  private final LineFit scratch = new LineFit();
  private final double[] xy = new double[2];

  TrackMatcher(Map<Integer, Camera> views) {
    this.views = views;
  }

  boolean same(ActiveKick kick, BallTrack track) {
    boolean compared = false;
    for (BallTrack member : kick.members()) {
      if (member.camera() == track.camera() || track.lastTime() - member.lastTime() > 0.1) {
        continue;
      }
      compared = true;
      if (meets(member, track, kick.time())) {
        return true;
      }
    }
    return !compared && continues(kick, track);
  }

  /** Whether the detections of a track are where another camera sees its ball: the newest ones, and some of the last quarter of a second, since otherwise a ball would be confused with something white that it passes. */
  boolean meets(BallTrack member, BallTrack track, double kicked) {
    for (int age = 0; age < track.size(); age += age < COMPARED - 1 ? 1 : STRIDE) {
      double t = track.time(age);
      boolean known = member.positionAt(t, 0.04, scratch, xy);
      if (age >= COMPARED && (!known || track.lastTime() - t > LOOK_BACK)) {
        break;
      }
      double highest = Math.max(0, Math.min(MAX_HEIGHT, MAX_SPEED * (t - kicked)));
      if (!known
          || !(miss(member.camera(), track.camera(), track.x(age), track.y(age), highest)
              < TOLERANCE)) {
        return false;
      }
    }
    return true;
  }

  /** Distance at which the rays through {@code xy} (of camera a) and (bx, by) (of camera b) pass each other at equal height, m. */
  private double miss(int a, int b, double bx, double by, double highest) {
    double dx = xy[0] - bx;
    double dy = xy[1] - by;
    Camera ca = views.get(a);
    Camera cb = views.get(b);
    if (ca == null || cb == null) {
      return Math.hypot(dx, dy);
    }
    // At height z the ray through the ground point g of a camera c at height H is at g − (z/H)(g −
    // c).
    double ha = ca.heightAboveBallPlane();
    double hb = cb.heightAboveBallPlane();
    double sx = (xy[0] - ca.positionX()) / ha - (bx - cb.positionX()) / hb;
    double sy = (xy[1] - ca.positionY()) / ha - (by - cb.positionY()) / hb;
    double z = (dx * sx + dy * sy) / Math.max(sx * sx + sy * sy, 1e-12);
    z = Math.max(0, Math.min(highest, z));
    return Math.hypot(dx - z * sx, dy - z * sy);
  }

  /** Whether a track goes on where the ball was heading, when no other camera sees the ball. */
  private boolean continues(ActiveKick kick, BallTrack track) {
    return continues(kick.newest(), track);
  }

  /** Whether a track goes on where another camera's ball was heading when it was seen last. */
  boolean continues(BallTrack last, BallTrack track) {
    int first = Math.min(track.size(), 8) - 1;
    double gap = track.time(first) - last.lastTime();
    if (gap < -0.05 || gap > 0.5 || !last.fitNewest(8, 0.15, scratch)) {
      return false;
    }
    double t = track.time(0);
    double speed = scratch.speed();
    double ahead = t - last.lastTime();
    double off = Math.hypot(track.x(0) - scratch.x(t), track.y(0) - scratch.y(t));
    return off < TOLERANCE + ahead * (0.3 + 0.25 * speed);
  }

  /** Whether another track shows this ball elsewhere just before the apparent kick, so that it merely comes into view here. */
  boolean underWay(Iterable<CameraTracks> cameras, BallTrack track, JumpDetector.Jump start) {
    for (CameraTracks camera : cameras) {
      for (BallTrack other : camera.tracks()) {
        if (other != track
            && wasElsewhere(other, start)
            && other.fitNewest(8, 0.15, scratch)
            && scratch.speed() > 0.5 * start.speed()
            && (other.lastTime() < track.time(track.size() - 1)
                ? continues(other, track)
                : other.camera() != track.camera()
                    && meets(other, track, Double.NEGATIVE_INFINITY))) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean wasElsewhere(BallTrack other, JumpDetector.Jump start) {
    for (int age = 0; age < other.size(); age++) {
      if (other.time(age) < start.time() - JUST_BEFORE) {
        double away = Math.hypot(other.x(age) - start.x(), other.y(age) - start.y());
        return other.size() >= 3 && away > ELSEWHERE;
      }
    }
    return false;
  }
}
