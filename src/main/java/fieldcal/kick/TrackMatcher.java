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
  /** Cameras disagree by up to that much, and a ball moves between their frames, m. */
  private static final double TOLERANCE = 0.1;

  private static final double MAX_HEIGHT = 3.5;
  private static final int COMPARED = 3;

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
      if (meets(member, track)) {
        return true;
      }
    }
    return !compared && continues(kick, track);
  }

  /** Whether the newest detections of a track are where another camera sees its ball. */
  boolean meets(BallTrack member, BallTrack track) {
    for (int age = 0; age < COMPARED; age++) {
      double t = track.time(age);
      if (!member.positionAt(t, 0.04, scratch, xy)
          || !(miss(member.camera(), track.camera(), track.x(age), track.y(age)) < TOLERANCE)) {
        return false;
      }
    }
    return true;
  }

  /** Distance at which the rays through {@code xy} (of camera a) and (bx, by) (of camera b) pass each other at equal height, m. */
  private double miss(int a, int b, double bx, double by) {
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
    z = Math.max(0, Math.min(MAX_HEIGHT, z));
    return Math.hypot(dx - z * sx, dy - z * sy);
  }

  /** Nobody else sees the ball now: does the track go on where the ball was heading? */
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
}
