package fieldcal.simulation;

import java.util.Objects;
import java.util.OptionalDouble;

/**
 * A kick to be repeated.
 *
 * @param restFrom session time from which the ball lies at the kick's place, s; the kick's own time when it was moving already
 * @param time session time of the kick, s
 * @param x place of the kick, m
 * @param y place of the kick, m
 * @param vx velocity right after the kick, m/s
 * @param vy velocity right after the kick, m/s
 * @param vz velocity right after the kick, m/s; 0 for a flat kick, positive for a chip
 * @param end session time at which the kick ends, s
 * @param heldAtEnd whether somebody stops the ball then and holds it; else it goes on
 * @param hiddenFrom session time from which nobody sees the ball any more, s
 * @param rollSpin spin about the rolling axis that the kick gave, in units of rolling spin; empty = drawn from the field's kickers
 */
public record ReplayedKick(
    double restFrom,
    double time,
    double x,
    double y,
    double vx,
    double vy,
    double vz,
    double end,
    boolean heldAtEnd,
    double hiddenFrom,
    OptionalDouble rollSpin) {

  /**
   * Checks the order of times. {@inheritDoc}
   *
   * @throws IllegalArgumentException when they are not in order or a number is not finite
   */
  public ReplayedKick {
    Objects.requireNonNull(rollSpin, "rollSpin");
    boolean ordered = restFrom <= time && time <= end && end <= hiddenFrom;
    if (!ordered || !Double.isFinite(x + y + vx + vy + vz + restFrom) || !(vz >= 0)) {
      throw new IllegalArgumentException(
          "kick of "
              + time
              + " s: rests from "
              + restFrom
              + " s, ends at "
              + end
              + " s, hidden from "
              + hiddenFrom
              + " s, velocity ("
              + vx
              + ", "
              + vy
              + ", "
              + vz
              + ") m/s");
    }
  }
}
