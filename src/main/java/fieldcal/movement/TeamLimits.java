package fieldcal.movement;

import fieldcal.vision.Team;
import java.util.List;
import java.util.Objects;

/**
 * How a team's robots can move.
 *
 * @param team which
 * @param velocity m/s
 * @param acceleration m/s²; with a named effect that at standstill and along the front
 * @param braking m/s², positive; with a named effect that along the front
 * @param leagueVelocity the league's estimate, m/s
 * @param leagueAcceleration the league's estimate, m/s²
 * @param leagueBraking the league's estimate, m/s², positive
 * @param deviations what uniform limits get wrong
 * @param speedCaps robots with a lower limit of their own
 * @param manoeuvres pieces of constant acceleration that were fitted
 */
public record TeamLimits(
    Team team,
    LimitEstimate velocity,
    LimitEstimate acceleration,
    LimitEstimate braking,
    LimitEstimate leagueVelocity,
    LimitEstimate leagueAcceleration,
    LimitEstimate leagueBraking,
    List<LimitDeviation> deviations,
    List<SpeedCap> speedCaps,
    long manoeuvres) {

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public TeamLimits {
    Objects.requireNonNull(team, "team");
    Objects.requireNonNull(velocity, "velocity");
    Objects.requireNonNull(acceleration, "acceleration");
    Objects.requireNonNull(braking, "braking");
    Objects.requireNonNull(leagueVelocity, "leagueVelocity");
    Objects.requireNonNull(leagueAcceleration, "leagueAcceleration");
    Objects.requireNonNull(leagueBraking, "leagueBraking");
    deviations = List.copyOf(deviations);
    speedCaps = List.copyOf(speedCaps);
  }
}
