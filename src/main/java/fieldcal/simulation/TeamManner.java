package fieldcal.simulation;

import java.util.Objects;

/**
 * What the robots of a match are like beyond their team's limits.
 *
 * @param facing where robots look that are not at the ball
 * @param weakRobot number of a robot in each team that accelerates and brakes less than the others; −1 for none
 * @param strength of that robot in parts of the others', above 0
 */
public record TeamManner(Facing facing, int weakRobot, double strength) {
  /** All look at the ball, all are alike. */
  public static final TeamManner USUAL = new TeamManner(Facing.BALL, -1, 1);

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
   * @throws IllegalArgumentException when the number is below −1 or the strength not in (0, 2] (or NaN)
   */
  public TeamManner {
    Objects.requireNonNull(facing, "facing");
    if (weakRobot < -1 || !(strength > 0 && strength <= 2)) {
      throw new IllegalArgumentException(
          "robot and strength must lie in [-1, …] and (0, 2]: " + weakRobot + ", " + strength);
    }
  }

  /**
   * Robots that look elsewhere.
   *
   * @param next where
   * @return the changed manner
   */
  public TeamManner withFacing(Facing next) {
    return new TeamManner(next, weakRobot, strength);
  }

  /**
   * One robot of each team is weaker.
   *
   * @param robot its number
   * @param part of the others' acceleration and braking
   * @return the changed manner
   */
  public TeamManner withWeakRobot(int robot, double part) {
    return new TeamManner(facing, robot, part);
  }
}
