package fieldcal.simulation.robot;

/**
 * What a robot can do.
 *
 * @param velocity largest speed, m/s
 * @param acceleration largest acceleration, m/s²
 * @param braking largest deceleration, m/s², positive
 * @param angularVelocity rad/s
 * @param angularAcceleration rad/s²
 * @param torqueLoss the acceleration falls linearly with speed: × (1 − torqueLoss·|v|/velocity)
 * @param directionality acceleration and braking sideways are smaller: × (1 − directionality·sin²φ), φ from the robot's front
 */
public record RobotLimits(
    double velocity,
    double acceleration,
    double braking,
    double angularVelocity,
    double angularAcceleration,
    double torqueLoss,
    double directionality) {

  /** A usual robot. */
  public static final RobotLimits DEFAULT = new RobotLimits(3, 3, 3.5, 10, 40, 0, 0);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a limit is not positive or a share not in [0, 0.95] (or NaN)
   */
  public RobotLimits {
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
   * @param velocity m/s
   * @param acceleration m/s²
   * @param braking m/s²
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
        directionality);
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
        coefficient);
  }
}
