package fieldcal.play;

import fieldcal.play.PlayWorld.Ball;
import java.util.Optional;

/** What the play remembers of the ball from tick to tick. */
final class BallMemory {
  private static final double SLOW = 0.08;
  private static final double FAST = 0.16;
  private static final double MOVED = 0.04;

  private double x;
  private double y;
  private double vx;
  private double vy;
  private double seen = Double.NEGATIVE_INFINITY;
  private double restingSince = Double.NaN;
  private double anchorX;
  private double anchorY;

  void update(Optional<Ball> now, double time) {
    if (now.isEmpty() || !(now.get().seen() > seen)) {
      return;
    }
    Ball ball = now.get();
    if (!Double.isFinite(ball.x() + ball.y() + ball.vx() + ball.vy())) {
      return;
    }
    boolean gap = ball.seen() - seen > 0.5;
    x = ball.x();
    y = ball.y();
    vx = ball.vx();
    vy = ball.vy();
    seen = Math.min(ball.seen(), time);
    boolean moved = Math.hypot(x - anchorX, y - anchorY) > MOVED;
    if (gap || moved || speed() > FAST) {
      restingSince = Double.NaN;
    }
    if (Double.isNaN(restingSince)) {
      anchorX = x;
      anchorY = y;
      if (speed() < SLOW) {
        restingSince = seen;
      }
    }
  }

  boolean known() {
    return seen > Double.NEGATIVE_INFINITY;
  }

  /** When a camera saw it last, s. */
  double seen() {
    return seen;
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  double vx() {
    return vx;
  }

  double vy() {
    return vy;
  }

  double speed() {
    return Math.hypot(vx, vy);
  }

  /** For how long it has been seen lying still; 0 when it moves, s. */
  double resting() {
    return Double.isNaN(restingSince) ? 0 : seen - restingSince;
  }

  double distance(double px, double py) {
    return Math.hypot(x - px, y - py);
  }
}
