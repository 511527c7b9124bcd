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
    Observations observations) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public Kick {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(end, "end");
    Objects.requireNonNull(observations, "observations");
    if (!(endTime >= time)) {
      throw new IllegalArgumentException(
          "kick ends at " + endTime + " before it starts at " + time);
    }
  }

  /**
   * This kick with another running number.
   *
   * @param newId the number
   * @return the renumbered kick
   */
  public Kick withId(int newId) {
    return new Kick(newId, time, x, y, vx, vy, robot, fromRest, end, endTime, observations);
  }

  /**
   * This kick with other detections.
   *
   * @param newObservations the detections
   * @return the changed copy
   */
  public Kick withObservations(Observations newObservations) {
    return new Kick(id, time, x, y, vx, vy, robot, fromRest, end, endTime, newObservations);
  }
}
