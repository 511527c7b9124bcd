package fieldcal.movement;

import fieldcal.vision.RobotId;

/**
 * A part of a robot's turning in which its angular acceleration was constant, fitted to the orientations to reduce their noise. Positive is counter-clockwise.
 *
 * @param robot who turned
 * @param start when it began, s since the recording's epoch
 * @param duration s
 * @param angularVelocity at the start, rad/s
 * @param angularAcceleration rad/s²
 * @param accelerationError standard error of the angular acceleration, rad/s²
 * @param velocityError standard error of the angular velocity in the middle, rad/s
 * @param corner time at its beginning and at its end in which the angular acceleration was still changing, s
 * @param overshoot by how much the rate at an end may exceed the robot's true rate, rad/s; see {@link Manoeuvre#overshoot}
 */
public record Turn(
    RobotId robot,
    double start,
    double duration,
    double angularVelocity,
    double angularAcceleration,
    double accelerationError,
    double velocityError,
    double corner,
    double overshoot) {

  /** A manoeuvre of a path whose x is an angle. */
  static Turn of(Manoeuvre m) {
    return new Turn(
        m.robot(),
        m.start(),
        m.duration(),
        m.vx(),
        m.ax(),
        m.accelerationError(),
        m.velocityError(),
        m.corner(),
        m.overshoot());
  }

  /**
   * How fast it turns at a time after the start, whichever way.
   *
   * @param after s
   * @return rad/s, not negative
   */
  public double rateAfter(double after) {
    return Math.abs(angularVelocity + after * angularAcceleration);
  }

  /**
   * How much the rate of turning grows from beginning to end.
   *
   * @return rad/s, negative when the robot stops turning
   */
  public double growth() {
    return rateAfter(duration) - rateAfter(0);
  }
}
