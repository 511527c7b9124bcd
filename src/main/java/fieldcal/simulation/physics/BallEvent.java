package fieldcal.simulation.physics;

/**
 * A change in the ball's motion, at the instant it happened.
 *
 * @param kind what
 * @param time session time, s
 * @param x position, m
 * @param y position, m
 * @param vxBefore velocity before, m/s
 * @param vyBefore velocity before, m/s
 * @param vzBefore velocity before, m/s
 * @param vxAfter velocity after, m/s
 * @param vyAfter velocity after, m/s
 * @param vzAfter velocity after, m/s
 */
public record BallEvent(
    Kind kind,
    double time,
    double x,
    double y,
    double vxBefore,
    double vyBefore,
    double vzBefore,
    double vxAfter,
    double vyAfter,
    double vzAfter) {

  /** What can happen to a ball that nobody touches. */
  public enum Kind {
    /** It met the carpet and flies on. */
    BOUNCE,
    /** It met the carpet and stays there. */
    LAND,
    /** Its contact point stopped slipping. */
    SLIDE_TO_ROLL,
    /** It crossed a seam of the carpet. */
    SEAM,
    /** It came to rest. */
    STOP
  }
}
