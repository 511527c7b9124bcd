package fieldcal.play;

import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayDeque;
import java.util.Deque;

/** A robot's wheels: orders reach them late, and they follow with a lag and with no more than some acceleration. Not thread-safe. */
final class Wheels {
  private final double tick;
  private final int delay;
  private final double lag;
  private final double acceleration;
  private final double turn;
  private final Deque<Velocity> onTheWay = new ArrayDeque<>();
  private double vx;
  private double vy;

  /**
   * @param tick between two orders, s
   * @param delay ticks until an order reaches the wheels
   * @param lag with which they follow, s; a tick for none
   * @param acceleration at most, m/s²
   * @param turn by which the robot drives beside its way, rad
   */
  private Wheels(double tick, int delay, double lag, double acceleration, double turn) {
    this.tick = tick;
    this.delay = delay;
    this.lag = lag;
    this.acceleration = acceleration;
    this.turn = turn;
  }

  /** Without a lag. */
  static Wheels prompt(double tick, int delay, double acceleration) {
    return new Wheels(tick, delay, tick, acceleration, 0);
  }

  /** As sluggish robots have them: 70 ms from command to wheel, a lag of 0.1 s, at most 1.5 m/s². */
  static Wheels sluggish(double tick, double turn) {
    return new Wheels(tick, (int) Math.round(0.07 / tick), 0.1, 1.5, turn);
  }

  /** Others that turn as these do and have heard the same orders. */
  Wheels copy() {
    Wheels copy = new Wheels(tick, delay, lag, acceleration, turn);
    copy.onTheWay.addAll(onTheWay);
    copy.start(vx, vy);
    return copy;
  }

  /** With which they turn now. */
  void start(double x, double y) {
    vx = x;
    vy = y;
  }

  void follow(Velocity ordered) {
    onTheWay.add(ordered);
    if (onTheWay.size() <= delay) {
      return;
    }
    Velocity told = onTheWay.remove();
    double dx = told.vx() * Math.cos(turn) - told.vy() * Math.sin(turn) - vx;
    double dy = told.vx() * Math.sin(turn) + told.vy() * Math.cos(turn) - vy;
    double share = Math.min(1 / lag, acceleration / Math.hypot(dx, dy)) * tick;
    vx += share * dx;
    vy += share * dy;
  }

  double vx() {
    return vx;
  }

  double vy() {
    return vy;
  }
}
