package fieldcal.movement;

import java.util.Objects;

/**
 * A robot that accelerates or brakes clearly differently from its team mates, for example with a weak motor.
 *
 * @param robot number
 * @param quantity {@code acceleration} or {@code braking}
 * @param value its own limit, m/s², along the front and from standstill where the team's depends on direction or speed
 * @param standardError of the value, m/s²
 * @param ofOthers the median of its team mates' limits, m/s²
 * @param manoeuvres number of its manoeuvres that lie at its limit
 */
public record RobotDifference(
    int robot,
    String quantity,
    double value,
    double standardError,
    double ofOthers,
    long manoeuvres) {

  /**
   * Checks the word. {@inheritDoc}
   *
   * @throws NullPointerException when it is null
   */
  public RobotDifference {
    Objects.requireNonNull(quantity, "quantity");
  }

  /**
   * The ratio of its limit to that of its team mates.
   *
   * @return the ratio (–), below 1 for a weak robot
   */
  public double ratio() {
    return value / ofOthers;
  }
}
