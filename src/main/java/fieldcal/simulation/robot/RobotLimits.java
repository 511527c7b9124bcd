package fieldcal.simulation.robot;

import java.util.Objects;

/**
 * What a robot can do.
 *
 * @param velocity largest speed, m/s
 * @param acceleration largest acceleration, m/s²
 * @param braking largest deceleration, m/s², positive
 * @param angularVelocity largest angular velocity, rad/s
 * @param angularAcceleration rad/s²
 * @param torqueLoss the acceleration falls linearly with speed: × (1 − torqueLoss·|v|/velocity)
 * @param directionality acceleration and braking are smaller in the weakest direction: × (1 − directionality)
 * @param shape how they depend on the direction in between
 */
public record RobotLimits(
    double velocity,
    double acceleration,
    double braking,
    double angularVelocity,
    double angularAcceleration,
    double torqueLoss,
    double directionality,
    DirectionShape shape) {

  /** The part of its angular acceleration with which a robot plans to end a turn. */
  public static final double PLANNED_TURN_BRAKING = 0.8;

  /** A usual robot. */
  public static final RobotLimits DEFAULT = new RobotLimits(3, 3, 3.5, 10, 40, 0, 0);

  /**
   * Limits with the usual shape.
   *
   * @param velocity largest speed, m/s
   * @param acceleration largest acceleration, m/s²
   * @param braking m/s², positive
   * @param angularVelocity largest angular velocity, rad/s
   * @param angularAcceleration rad/s²
   * @param torqueLoss 0 … 0.95
   * @param directionality 0 … 0.95
   */
  public RobotLimits(
      double velocity,
      double acceleration,
      double braking,
      double angularVelocity,
      double angularAcceleration,
      double torqueLoss,
      double directionality) {
    this(
        velocity,
        acceleration,
        braking,
        angularVelocity,
        angularAcceleration,
        torqueLoss,
        directionality,
        DirectionShape.SINE);
  }

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a limit is not in (0, 1000) or a coefficient is not in [0, 0.95] (or NaN)
   */
  public RobotLimits {
    Objects.requireNonNull(shape, "shape");
    double[] positive = {velocity, acceleration, braking, angularVelocity, angularAcceleration};
    for (double value : positive) {
      if (!(value > 0 && value < 1000)) {
        throw new IllegalArgumentException("limit must be positive, but is " + value);
      }
    }
    if (!(torqueLoss >= 0 && torqueLoss <= 0.95 && directionality >= 0 && directionality <= 0.95)) {
      throw new IllegalArgumentException(
          "coefficients must lie in [0, 0.95]: " + torqueLoss + ", " + directionality);
    }
  }

  /**
   * Limits with one acceleration law.
   *
   * @param velocity largest speed, m/s
   * @param acceleration largest acceleration, m/s²
   * @param braking largest deceleration, m/s², positive
   * @return the limits
   */
  public static RobotLimits uniform(double velocity, double acceleration, double braking) {
    return new RobotLimits(velocity, acceleration, braking, 10, 40, 0, 0);
  }

  /**
   * Another torque limit.
   *
   * @param coefficient 0 … 0.95
   * @return the changed limits
   */
  public RobotLimits withTorqueLoss(double coefficient) {
    return new RobotLimits(
        velocity,
        acceleration,
        braking,
        angularVelocity,
        angularAcceleration,
        coefficient,
        directionality,
        shape);
  }

  /**
   * Another direction dependence.
   *
   * @param coefficient 0 … 0.95
   * @return the changed limits
   */
  public RobotLimits withDirectionality(double coefficient) {
    return new RobotLimits(
        velocity,
        acceleration,
        braking,
        angularVelocity,
        angularAcceleration,
        torqueLoss,
        coefficient,
        shape);
  }

  /**
   * Another shape.
   *
   * @param next how acceleration and braking depend on the direction
   * @return the changed limits
   */
  public RobotLimits withShape(DirectionShape next) {
    return new RobotLimits(
        velocity,
        acceleration,
        braking,
        angularVelocity,
        angularAcceleration,
        torqueLoss,
        directionality,
        next);
  }

  /**
   * Other limits of turning.
   *
   * @param rate rad/s
   * @param change rad/s²
   * @return the changed limits
   */
  public RobotLimits withTurning(double rate, double change) {
    return new RobotLimits(
        velocity, acceleration, braking, rate, change, torqueLoss, directionality, shape);
  }

  /**
   * A stronger or weaker robot.
   *
   * @param strength factor of acceleration and braking
   * @return the changed limits
   */
  public RobotLimits times(double strength) {
    return new RobotLimits(
        velocity,
        strength * acceleration,
        strength * braking,
        angularVelocity,
        angularAcceleration,
        torqueLoss,
        directionality,
        shape);
  }

  /**
   * The factor on acceleration and braking in a direction.
   *
   * @param phi angle from the robot's front, rad
   * @return 1 − directionality … 1
   */
  public double directionFactor(double phi) {
    return shape.factor(directionality, phi);
  }
}
