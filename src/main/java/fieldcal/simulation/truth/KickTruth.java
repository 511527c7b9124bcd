package fieldcal.simulation.truth;

import fieldcal.simulation.physics.BallEvent;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * One flight of the ball, from what set it in motion to its end.
 *
 * @param index running number from 0
 * @param kind what set the ball in motion
 * @param purpose what the robot wanted, for example {@code pass}
 * @param time session time of the kick, s
 * @param duration until the end, s
 * @param end why it was over
 * @param position of the ball at the kick, m (z = height of the lowest point)
 * @param velocity right after the kick, m/s
 * @param spin right after the kick, rad/s
 * @param robot who
 * @param robotPose where the robot was: x (m), y (m), orientation (rad) in place of z
 * @param command what the robot was commanded
 * @param events what happened on the way
 * @param pathStep time between two points of the path, s
 * @param path noise-free positions from the kick on, m
 * @param endRobot the robot that ended it, if one did
 */
public record KickTruth(
    int index,
    KickKind kind,
    String purpose,
    double time,
    double duration,
    EndReason end,
    Vector3 position,
    Vector3 velocity,
    Vector3 spin,
    RobotId robot,
    Vector3 robotPose,
    KickCommand command,
    List<BallEvent> events,
    double pathStep,
    List<Vector3> path,
    Optional<RobotId> endRobot) {

  /** Time between two points of the path, s. */
  public static final double PATH_STEP = 0.01;

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public KickTruth {
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(end, "end");
    events = List.copyOf(events);
    path = List.copyOf(path);
  }

  /**
   * Three numbers.
   *
   * @param x first
   * @param y second
   * @param z third
   */
  public record Vector3(double x, double y, double z) {

    /**
     * Length.
     *
     * @return √(x² + y² + z²)
     */
    public double norm() {
      return Math.sqrt(x * x + y * y + z * z);
    }

    /**
     * Length of the horizontal part.
     *
     * @return √(x² + y²)
     */
    public double horizontal() {
      return Math.hypot(x, y);
    }

    /**
     * Direction of the horizontal part.
     *
     * @return rad
     */
    public double direction() {
      return Math.atan2(y, x);
    }
  }

  /**
   * What the robot was commanded.
   *
   * @param speed absolute speed, m/s
   * @param direction direction in the field frame, rad, 0 = along x, counter-clockwise
   * @param elevation angle above the ground, rad, 0 = flat
   */
  public record KickCommand(double speed, double direction, double elevation) {}

  /**
   * Spin about the rolling axis right after the kick.
   *
   * @param radius of the ball, m
   * @return in units of rolling spin v/r; 0 for a ball without horizontal speed
   */
  public double rollFraction(double radius) {
    double squared = velocity.x() * velocity.x() + velocity.y() * velocity.y();
    return squared == 0
        ? 0
        : radius * (spin.y() * velocity.x() - spin.x() * velocity.y()) / squared;
  }

  /**
   * Spin about the direction of travel right after the kick.
   *
   * @param radius of the ball, m
   * @return in units of rolling spin v/r; 0 for a ball without horizontal speed
   */
  public double sideFraction(double radius) {
    double squared = velocity.x() * velocity.x() + velocity.y() * velocity.y();
    return squared == 0
        ? 0
        : radius * (spin.x() * velocity.x() + spin.y() * velocity.y()) / squared;
  }
}
