package fieldcal.movement;

import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;

/** Estimates a team's limits from its statistics. */
public final class LimitEstimator {
  private LimitEstimator() {}

  /**
   * Estimates the limits of a team. This takes from 20 ms to some tenths of a second, longer when effects are named. So do not call it on the thread that reads frames: copy the statistics there by merging them into new ones, and estimate from the copy on another thread.
   *
   * @param team which
   * @param statistics what was counted; stays as it is
   * @return limits with standard errors or the reason why there are none, and the league's estimates
   */
  public static TeamLimits estimate(Team team, TeamStatistics statistics) {
    VelocityLimit speeds =
        new VelocityLimit(statistics.speeds(), "the robots never kept driving at a highest speed");
    LimitEstimate velocity = speeds.estimate();
    ManoeuvreTables faster = statistics.acceleratingManoeuvres();
    ManoeuvreTables slower = statistics.brakingManoeuvres();
    AccelerationLimit acceleration =
        new AccelerationLimit(
            faster.all(),
            AccelerationLimit.Kind.ACCELERATION,
            velocity.value(),
            statistics.robots());
    AccelerationLimit braking =
        AccelerationLimit.braking(
            slower.all(), velocity.value(), statistics.robots(), acceleration);
    List<Envelope> envelopes = new ArrayList<>();
    acceleration.byDirection().ifPresent(envelopes::add);
    braking.byDirection().ifPresent(envelopes::add);
    List<RobotDifference> robots =
        new ArrayList<>(RobotComparison.of(faster, acceleration, "acceleration"));
    robots.addAll(RobotComparison.of(slower, braking, "braking"));
    List<LimitDeviation> deviations = new ArrayList<>(acceleration.deviations());
    deviations.addAll(braking.deviations());
    LeagueStatistics league = statistics.league();
    return new TeamLimits(
        team,
        velocity,
        acceleration.estimate(),
        braking.estimate(),
        league.velocityLimit(),
        league.accelerationLimit(),
        league.brakingLimit(),
        deviations,
        speeds.caps(velocity),
        TurnLimits.of(statistics),
        envelopes,
        robots,
        statistics.manoeuvres());
  }
}
