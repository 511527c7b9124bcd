package fieldcal.movement;

import fieldcal.vision.Team;
import java.util.List;
import java.util.Objects;

/**
 * How a team's robots can move.
 *
 * @param team which
 * @param velocity m/s
 * @param acceleration limit of speeding up, m/s²; where an effect is named, the limit at standstill and along the front; with an envelope of another shape, that of the strongest direction
 * @param braking limit of slowing down, m/s², positive; where an effect is named, the limit along the front; with an envelope of another shape, that of the strongest direction
 * @param leagueVelocity the league's estimate, m/s
 * @param leagueAcceleration the league's estimate, m/s²
 * @param leagueBraking the league's estimate, m/s², positive
 * @param deviations what uniform limits get wrong
 * @param speedCaps robots with a lower limit of their own
 * @param turning how fast they turn
 * @param envelopes the limits of acceleration and of braking by direction in the robot's own frame; empty with too few manoeuvres
 * @param robots that accelerate or brake clearly differently from their team mates
 * @param manoeuvres number of pieces of constant acceleration that were fitted
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
    TurnLimits turning,
    List<Envelope> envelopes,
    List<RobotDifference> robots,
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
    Objects.requireNonNull(turning, "turning");
    envelopes = List.copyOf(envelopes);
    robots = List.copyOf(robots);
  }
}
