package fieldcal.simulation.robot;

import fieldcal.simulation.imaging.RobotView;
import fieldcal.simulation.robot.RobotCommand.Target;
import fieldcal.simulation.robot.RobotCommand.Velocity;
import fieldcal.vision.RobotId;
import java.util.Arrays;

/** A robot that moves in the plane within its limits. Mutable, for one thread. */
public final class SimulatedRobot {
  /** Distance from the centre to the dribbler's plane, m (typical of the league's robots). */
  public static final double FRONT = 0.075;

  /** Half the width of the mouth in front, m. */
  public static final double MOUTH = 0.055;

  private final RobotId id;
  private final RobotLimits limits;
  private final double height;
  private double x;
  private double y;
  private double orientation;
  private double vx;
  private double vy;

  // The velocity that it would have if its acceleration changed at once, m/s.
  private double planX;
  private double planY;
  private double angular;
  private RobotCommand command = RobotCommand.HALT;
  private double settling;
  private Settling settled;

  /** The mean velocity over the last steps: where the velocity's slope changes at once, that of its mean changes evenly over these steps. */
  private static final class Settling {
    private final double[] x;
    private final double[] y;
    private double sumX;
    private double sumY;
    private int next;

    Settling(int steps, double vx, double vy) {
      x = new double[steps];
      y = new double[steps];
      Arrays.fill(x, vx);
      Arrays.fill(y, vy);
      sumX = steps * vx;
      sumY = steps * vy;
    }

    void add(double vx, double vy) {
      sumX += vx - x[next];
      sumY += vy - y[next];
      x[next] = vx;
      y[next] = vy;
      next = (next + 1) % x.length;
    }
  }

  /**
   * A robot at rest.
   *
   * @param id team and number
   * @param limits what it can do
   * @param height of its top, m
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param orientation direction of its front, rad, 0 = along x, counter-clockwise
   */
  public SimulatedRobot(
      RobotId id, RobotLimits limits, double height, double x, double y, double orientation) {
    this.id = id;
    this.limits = limits;
    this.height = height;
    this.x = x;
    this.y = y;
    this.orientation = orientation;
  }

  /**
   * Commands the robot until the next command.
   *
   * @param next the command
   */
  public void command(RobotCommand next) {
    command = next;
  }

  /**
   * Lets its acceleration change evenly from one value to another instead of at once, as with a limited jerk. It then reaches a target a little later than it plans.
   *
   * @param seconds that a change takes, not negative; 0: it changes at once
   */
  public void settles(double seconds) {
    settling = seconds;
    settled = null;
  }

  /**
   * The last command.
   *
   * @return the command
   */
  public RobotCommand command() {
    return command;
  }

  /**
   * Puts it somewhere at rest, as a person does by hand.
   *
   * @param newX x in the field frame, m
   * @param newY y in the field frame, m
   * @param newOrientation direction of its front, rad, 0 = along x, counter-clockwise
   */
  public void place(double newX, double newY, double newOrientation) {
    x = newX;
    y = newY;
    orientation = newOrientation;
    vx = 0;
    vy = 0;
    planX = 0;
    planY = 0;
    settled = null;
    angular = 0;
  }

  /**
   * Moves it.
   *
   * @param step s
   */
  public void move(double step) {
    double wantedX;
    double wantedY;
    double wantedAngular;
    if (command.motion() instanceof Velocity velocity) {
      wantedX = velocity.vx();
      wantedY = velocity.vy();
      wantedAngular = velocity.angular();
    } else {
      Target target = (Target) command.motion();
      double dx = target.x() - x;
      double dy = target.y() - y;
      double distance = Math.hypot(dx, dy);
      // Brake a little earlier than the limits demand, so that the target is not overshot.
      double back = Math.atan2(-dy, -dx) - orientation;
      double braking = 0.97 * limits.braking() * limits.directionFactor(back);
      double speed =
          Math.min(Math.min(target.maxSpeed(), Math.sqrt(2 * braking * distance)), distance / 0.05);
      wantedX = distance == 0 ? 0 : speed * dx / distance;
      wantedY = distance == 0 ? 0 : speed * dy / distance;
      double turn = Math.IEEEremainder(target.orientation() - orientation, 2 * Math.PI);
      double rate =
          Math.min(
              Math.sqrt(
                  2
                      * RobotLimits.PLANNED_TURN_BRAKING
                      * limits.angularAcceleration()
                      * Math.abs(turn)),
              Math.abs(turn) / 0.04);
      wantedAngular = Math.copySign(rate, turn);
    }
    accelerate(wantedX, wantedY, wantedAngular, step);
    settle(step);
    x += step * vx;
    y += step * vy;
    orientation += step * angular;
  }

  private void settle(double step) {
    int steps = (int) Math.round(settling / step);
    if (steps < 2) {
      vx = planX;
      vy = planY;
      return;
    }
    if (settled == null) {
      settled = new Settling(steps, vx, vy);
    }
    settled.add(planX, planY);
    vx = settled.sumX / steps;
    vy = settled.sumY / steps;
  }

  private void accelerate(double wantedX, double wantedY, double wantedAngular, double step) {
    double wanted = Math.hypot(wantedX, wantedY);
    double cap = wanted > limits.velocity() ? limits.velocity() / wanted : 1;
    double changeX = cap * wantedX - planX;
    double changeY = cap * wantedY - planY;
    double change = Math.hypot(changeX, changeY);
    if (change > 0) {
      double direction = limits.directionFactor(Math.atan2(changeY, changeX) - orientation);
      boolean brakes = changeX * planX + changeY * planY < 0;
      double most =
          brakes
              ? limits.braking()
              : limits.acceleration()
                  * Math.max(
                      0.05, 1 - limits.torqueLoss() * Math.hypot(planX, planY) / limits.velocity());
      double share = Math.min(1, most * direction * step / change);
      planX += share * changeX;
      planY += share * changeY;
    }
    double turn =
        Math.max(-limits.angularVelocity(), Math.min(limits.angularVelocity(), wantedAngular));
    double most = limits.angularAcceleration() * step;
    angular += Math.max(-most, Math.min(most, turn - angular));
  }

  /**
   * Distance of a point ahead of the centre.
   *
   * @param px x in the field frame, m
   * @param py y in the field frame, m
   * @return m along the robot's front
   */
  public double ahead(double px, double py) {
    return Math.cos(orientation) * (px - x) + Math.sin(orientation) * (py - y);
  }

  /**
   * Distance of a point to the left of the centre.
   *
   * @param px x in the field frame, m
   * @param py y in the field frame, m
   * @return m across the robot's front
   */
  public double aside(double px, double py) {
    return -Math.sin(orientation) * (px - x) + Math.cos(orientation) * (py - y);
  }

  /**
   * What cameras see.
   *
   * @return its pose and height now
   */
  public RobotView view() {
    return new RobotView(id, x, y, orientation, height);
  }

  /**
   * Its name.
   *
   * @return team and number
   */
  public RobotId id() {
    return id;
  }

  /**
   * What it can do.
   *
   * @return the limits
   */
  public RobotLimits limits() {
    return limits;
  }

  /**
   * Height of its top.
   *
   * @return m
   */
  public double height() {
    return height;
  }

  /**
   * Position.
   *
   * @return x in the field frame, m
   */
  public double x() {
    return x;
  }

  /**
   * Position.
   *
   * @return y in the field frame, m
   */
  public double y() {
    return y;
  }

  /**
   * Orientation.
   *
   * @return rad, not normalised
   */
  public double orientation() {
    return orientation;
  }

  /**
   * Velocity.
   *
   * @return along x, m/s
   */
  public double vx() {
    return vx;
  }

  /**
   * Velocity.
   *
   * @return along y, m/s
   */
  public double vy() {
    return vy;
  }

  /**
   * Speed.
   *
   * @return m/s
   */
  public double speed() {
    return Math.hypot(vx, vy);
  }
}
