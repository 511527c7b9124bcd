package fieldcal.simulation.robot;

/**
 * What a robot is commanded for one tick.
 *
 * @param motion where to or how fast
 * @param kick what to do when the ball touches the kicker
 * @param dribbler whether the dribbler turns: it stops and holds a ball that arrives
 */
public record RobotCommand(Motion motion, Kick kick, boolean dribbler) {

  /** Stand still. */
  public static final RobotCommand HALT = new RobotCommand(new Velocity(0, 0, 0), Kick.NONE, false);

  /** A movement. */
  public sealed interface Motion permits Velocity, Target {}

  /**
   * A velocity in the field frame.
   *
   * @param vx velocity along x, m/s
   * @param vy velocity along y, m/s
   * @param angular angular velocity, rad/s, counter-clockwise positive
   */
  public record Velocity(double vx, double vy, double angular) implements Motion {}

  /**
   * A pose to reach and stand at.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param orientation direction of its front, rad, 0 = along x, counter-clockwise
   * @param maxSpeed largest speed on the way, m/s
   */
  public record Target(double x, double y, double orientation, double maxSpeed) implements Motion {}

  /**
   * What the kicker does as soon as the ball is at it.
   *
   * @param speed absolute speed of the ball, m/s; 0 = no kick
   * @param elevation 0 for a flat kick, rad
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

  /**
   * Drive to a pose.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param orientation direction of its front, rad, 0 = along x, counter-clockwise
   * @param maxSpeed largest speed on the way, m/s
   * @return the command
   */
  public static RobotCommand driveTo(double x, double y, double orientation, double maxSpeed) {
    return new RobotCommand(new Target(x, y, orientation, maxSpeed), Kick.NONE, false);
  }

  /**
   * The same movement with the kicker armed.
   *
   * @param order the kick
   * @return the changed command
   */
  public RobotCommand kicking(Kick order) {
    return new RobotCommand(motion, order, dribbler);
  }

  /**
   * The same movement with the dribbler on.
   *
   * @return the changed command
   */
  public RobotCommand dribbling() {
    return new RobotCommand(motion, kick, true);
  }
}
