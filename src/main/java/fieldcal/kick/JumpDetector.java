package fieldcal.kick;

/**
 * Notices that the velocity of one track jumps.
 *
 * <p>At every detection a line through the newest ones is compared with a line through those before. The difference of the two
 * velocities has its maximum when the kick lies exactly between the two windows; that is when the jump is reported.
 */
final class JumpDetector {
  private static final int AFTER = 6;
  private static final int BEFORE = 10;
  private static final double AFTER_SPAN = 0.2;
  private static final double BEFORE_SPAN = 0.35;

  /** Largest residual of a usable line, m; a larger one means that the window straddles the kick or holds false detections. */
  private static final double MAX_RMS = 0.025;

  /** After a longer gap the detections before it are no longer comparable, s. */
  private static final double LONG_HIDDEN = 0.25;

  /** Number of detections for which a jump must not have grown before it is reported. */
  private static final int PATIENCE = 3;

  private final LineFit before = new LineFit();
  private final LineFit after = new LineFit();
  private double best;
  private int waited;
  private double lastReported = Double.NEGATIVE_INFINITY;
  private Jump pending;

  /**
   * A change of velocity.
   *
   * @param time of the jump, s
   * @param x of the place, m
   * @param y of the place, m
   * @param vx velocity after, m/s
   * @param vy velocity after, m/s
   * @param vxBefore velocity before, m/s
   * @param vyBefore velocity before, m/s
   * @param fromRest whether the ball lay still before
   * @param born whether the track begins with the ball already moving, or with the ball moving after it was hidden for long
   */
  record Jump(
      double time,
      double x,
      double y,
      double vx,
      double vy,
      double vxBefore,
      double vyBefore,
      boolean fromRest,
      boolean born) {
    double speed() {
      return Math.hypot(vx, vy);
    }

    /** The jump of the same ball if it was kicked earlier by the given time and has been hidden since. */
    Jump earlier(double by) {
      return new Jump(
          time - by, x - vx * by, y - vy * by, vx, vy, vxBefore, vyBefore, fromRest, born);
    }

    double speedBefore() {
      return Math.hypot(vxBefore, vyBefore);
    }

    double change() {
      return Math.hypot(vx - vxBefore, vy - vyBefore);
    }
  }

  /** Looks at the track's newest detection; returns a jump once it is certain, else null. */
  Jump update(BallTrack track, KickFinderSettings settings) {
    Jump now = evaluate(track, settings);
    if (now != null && (pending == null || now.change() > best)) {
      pending = now;
      best = now.change();
      waited = 0;
      return null;
    }
    if (pending == null || ++waited < PATIENCE) {
      return null;
    }
    Jump found = pending;
    pending = null;
    best = 0;
    waited = 0;
    if (found.time - lastReported < 0.06) {
      return null;
    }
    lastReported = found.time;
    return found;
  }

  private Jump evaluate(BallTrack track, KickFinderSettings settings) {
    int n = track.size();
    if (n < AFTER || track.lastTime() - track.time(AFTER - 1) > AFTER_SPAN) {
      return null;
    }
    if (!track.fit(0, AFTER - 1, after)
        || after.rms() > MAX_RMS
        || after.speed() < settings.minSpeed()) {
      return null;
    }
    boolean hidden = n > AFTER && track.time(AFTER - 1) - track.time(AFTER) > LONG_HIDDEN;
    if (track.total() == AFTER || hidden) {
      double t = track.time(AFTER - 1);
      return new Jump(t, after.x(t), after.y(t), after.vx(), after.vy(), 0, 0, false, true);
    }
    int oldest = AFTER;
    while (oldest + 1 < n
        && oldest - AFTER + 1 < BEFORE
        && track.time(AFTER) - track.time(oldest + 1) < BEFORE_SPAN) {
      oldest++;
    }
    int used = oldest - AFTER + 1;
    if (used < 3 || !track.fit(AFTER, oldest, before)) {
      return null;
    }
    double jump = Math.hypot(after.vx() - before.vx(), after.vy() - before.vy());
    if (before.rms() > MAX_RMS
        || jump < settings.minJump() + 3 * (before.velocityError() + after.velocityError())) {
      return null;
    }
    boolean rest = before.speed() < Math.max(0.12, 3 * before.velocityError());
    return jumpAt(track, rest && used >= 5);
  }

  /** The jump at the instant at which both lines are nearest to each other. */
  private Jump jumpAt(BallTrack track, boolean rest) {
    double earliest = track.time(AFTER) - 0.03;
    double latest = track.time(AFTER - 1) + 0.03;
    double t = track.time(AFTER);
    double bvx = rest ? 0 : before.vx();
    double bvy = rest ? 0 : before.vy();
    double dvx = after.vx() - bvx;
    double dvy = after.vy() - bvy;
    double dx = after.x(t) - before.x(t);
    double dy = after.y(t) - before.y(t);
    t -= (dx * dvx + dy * dvy) / (dvx * dvx + dvy * dvy);
    t = Math.min(latest, Math.max(earliest, t));
    double x = rest ? before.x(track.time(AFTER)) : after.x(t);
    double y = rest ? before.y(track.time(AFTER)) : after.y(t);
    return new Jump(t, x, y, after.vx(), after.vy(), bvx, bvy, rest, false);
  }
}
