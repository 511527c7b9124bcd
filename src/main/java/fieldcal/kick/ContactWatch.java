package fieldcal.kick;

/**
 * Decides whether a robot that the ball comes near touches it.
 *
 * <p>A ball passes a robot within centimetres, or flies over it, without being touched. So nearness only raises the question; the
 * answer is whether the ball goes on with the velocity that it came with. What was seen after a contact never enters a kick.
 */
final class ContactWatch {
  /** Robot radius 90 mm, ball radius 21.5 mm, and 30 mm for cameras that disagree, m. */
  private static final double NEAR = 0.142;

  /** Velocity changes below this share, or below 0.3 m/s, are what rolling and noise do within the watched time. */
  private static final double SHARE = 0.15;

  private static final double PATIENCE = 0.15;

  private boolean watching;
  private double since;
  private double x;
  private double y;
  private double vx;
  private double vy;
  private int seen;
  private final LineFit line = new LineFit();

  /** Verdict on one detection. */
  enum Verdict {
    FREE,
    WATCHING,
    TOUCHED
  }

  /** When the ball came near, s; meaningful after {@link Verdict#TOUCHED} or while watching. */
  double since() {
    return since;
  }

  boolean watching() {
    return watching;
  }

  Verdict update(BallTrack track, double robotDistance) {
    double now = track.lastTime();
    if (!watching) {
      if (robotDistance > NEAR || !track.fitNewest(8, 0.15, line)) {
        return Verdict.FREE;
      }
      watching = true;
      since = now;
      seen = 0;
      x = line.x(now);
      y = line.y(now);
      vx = line.vx();
      vy = line.vy();
      return Verdict.WATCHING;
    }
    seen++;
    if (seen < 5) {
      return now - since > PATIENCE ? Verdict.TOUCHED : Verdict.WATCHING;
    }
    // The ball may have come into another camera's view meanwhile, whose track is still short.
    if (!track.fitNewest(5, PATIENCE, line) || line.count() < 5) {
      return Verdict.WATCHING;
    }
    double change = Math.hypot(line.vx() - vx, line.vy() - vy);
    double missed =
        Math.hypot(track.x(0) - x - vx * (now - since), track.y(0) - y - vy * (now - since));
    boolean deflected = change > Math.max(0.3, SHARE * Math.hypot(vx, vy)) && missed > 0.03;
    if (deflected) {
      return Verdict.TOUCHED;
    }
    if (robotDistance > NEAR + 0.05) {
      watching = false;
      return Verdict.FREE;
    }
    return Verdict.WATCHING;
  }
}
