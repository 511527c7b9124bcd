package fieldcal.simulation.scenario;

import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.SimulatedRobot;

/** Takes a robot behind a resting ball without touching it. */
final class BallApproach {
  /** Distance from the ball's centre at which a robot goes round it, m. */
  static final double ORBIT = 0.24;

  /** Distance behind the ball from which it drives up, m. */
  static final double BEHIND = 0.17;

  private BallApproach() {}

  /** The next command on the way to the place behind the ball as seen in a direction. */
  static RobotCommand command(SimulatedRobot robot, BallBody ball, double aim, double speed) {
    double fromBallX = robot.x() - ball.x();
    double fromBallY = robot.y() - ball.y();
    double angle = Math.atan2(fromBallY, fromBallX);
    double missing = Math.IEEEremainder(aim + Math.PI - angle, 2 * Math.PI);
    double distance = Math.hypot(fromBallX, fromBallY);
    if (Math.abs(missing) < 0.12) {
      return RobotCommand.driveTo(
          ball.x() - BEHIND * Math.cos(aim), ball.y() - BEHIND * Math.sin(aim), aim, speed);
    }
    if (distance < 0.16) {
      // Too close to turn: straight back first.
      return RobotCommand.driveTo(
          ball.x() + ORBIT * Math.cos(angle),
          ball.y() + ORBIT * Math.sin(angle),
          robot.orientation(),
          Math.min(speed, 0.6));
    }
    double next = angle + Math.max(-0.5, Math.min(0.5, missing));
    return RobotCommand.driveTo(
        ball.x() + ORBIT * Math.cos(next),
        ball.y() + ORBIT * Math.sin(next),
        next + Math.PI,
        distance < 0.5 ? Math.min(speed, 0.8) : speed);
  }

  /** Whether the robot stands behind the ball and looks where it should. */
  static boolean ready(SimulatedRobot robot, BallBody ball, double aim) {
    double offX = robot.x() - (ball.x() - BEHIND * Math.cos(aim));
    double offY = robot.y() - (ball.y() - BEHIND * Math.sin(aim));
    double turn = Math.IEEEremainder(aim - robot.orientation(), 2 * Math.PI);
    return Math.hypot(offX, offY) < 0.006 && Math.abs(turn) < 0.004 && robot.speed() < 0.02;
  }
}
