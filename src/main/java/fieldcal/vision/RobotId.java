package fieldcal.vision;

import java.util.Comparator;
import java.util.Objects;

/**
 * Names one robot on the field.
 *
 * <p>Ordered by team, then number.
 *
 * @param team the robot's team
 * @param number the number of its marker pattern, 0 … 15 in the league's rules; larger ones are tolerated
 */
public record RobotId(Team team, int number) implements Comparable<RobotId> {
  private static final Comparator<RobotId> ORDER =
      Comparator.comparing(RobotId::team).thenComparingInt(RobotId::number);

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException if the team is null
   * @throws IllegalArgumentException if the number is negative
   */
  public RobotId {
    Objects.requireNonNull(team, "team");
    if (number < 0) {
      throw new IllegalArgumentException("robot number must not be negative, got " + number);
    }
  }

  /** The same in every process, unlike that of an enum, so that hash maps of robots are iterated in the same order and give the same sums. */
  @Override
  public int hashCode() {
    return 31 * team.ordinal() + number;
  }

  @Override
  public int compareTo(RobotId other) {
    return ORDER.compare(this, other);
  }

  /**
   * The name for people.
   *
   * @return for example {@code yellow 3}
   */
  @Override
  public String toString() {
    return team.label() + " " + number;
  }
}
