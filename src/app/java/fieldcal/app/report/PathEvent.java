package fieldcal.app.report;

import java.util.Objects;

/**
 * Something that happens on the fitted trajectory.
 *
 * @param type what
 * @param t time since the kick, s
 * @param x where, m
 * @param y where, m
 */
public record PathEvent(
    Type type, @Rounded(4) double t, @Rounded(4) double x, @Rounded(4) double y) {

  /** Checks that the type is there. */
  public PathEvent {
    Objects.requireNonNull(type, "type");
  }

  /** What can happen; the kick itself is no event, it is at t = 0. */
  public enum Type {
    /** A chipped ball touches the ground. */
    LANDING,
    /** From here on the ball rolls. */
    ROLLING,
    /** The ball comes to rest. */
    STOP
  }
}
