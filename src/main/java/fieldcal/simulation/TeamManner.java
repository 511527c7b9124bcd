package fieldcal.simulation;

import java.util.Objects;

/**
 * What the robots of a match are like beyond their team's limits.
 *
 * @param facing where robots look that are not at the ball
 * @param weakRobot number of a robot in each team that accelerates and brakes less than the others; −1 for none
 * @param strength acceleration and braking of that robot as a fraction of the others', above 0, at most 2
 * @param difference relative standard deviation of the robots' acceleration and braking about their team's (–), 0 to 0.1
 * @param settling time in which a robot's acceleration changes evenly from one value to another, s, 0 to 1; 0 = it changes at once
 */
public record TeamManner(
    Facing facing, int weakRobot, double strength, double difference, double settling) {
  /** All look at the ball, all are alike, and their acceleration changes at once. */
  public static final TeamManner USUAL = new TeamManner(Facing.BALL, -1, 1, 0, 0);

  /** Where a robot looks. */
  public enum Facing {
    /** At the ball: it turns with the ball, seldom by much. */
    BALL,
    /** Where it drives to: it turns by up to half a turn at each new target. */
    TARGET
  }

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the number is below −1, the strength not in (0, 2], the difference not in [0, 0.1] or the settling time not in [0, 1] (or NaN)
   */
  public TeamManner {
    Objects.requireNonNull(facing, "facing");
    if (weakRobot < -1 || !(strength > 0 && strength <= 2)) {
      throw new IllegalArgumentException(
          "robot and strength must lie in [-1, …] and (0, 2]: " + weakRobot + ", " + strength);
    }
    if (!(difference >= 0 && difference <= 0.1 && settling >= 0 && settling <= 1)) {
      throw new IllegalArgumentException(
          "difference and settling time must lie in [0, 0.1] and [0, 1]: "
              + difference
              + ", "
              + settling);
    }
  }

  /**
   * Robots that look elsewhere.
   *
   * @param next where
   * @return the changed manner
   */
  public TeamManner withFacing(Facing next) {
    return new TeamManner(next, weakRobot, strength, difference, settling);
  }

  /**
   * One robot of each team is weaker.
   *
   * @param robot its number
   * @param part of the others' acceleration and braking
   * @return the changed manner
   */
  public TeamManner withWeakRobot(int robot, double part) {
    return new TeamManner(facing, robot, part, difference, settling);
  }

  /**
   * Robots that are not all alike.
   *
   * @param deviation standard deviation of their acceleration and braking, in parts
   * @return the changed manner
   */
  public TeamManner withDifference(double deviation) {
    return new TeamManner(facing, weakRobot, strength, deviation, settling);
  }

  /**
   * Robots whose acceleration does not change at once, as with a limited jerk.
   *
   * @param seconds that a change takes
   * @return the changed manner
   */
  public TeamManner withSettling(double seconds) {
    return new TeamManner(facing, weakRobot, strength, difference, seconds);
  }
}
