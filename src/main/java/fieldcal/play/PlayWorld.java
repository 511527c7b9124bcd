package fieldcal.play;

import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a host knows of the field at one tick. All times count from the same zero, whatever it is; positions are those of the field frame, m.
 *
 * @param time now, s; must not decrease from tick to tick
 * @param visionTime when the frame that arrived last, of any camera, was captured, s; it changes with every frame, and how far it is behind {@code time} shows how late vision is
 * @param ball the ball as it was seen last; empty when it was never seen
 * @param robots all robots that the host knows of, both teams
 * @param permission what the referee allows
 */
public record PlayWorld(
    double time,
    double visionTime,
    Optional<Ball> ball,
    List<Robot> robots,
    Permission permission) {

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public PlayWorld {
    Objects.requireNonNull(ball, "ball");
    Objects.requireNonNull(permission, "permission");
    robots = List.copyOf(robots);
  }

  /** What the referee allows. Without a referee everything is allowed. */
  public enum Permission {
    /** Robots may do everything. */
    RUN,
    /** The game is stopped: the play waits. */
    STOP,
    /** No robot may move. */
    HALT
  }

  /**
   * The ball.
   *
   * @param x at {@code seen}, m
   * @param y at {@code seen}, m
   * @param vx m/s
   * @param vy m/s
   * @param seen when a camera saw it last, s
   */
  public record Ball(double x, double y, double vx, double vy, double seen) {

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
   * A robot of any team.
   *
   * @param id team and number
   * @param x now, or where it was seen last, m
   * @param y m
   * @param orientation of its front, rad, counter-clockwise from x
   * @param vx m/s
   * @param vy m/s
   * @param seen when a camera saw it last, s
   */
  public record Robot(
      RobotId id, double x, double y, double orientation, double vx, double vy, double seen) {

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
   * A robot by name.
   *
   * @param id team and number
   * @return the robot, when the host knows of it
   */
  public Optional<Robot> robot(RobotId id) {
    return robots.stream().filter(r -> r.id().equals(id)).findFirst();
  }
}
