package fieldcal.simulation.scenario;

import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.SimulatedRobot;

/** Drives round other robots and the ball. */
final class Driving {
  private static final double LOOK_AHEAD = 0.6;
  private static final double CLEARANCE = 0.26;

  private Driving() {}

  static RobotCommand to(
      SimulatedWorld world,
      SimulatedRobot robot,
      double x,
      double y,
      double orientation,
      double maxSpeed) {
    double dx = x - robot.x();
    double dy = y - robot.y();
    double distance = Math.hypot(dx, dy);
    if (distance < 0.05) {
      return RobotCommand.driveTo(x, y, orientation, maxSpeed);
    }
    double ux = dx / distance;
    double uy = dy / distance;
    double shift = 0;
    for (SimulatedRobot other : world.robots()) {
      double toX = other.x() - robot.x();
      double toY = other.y() - robot.y();
      double ahead = ux * toX + uy * toY;
      double aside = -uy * toX + ux * toY;
      boolean inTheWay =
          other != robot
              && ahead > 0
              && ahead < Math.min(LOOK_AHEAD, distance)
              && Math.abs(aside) < CLEARANCE;
      if (inTheWay) {
        shift = aside > 0 ? -0.5 : 0.5;
      }
    }
    double ballX = world.ball().x() - robot.x();
    double ballY = world.ball().y() - robot.y();
    double ballAhead = ux * ballX + uy * ballY;
    double ballAside = -uy * ballX + ux * ballY;
    if (ballAhead > 0 && ballAhead < Math.min(LOOK_AHEAD, distance) && Math.abs(ballAside) < 0.2) {
      shift = ballAside > 0 ? -0.5 : 0.5;
    }
    if (shift == 0) {
      return RobotCommand.driveTo(x, y, orientation, maxSpeed);
    }
    // A detour to the freer side, as long as somebody is in the way.
    return RobotCommand.driveTo(
        robot.x() + 0.5 * ux - shift * uy,
        robot.y() + 0.5 * uy + shift * ux,
        orientation,
        Math.min(maxSpeed, 1.5));
  }
}
