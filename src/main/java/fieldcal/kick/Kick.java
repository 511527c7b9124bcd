package fieldcal.kick;

import fieldcal.vision.RobotId;
import java.util.Objects;
import java.util.Optional;

/**
 * One kick and everything the cameras saw of the ball from shortly before it until its end.
 *
 * @param id running number within the recording, from 1
 * @param time estimated time of the kick, s since the recording's epoch; good to a few milliseconds, the fit refines it
 * @param x estimated position of the kick, m
 * @param y estimated position of the kick, m
 * @param vx apparent velocity right after the kick, m/s; for a chip this is the velocity of its projection on the ground
 * @param vy apparent velocity right after the kick, m/s
 * @param robot who kicked, if a robot was near enough
 * @param fromRest whether the ball lay still before; then the observations before {@code time} pin the position of the kick
 * @param end why the observations end
 * @param endTime when they end, s
 * @param observations all detections of this ball, unfiltered, those before the kick included when it was at rest
 * @param afterDribbling whether the kicker had moved with the ball at its front before, or caught it there; then the ball may spin
 * @param timeError standard error of {@code time} where no rest pins the position of the kick, s
 */
public record Kick(
    int id,
    double time,
    double x,
    double y,
    double vx,
    double vy,
    Optional<RobotId> robot,
    boolean fromRest,
    KickEnd end,
    double endTime,
    Observations observations,
    boolean afterDribbling,
    double timeError) {

  /** Standard error of the time at which the line before a kick and the line after it cross, s. */
  public static final double CROSSING_ERROR = 0.004;

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the robot, the end or the observations are null
   * @throws IllegalArgumentException when {@code timeError} is not positive or {@code endTime} is before {@code time}
   */
  public Kick {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(end, "end");
    Objects.requireNonNull(observations, "observations");
    if (!(timeError > 0)) {
      throw new IllegalArgumentException("error of a time must be positive, but is " + timeError);
    }
    if (!(endTime >= time)) {
      throw new IllegalArgumentException(
          "kick ends at " + endTime + " before it starts at " + time);
    }
  }

  /**
   * A kick without dribbling before it, whose time has the usual error, {@link #CROSSING_ERROR}.
   *
   * @param id running number within the recording, from 1
   * @param time estimated time of the kick, s since the recording's epoch
   * @param x estimated position of the kick, m
   * @param y estimated position of the kick, m
   * @param vx apparent velocity right after the kick, m/s
   * @param vy apparent velocity right after the kick, m/s
   * @param robot who kicked, if a robot was near enough
   * @param fromRest whether the ball lay still before
   * @param end why the observations end
   * @param endTime when they end, s since the recording's epoch; not before {@code time}
   * @param observations all detections of this ball
   */
  public Kick(
      int id,
      double time,
      double x,
      double y,
      double vx,
      double vy,
      Optional<RobotId> robot,
      boolean fromRest,
      KickEnd end,
      double endTime,
      Observations observations) {
    this(
        id, time, x, y, vx, vy, robot, fromRest, end, endTime, observations, false, CROSSING_ERROR);
  }

  /**
   * This kick with another running number.
   *
   * @param newId the number
   * @return the renumbered kick
   */
  public Kick withId(int newId) {
    return new Kick(
        newId,
        time,
        x,
        y,
        vx,
        vy,
        robot,
        fromRest,
        end,
        endTime,
        observations,
        afterDribbling,
        timeError);
  }

  /**
   * This kick with other detections.
   *
   * @param newObservations the detections
   * @return the changed copy
   */
  public Kick withObservations(Observations newObservations) {
    return new Kick(
        id,
        time,
        x,
        y,
        vx,
        vy,
        robot,
        fromRest,
        end,
        endTime,
        newObservations,
        afterDribbling,
        timeError);
  }
}
