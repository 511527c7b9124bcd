package fieldcal.simulation;

import fieldcal.simulation.robot.SimulatedRobot;
import java.util.List;

/** Where a hand puts a robot down: where it was, or at the nearest place beside it when another robot stands there. */
final class PutDown {
  /** Between the centres of robots with a hand's breadth between them, m. */
  private static final double TWO_ROBOTS = 0.28;

  /** Between the places that are tried, m: as exactly as a hand puts a robot down. */
  private static final double STEP = 0.02;

  /** Directions in which places are tried: at the distance of two robots they are less than two steps apart. */
  private static final int DIRECTIONS = 48;

  private PutDown() {}

  /**
   * The nearest place to a pose that has room. It is within the lines, or no farther beyond them than the pose.
   *
   * @param pose x and y, m, and orientation, rad
   * @param robots all robots of the field
   * @param field its size
   * @return x and y, m, and orientation, rad
   */
  static double[] near(double[] pose, List<SimulatedRobot> robots, FieldSize field) {
    double farthestX = Math.max(0.5 * field.length(), Math.abs(pose[0]));
    double farthestY = Math.max(0.5 * field.width(), Math.abs(pose[1]));
    // Robots that stood side by side would block a circle of this radius.
    double farthest = TWO_ROBOTS * (1 + robots.size());
    for (double distance = 0; distance < farthest; distance += STEP) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double direction = 2 * Math.PI * i / DIRECTIONS;
        double x = pose[0] + distance * Math.cos(direction);
        double y = pose[1] + distance * Math.sin(direction);
        boolean allowed = Math.abs(x) <= farthestX && Math.abs(y) <= farthestY;
        if (allowed && isFree(x, y, robots)) {
          return new double[] {x, y, pose[2]};
        }
      }
    }
    return pose;
  }

  /** Nobody puts a robot onto another. */
  private static boolean isFree(double x, double y, List<SimulatedRobot> robots) {
    return robots.stream().allMatch(r -> Math.hypot(r.x() - x, r.y() - y) > TWO_ROBOTS);
  }
}
