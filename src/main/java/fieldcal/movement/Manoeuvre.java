package fieldcal.movement;

import fieldcal.vision.RobotId;

/**
 * A part of a robot's path in which its acceleration was constant, fitted to the detections to reduce their noise. Velocities in the field frame.
 *
 * @param robot who drove
 * @param start when it began, s since the recording's epoch
 * @param duration s
 * @param vx velocity along x at the start, m/s
 * @param vy velocity along y at the start, m/s
 * @param ax acceleration along x, m/s²
 * @param ay acceleration along y, m/s²
 * @param accelerationError standard error of the acceleration along its own direction, m/s²
 * @param velocityError standard error of each component of the velocity in the middle of the manoeuvre, m/s
 * @param corner time at its beginning and at its end in which the acceleration was still changing, s
 * @param overshoot by how much the speed at an end may exceed the robot's true speed, m/s: a stay at its highest speed may be too short to be distinguished from the noise, and two pieces then meet in a peak above it
 * @param orientation mean direction of the robot's front, rad, counter-clockwise from x; NaN when it turned by more than a radian or was not reported
 * @param detections number of detections in it
 */
public record Manoeuvre(
    RobotId robot,
    double start,
    double duration,
    double vx,
    double vy,
    double ax,
    double ay,
    double accelerationError,
    double velocityError,
    double corner,
    double overshoot,
    double orientation,
    int detections) {

  /**
   * Size of the acceleration. The errors of the two components make the length of the vector too large; this bias is removed.
   *
   * @return m/s², not negative
   */
  public double acceleration() {
    return Math.sqrt(Math.max(0, ax * ax + ay * ay - accelerationError * accelerationError));
  }

  /**
   * Speed at a time after the start.
   *
   * @param after s
   * @return m/s
   */
  public double speedAfter(double after) {
    return Math.hypot(vx + after * ax, vy + after * ay);
  }

  /**
   * Speed in the middle.
   *
   * @return m/s
   */
  public double speed() {
    return speedAfter(0.5 * duration);
  }

  /**
   * How fast the speed grows at a time after the start.
   *
   * @param after s
   * @return m/s², negative when it falls; 0 at rest
   */
  public double speedGrowth(double after) {
    double x = vx + after * ax;
    double y = vy + after * ay;
    double speed = Math.hypot(x, y);
    return speed == 0 ? 0 : (x * ax + y * ay) / speed;
  }
}
