package fieldcal.simulation.robot;

import fieldcal.simulation.physics.BallBody;

/** Geometry of a ball at a robot: a circle of 90 mm whose front is cut off flat. */
public final class Contact {
  private static final double BODY = 0.09;

  /** Largest gap between the mouth plane and a ball that still counts as touching, m. */
  private static final double REACH = 0.003;

  private final double penetration;
  private final double normalX;
  private final double normalY;
  private final boolean atMouth;

  private Contact(double penetration, double normalX, double normalY, boolean atMouth) {
    this.penetration = penetration;
    this.normalX = normalX;
    this.normalY = normalY;
    this.atMouth = atMouth;
  }

  /**
   * How ball and robot touch.
   *
   * @param robot the robot
   * @param ball the ball
   * @param radius of the ball, m
   * @return the contact; check {@link #touches}
   */
  public static Contact of(SimulatedRobot robot, BallBody ball, double radius) {
    double ahead = robot.ahead(ball.x(), ball.y());
    double aside = robot.aside(ball.x(), ball.y());
    double cos = Math.cos(robot.orientation());
    double sin = Math.sin(robot.orientation());
    boolean below = ball.z() < robot.height();
    if (ahead > 0 && Math.abs(aside) < SimulatedRobot.MOUTH) {
      double gap = ahead - SimulatedRobot.FRONT - radius;
      return new Contact(below ? -gap : -1, cos, sin, true);
    }
    double distance = Math.hypot(ball.x() - robot.x(), ball.y() - robot.y());
    double gap = distance - BODY - radius;
    double nx = distance > 0 ? (ball.x() - robot.x()) / distance : 1;
    double ny = distance > 0 ? (ball.y() - robot.y()) / distance : 0;
    return new Contact(below ? -gap : -1, nx, ny, false);
  }

  /**
   * Whether the ball is in the mouth, close enough to be kicked or held.
   *
   * @return true when it is
   */
  public boolean inMouth() {
    return atMouth && penetration > -REACH && penetration < 0.05;
  }

  /**
   * Whether ball and robot overlap.
   *
   * @return true when they do
   */
  public boolean touches() {
    return penetration > 0;
  }

  /**
   * How far they overlap.
   *
   * @return m, negative when they do not
   */
  public double penetration() {
    return penetration;
  }

  /**
   * Whether the ball is at the flat front.
   *
   * @return true at the front
   */
  public boolean atMouth() {
    return atMouth;
  }

  /**
   * Direction from the robot to the ball.
   *
   * @return x of the unit normal
   */
  public double normalX() {
    return normalX;
  }

  /**
   * Direction from the robot to the ball.
   *
   * @return y of the unit normal
   */
  public double normalY() {
    return normalY;
  }
}
