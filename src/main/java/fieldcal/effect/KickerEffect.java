package fieldcal.effect;

import fieldcal.vision.RobotId;

/** An effect on what a robot makes of its command. It shows only where the commands are known, since the kick's own velocity is fitted. */
public interface KickerEffect extends Effect {
  @Override
  KickerEffect withParameters(double... values);

  /**
   * Whose kicks it changes.
   *
   * @return the robot
   */
  RobotId kicker();

  /**
   * Turns the commanded velocity into the one that the ball gets.
   *
   * @param robot who kicks
   * @param velocity vx, vy, vz of the command, m/s; changed in place
   */
  void kick(RobotId robot, double[] velocity);
}
