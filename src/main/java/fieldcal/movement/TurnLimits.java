package fieldcal.movement;

import java.util.Locale;
import java.util.Objects;

/**
 * How fast a team's robots turn, from the orientations that vision reports, with their noise taken out. In most matches these are not determined: robots that face the ball seldom turn by much, and never at a constant rate.
 *
 * @param velocity highest rate of turning, rad/s
 * @param acceleration limit of turning faster, rad/s²
 * @param braking limit of turning slower, rad/s², positive
 * @param turns number of pieces of constant angular acceleration that changed the rate of turning by at least {@link TeamStatistics#LEAST_TURN}
 */
public record TurnLimits(
    LimitEstimate velocity, LimitEstimate acceleration, LimitEstimate braking, long turns) {

  /**
   * Checks the estimates. {@inheritDoc}
   *
   * @throws NullPointerException when one is null
   */
  public TurnLimits {
    Objects.requireNonNull(velocity, "velocity");
    Objects.requireNonNull(acceleration, "acceleration");
    Objects.requireNonNull(braking, "braking");
  }

  static TurnLimits of(TeamStatistics team) {
    ManoeuvreTable faster = team.turningFaster().all();
    ManoeuvreTable slower = team.turningSlower().all();
    long turns = faster.samples() + slower.samples();
    LimitEstimate velocity = velocity(team.turnSpeeds(), turns);
    return new TurnLimits(
        velocity,
        unlessTooShort(limit(faster, AccelerationLimit.Kind.TURNING, team.robots()), velocity),
        unlessTooShort(limit(slower, AccelerationLimit.Kind.TURN_BRAKING, team.robots()), velocity),
        turns);
  }

  /** A lower bound, if the robots come to the highest rate that was seen in less time than a piece of constant acceleration needs to be distinguished from noise. Then the corners at both ends take away some of the acceleration. */
  static LimitEstimate unlessTooShort(LimitEstimate change, LimitEstimate velocity) {
    boolean known = change.known() && velocity.known();
    if (!known || velocity.value() >= Pieces.SHORTEST_TOLD * change.value()) {
      return change;
    }
    String note =
        String.format(
            Locale.ROOT,
            "the robots turn at their highest rate within %.2f s, which is too short to measure"
                + " more than a lower bound",
            velocity.value() / change.value());
    return new LimitEstimate(change.value(), change.standardError(), change.samples(), false, note);
  }

  private static LimitEstimate velocity(SpeedTable speeds, long turns) {
    return turns < AccelerationLimit.FEWEST
        ? tooFew(turns)
        : new VelocityLimit(speeds, "the robots never turned at a constant highest rate")
            .estimate();
  }

  private static LimitEstimate limit(
      ManoeuvreTable table, AccelerationLimit.Kind kind, int robots) {
    return table.samples() < AccelerationLimit.FEWEST
        ? tooFew(table.samples())
        : new AccelerationLimit(table, kind, Double.NaN, robots).estimate();
  }

  private static LimitEstimate tooFew(long seen) {
    return LimitEstimate.undetermined(
        seen,
        "the robots hardly ever turned by much: this needs "
            + AccelerationLimit.FEWEST
            + " turns that change the rate by "
            + (int) TeamStatistics.LEAST_TURN
            + " rad/s");
  }
}
