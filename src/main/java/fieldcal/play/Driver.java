package fieldcal.play;

import fieldcal.play.PathPlanner.Circle;
import fieldcal.play.PathPlanner.Way;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import fieldcal.play.RobotOrder.Velocity;
import java.util.List;
import java.util.Optional;

/** Turns a pose to reach into a velocity now. */
final class Driver {
  /** Speed per distance close to the target, 1/s: slow enough for 60 ms from camera to wheel. */
  private static final double GAIN = 5;

  private static final double TURN_GAIN = 6;
  private static final double TURN_BRAKING = 8;
  private static final double TURN_MAX = 6;

  private final PathPlanner planner;
  private final double braking;

  Driver(PathPlanner planner, double braking) {
    this.planner = planner;
    this.braking = braking;
  }

  /** The velocity towards a pose; empty when there is no way. {@code calm} is the part of the usual gains that the robot tolerates. */
  Optional<Velocity> to(
      Robot robot, Pose target, double maxSpeed, double calm, List<Circle> obstacles) {
    return to(robot, target, maxSpeed, braking, calm, obstacles);
  }

  /** The same with another deceleration before the target, m/s². */
  Optional<Velocity> to(
      Robot robot,
      Pose target,
      double maxSpeed,
      double braking,
      double calm,
      List<Circle> obstacles) {
    return way(robot, target, obstacles)
        .map(way -> along(way, robot, target, maxSpeed, braking, calm));
  }

  /** The way to a pose; empty when there is none. */
  Optional<Way> way(Robot robot, Pose target, List<Circle> obstacles) {
    return planner.way(robot.x(), robot.y(), target.x(), target.y(), obstacles);
  }

  private static Velocity along(
      Way way, Robot robot, Pose target, double fastest, double hardest, double calm) {
    double braking = calm * hardest;
    // As far as it needs to stop otherwise.
    double maxSpeed = Math.sqrt(calm) * fastest;
    double dx = way.x() - robot.x();
    double dy = way.y() - robot.y();
    double distance = Math.hypot(dx, dy);
    double angular = turn(robot.orientation(), target.orientation(), calm);
    if (distance < 0.002) {
      return new Velocity(0, 0, angular);
    }
    double speed = Math.min(maxSpeed, Math.sqrt(2 * braking * way.length()));
    if (way.corner() < -0.999) {
      speed = Math.min(speed, calm * GAIN * distance);
    } else {
      // A robot that follows late goes on straight for longer: at this speed it leaves the way as
      // little as others.
      double round = calm * (0.4 + 0.8 * Math.max(0, way.corner()));
      speed = Math.min(speed, Math.sqrt(round * round + 2 * braking * distance));
    }
    return new Velocity(speed * dx / distance, speed * dy / distance, angular);
  }

  static double turn(double from, double to, double calm) {
    double turn = Math.IEEEremainder(to - from, 2 * Math.PI);
    double rate =
        Math.min(
            Math.min(TURN_MAX, calm * TURN_GAIN * Math.abs(turn)),
            Math.sqrt(2 * calm * TURN_BRAKING * Math.abs(turn)));
    return Math.copySign(rate, turn);
  }
}
