package fieldcal.diagnosis;

import fieldcal.vision.RobotId;
import java.util.Objects;

/**
 * What a robot was commanded when it kicked.
 *
 * @param robot who
 * @param speed commanded speed of the ball, the vertical part included, m/s, positive
 * @param direction in the field frame, rad, 0 = along x, counter-clockwise
 * @param elevation angle above the ground, rad; 0 = flat
 */
public record KickCommand(RobotId robot, double speed, double direction, double elevation) {

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the speed is not positive or a number not finite
   */
  public KickCommand {
    Objects.requireNonNull(robot, "robot");
    if (!(speed > 0) || !Double.isFinite(speed + direction + elevation)) {
      throw new IllegalArgumentException(
          "command of "
              + robot
              + ": speed "
              + speed
              + ", direction "
              + direction
              + ", elevation "
              + elevation);
    }
  }
}
