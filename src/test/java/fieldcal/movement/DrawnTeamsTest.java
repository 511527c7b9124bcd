package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Limits of drawn teams from frames, many of which never come to their highest speed. Their robots differ by 1 % and change their acceleration within some hundredths of a second. The benchmarks {@code limits} and
 * {@code limit-bounds} have 72 teams each; this is what fits into a build.
 */
class DrawnTeamsTest {
  private static final long SEED = 16;
  private static final int MATCHES = 6;
  private static final double MINUTES = 1.5;
  private static final List<Found> TEAMS = new ArrayList<>();

  /**
   * What was found of one team.
   *
   * @param fastest highest speed that one of its robots had, m/s
   */
  private record Found(TeamLimits limits, RobotLimits truth, double fastest) {
    @Override
    public String toString() {
      return String.format(
          "velocity %s (%.3f, drove %.3f), braking %s (%.3f)",
          limits.velocity(), truth.velocity(), fastest, limits.braking(), truth.braking());
    }
  }

  @BeforeAll
  static void play() {
    RandomStream random = RandomStream.of(SEED, "teams");
    for (int match = 0; match < MATCHES; match++) {
      Map<Team, RobotLimits> truth =
          Map.of(Team.YELLOW, drawn(random, 2, 3.5), Team.BLUE, drawn(random, 4, 6));
      SimulationSettings s =
          SimulationSettings.DEFAULT
              .withSeed(100 * SEED + match)
              .withScenario(
                  ScenarioSettings.of(ScenarioKind.MATCH, 0)
                      .withMatch(6, MINUTES)
                      .withLimits(truth.get(Team.YELLOW), truth.get(Team.BLUE))
                      .withManner(
                          TeamManner.USUAL
                              .withDifference(0.01)
                              .withSettling(random.uniform(0, 0.08))));
      watch(
          s.withCameras(s.cameras().withNoise(0.002, 0.0025).withRegistration(0.0215, 0.023)),
          truth);
    }
  }

  private static RobotLimits drawn(RandomStream random, double slowest, double fastest) {
    return RobotLimits.uniform(
        random.uniform(slowest, fastest), random.uniform(2, 4), random.uniform(2.5, 6));
  }

  private static void watch(SimulationSettings settings, Map<Team, RobotLimits> truth) {
    MovementObserver observer = new MovementObserver();
    Map<Team, Double> fastest = new EnumMap<>(Team.class);
    Simulation simulation = Simulation.of(settings);
    simulation.run(
        packet -> {
          for (SimulatedRobot robot : simulation.world().robots()) {
            fastest.merge(robot.id().team(), robot.speed(), Math::max);
          }
          VisionFrame frame = packet.packet().frame().orElse(null);
          if (frame != null) {
            observer.accept(frame);
          }
        });
    observer.finish();
    truth.forEach(
        (team, limits) -> TEAMS.add(new Found(observer.limits(team), limits, fastest.get(team))));
  }

  /** A robot of 3 m/s² and 4 m/s² needs more than half of the field to come to 5 m/s and to stop again. */
  @Test
  void noLowerBoundIsAboveWhatTheRobotsDrove() {
    assertThat(TEAMS).filteredOn(t -> !t.limits.velocity().reached()).hasSizeGreaterThan(2);
    assertThat(TEAMS)
        .filteredOn(t -> !t.limits.velocity().reached())
        .allSatisfy(
            t -> {
              LimitEstimate v = t.limits.velocity();
              assertThat(v.value() - 2 * v.standardError()).isLessThanOrEqualTo(t.fastest);
              assertThat(v.value()).isGreaterThan(0.9 * t.fastest);
            });
  }

  /** Bias, and errors that cover: of twelve teams two may lie outside of two errors by chance in 2 % of all draws. */
  @Test
  void velocityAndBrakingAreNotBiased() {
    double velocity =
        TEAMS.stream()
            .filter(t -> t.limits.velocity().reached())
            .mapToDouble(t -> t.limits.velocity().value() / t.truth.velocity() - 1)
            .average()
            .orElseThrow();
    double braking =
        TEAMS.stream()
            .mapToDouble(t -> t.limits.braking().value() / t.truth.braking() - 1)
            .average()
            .orElseThrow();
    assertThat(velocity).as("%s", TEAMS).isBetween(-0.01, 0.01);
    assertThat(braking).as("%s", TEAMS).isBetween(-0.01, 0.01);
    assertThat(TEAMS)
        .filteredOn(
            t ->
                Math.abs(t.limits.braking().value() - t.truth.braking())
                    > 2 * t.limits.braking().standardError())
        .hasSizeLessThan(3);
  }
}
