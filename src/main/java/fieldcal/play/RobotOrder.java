package fieldcal.play;

import fieldcal.vision.RobotId;
import java.util.Objects;
import java.util.Optional;

/**
 * What one robot is to do until the next tick.
 *
 * @param robot who
 * @param velocity how to drive; already keeps clear of other robots and of the margin
 * @param target where it is heading; empty when it is to stand, or drives up to a ball. Hosts with a path planner of their own may use it instead of the velocity
 * @param kick what to do when the ball touches the kicker
 * @param dribbler whether the dribbler turns
 */
public record RobotOrder(
    RobotId robot, Velocity velocity, Optional<Pose> target, Kick kick, boolean dribbler) {

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public RobotOrder {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(velocity, "velocity");
    Objects.requireNonNull(target, "target");
    Objects.requireNonNull(kick, "kick");
  }

  /**
   * The order to stand still with everything off.
   *
   * @param robot who
   * @return the order
   */
  public static RobotOrder stop(RobotId robot) {
    return new RobotOrder(robot, Velocity.ZERO, Optional.empty(), Kick.NONE, false);
  }

  /**
   * A velocity in the field frame.
   *
   * @param vx m/s
   * @param vy m/s
   * @param angular rad/s, counter-clockwise
   */
  public record Velocity(double vx, double vy, double angular) {
    /** Standing. */
    public static final Velocity ZERO = new Velocity(0, 0, 0);

    /**
     * Speed over the ground.
     *
     * @return m/s
     */
    public double speed() {
      return Math.hypot(vx, vy);
    }
  }

  /**
   * A place and a direction to look.
   *
   * @param x m
   * @param y m
   * @param orientation direction of the front, rad, counter-clockwise from x
   */
  public record Pose(double x, double y, double orientation) {}

  /**
   * What the kicker does as soon as the ball touches it.
   *
   * @param speed of the ball along its path, m/s; 0 = no kick
   * @param elevation above the carpet, rad; 0 = flat
   */
  public record Kick(double speed, double elevation) {
    /** No kick. */
    public static final Kick NONE = new Kick(0, 0);

    /**
     * Whether it is a kick at all.
     *
     * @return true when the kicker is armed
     */
    public boolean armed() {
      return speed > 0;
    }

    /**
     * Whether the ball is to fly.
     *
     * @return true for a chip
     */
    public boolean chip() {
      return elevation > 0;
    }
  }
}
