package fieldcal.gamelog;

import fieldcal.vision.RobotId;
import java.util.Objects;
import java.util.Optional;

/**
 * The field at one instant as a tracker reports it: a team's software or an automatic referee. Times count from the recording's epoch, on the tracker's clock.
 *
 * @param source what the tracker calls itself; empty when it does not say
 * @param uuid distinguishes trackers of the same name
 * @param time the instant that the frame shows, s
 * @param ball the ball in play; empty when the tracker sees none
 * @param kick the kick that is under way; empty without one
 * @param robots how many it tracks
 */
public record TrackerFrame(
    String source, String uuid, double time, Optional<Ball> ball, Optional<Kick> kick, int robots) {

  /**
   * Checks that nothing is null. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public TrackerFrame {
    Objects.requireNonNull(source, "source");
    Objects.requireNonNull(uuid, "uuid");
    Objects.requireNonNull(ball, "ball");
    Objects.requireNonNull(kick, "kick");
  }

  /**
   * A tracked ball.
   *
   * @param x m
   * @param y m
   * @param z height above a resting ball, m
   * @param vx m/s; NaN when it is not reported
   * @param vy m/s; NaN when it is not reported
   * @param vz m/s; NaN when it is not reported
   */
  public record Ball(double x, double y, double z, double vx, double vy, double vz) {}

  /**
   * A kick, with what the tracker predicts of it.
   *
   * @param x where the ball was kicked, m
   * @param y where the ball was kicked, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s
   * @param start when, s
   * @param stop when the ball will rest, s; NaN when it is not reported
   * @param stopX where the ball will rest, m; NaN when it is not reported
   * @param stopY where the ball will rest, m; NaN when it is not reported
   * @param robot who kicked; empty when it is not reported
   */
  public record Kick(
      double x,
      double y,
      double vx,
      double vy,
      double vz,
      double start,
      double stop,
      double stopX,
      double stopY,
      Optional<RobotId> robot) {
    /**
     * Speed right after the kick, the vertical part included.
     *
     * @return m/s
     */
    public double speed() {
      return Math.sqrt(vx * vx + vy * vy + vz * vz);
    }
  }
}
