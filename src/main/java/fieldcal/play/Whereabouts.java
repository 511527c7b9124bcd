package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;

/**
 * Where one of our robots may be. Since a camera saw it last, it may have gone on as it was seen to, or have done what it was ordered: its velocity is known late, and while no camera sees it, it obeys
 * all the same.
 */
final class Whereabouts {
  private double seen = Double.NaN;
  private double lowX;
  private double highX;
  private double lowY;
  private double highY;
  private Velocity ordered = Velocity.ZERO;

  /**
   * Takes the next tick.
   *
   * @param robot as it is known now; null when it was never seen
   * @param span since the last tick, s
   */
  void look(Robot robot, double span) {
    if (robot == null) {
      return;
    }
    if (robot.seen() == seen) {
      lowX += span * Math.min(robot.vx(), ordered.vx());
      highX += span * Math.max(robot.vx(), ordered.vx());
      lowY += span * Math.min(robot.vy(), ordered.vy());
      highY += span * Math.max(robot.vy(), ordered.vy());
    } else {
      seen = robot.seen();
      lowX = robot.x();
      highX = robot.x();
      lowY = robot.y();
      highY = robot.y();
    }
  }

  /** What it is ordered until the next tick. */
  void order(Velocity velocity) {
    ordered = velocity;
  }

  /** How much farther in a direction, given as a unit vector, it may be than it is known to be, m; not negative. */
  double beyond(Robot robot, double nx, double ny) {
    if (robot.seen() != seen) {
      return 0;
    }
    double alongX = nx * ((nx > 0 ? highX : lowX) - robot.x());
    double alongY = ny * ((ny > 0 ? highY : lowY) - robot.y());
    return Math.max(0, alongX) + Math.max(0, alongY);
  }
}
