package fieldcal.play;

import fieldcal.vision.RobotId;

/**
 * A kick that was made.
 *
 * @param number running number of this play, from 1; failed ones count
 * @param planned what was wanted
 * @param robot who kicked
 * @param time when a camera first showed that the ball moved, s: by the time stamp of its frame, some hundredths after the kick, however late vision is
 * @param x where the ball lay, m
 * @param y where the ball lay, m
 * @param direction in which the robot was to kick, rad, counter-clockwise from x
 * @param ended when the ball was no longer left alone, s
 * @param end what ended it
 */
public record PlayedKick(
    int number,
    PlannedKick planned,
    RobotId robot,
    double time,
    double x,
    double y,
    double direction,
    double ended,
    End end) {

  /** Why a ball was no longer left alone. */
  public enum End {
    /** It came to rest. */
    STOPPED,
    /** It left the field. */
    LEFT_FIELD,
    /** The receiver has it, or it bounced off a robot. */
    RECEIVED,
    /** No camera saw it any more. */
    LOST,
    /** It took too long. */
    TIMEOUT
  }
}
