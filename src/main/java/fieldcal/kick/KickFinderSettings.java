package fieldcal.kick;

/**
 * Thresholds of kick finding.
 *
 * @param minSpeed slower balls are pushed, not kicked, m/s
 * @param minJump smallest change of velocity that counts as a kick, m/s
 * @param robotReach largest distance between the centres of a ball and of a robot that can have kicked it, m: 90 mm robot radius, 21.5 mm ball
 *     radius, and as much again for the offset between the cameras that saw them
 * @param stopSpeed a ball that is slower than this over {@code stopSpan} counts as at rest, m/s
 * @param stopSpan time over which that speed is measured, s
 * @param lostAfter a ball that no camera sees for longer is lost, s
 * @param restSpan how much of the rest before a kick is kept, s
 */
public record KickFinderSettings(
    double minSpeed,
    double minJump,
    double robotReach,
    double stopSpeed,
    double stopSpan,
    double lostAfter,
    double restSpan) {

  /**
   * Checks that all are positive. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is not positive or is NaN
   */
  public KickFinderSettings {
    for (double v :
        new double[] {minSpeed, minJump, robotReach, stopSpeed, stopSpan, lostAfter, restSpan}) {
      if (!(v > 0)) {
        throw new IllegalArgumentException("kick finder setting must be positive: " + v);
      }
    }
  }

  /**
   * Settings for SSL fields. The stop speed is what a ball rolling at −0.28 m/s² has 0.1 s before it rests, five times the error
   * of a velocity from 0.35 s of detections with 2 mm noise; the minimal speed keeps pushes by a robot driving up (0.5 m/s) out.
   *
   * @return the defaults
   */
  public static KickFinderSettings defaults() {
    return new KickFinderSettings(0.7, 0.6, 0.2, 0.03, 0.35, 0.5, 0.6);
  }
}
