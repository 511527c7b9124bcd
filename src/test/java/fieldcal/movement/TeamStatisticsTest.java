package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What becomes of single manoeuvres: speeds, caps, kinds, pictures, the league's histograms. */
class TeamStatisticsTest {
  private final TeamStatistics team = new TeamStatistics();

  private static Manoeuvre drive(
      int robot, double speed, double acceleration, double duration, double error) {
    return new Manoeuvre(
        new RobotId(Team.YELLOW, robot),
        0,
        duration,
        speed,
        0,
        acceleration,
        0,
        error,
        0.01,
        0.01,
        0,
        0,
        40);
  }

  private void cruises(int robot, double speed, int times, Random random) {
    for (int i = 0; i < times; i++) {
      team.add(drive(robot, speed + 0.005 * random.nextGaussian(), 0.02, 0.4, 0.02));
    }
  }

  private TeamLimits limits() {
    return LimitEstimator.estimate(Team.YELLOW, team);
  }

  @Test
  void theHighestSpeedAtWhichRobotsCruiseIsTheLimit() {
    Random random = new Random(1);
    cruises(1, 1.5, 200, random);
    cruises(2, 3, 12, random);
    LimitEstimate v = limits().velocity();
    assertThat(v.reached()).isTrue();
    assertThat(v.value()).isEqualTo(3, within(0.01));
    assertThat(v.standardError()).isBetween(0.0005, 0.005);
  }

  @Test
  void oneFastMistakeIsNoLimit() {
    Random random = new Random(2);
    cruises(2, 3, 50, random);
    cruises(3, 5.5, 1, random);
    assertThat(limits().velocity().value()).isEqualTo(3, within(0.01));
  }

  @Test
  void robotsThatDriveFasterWithoutCruisingThereHaveABoundOnly() {
    cruises(0, 2, 10, new Random(3));
    for (int i = 0; i < 60; i++) {
      team.add(drive(1, 0, 2, 0.5 + 0.02 * i, 0.01));
    }
    LimitEstimate v = limits().velocity();
    assertThat(v.reached()).isFalse();
    // The second fastest had 3.32 m/s at its end, and 0.02 m/s less where its acceleration was
    // constant.
    assertThat(v.value()).isBetween(3.15, 3.30);
    assertThat(v.note()).isNotEmpty();
  }

  @Test
  void aRobotThatIsAlwaysSlowerIsNamed() {
    Random random = new Random(4);
    cruises(0, 2, 15, random);
    cruises(1, 2, 15, random);
    cruises(1, 3, 15, random);
    cruises(2, 3, 15, random);
    List<SpeedCap> caps = limits().speedCaps();
    assertThat(caps).hasSize(1);
    assertThat(caps.get(0).robot()).isZero();
    assertThat(caps.get(0).speed()).isEqualTo(2, within(0.01));
    assertThat(caps.get(0).samples()).isEqualTo(15);
  }

  @Test
  void kindsAreToldByTheSpeed() {
    team.add(drive(1, 0, 3, 0.5, 0.05));
    team.add(drive(1, 2, -4, 0.4, 0.05));
    // A turn: the velocity changes, the speed hardly.
    team.add(
        new Manoeuvre(
            new RobotId(Team.YELLOW, 1), 0, 0.3, 2, -0.3, 0, 2, 0.05, 0.01, 0.01, 0, 0.4, 20));
    assertThat(team.acceleratingManoeuvres().all().samples()).isEqualTo(1);
    assertThat(team.brakingManoeuvres().all().samples()).isEqualTo(1);
    assertThat(team.manoeuvres()).isEqualTo(3);
  }

  @Test
  void picturesAreInTheRobotsOwnFrame() {
    // The front looks along y, the robot accelerates along x: to its right.
    team.add(
        new Manoeuvre(
            new RobotId(Team.YELLOW, 1),
            0,
            0.5,
            0,
            0,
            3.1,
            0,
            0.05,
            0.01,
            0.01,
            0,
            Math.PI / 2,
            36));
    Grid g = team.ownFrame();
    assertThat(g.total()).isEqualTo(36);
    for (int column = 0; column < g.columns(); column++) {
      for (int row = 0; row < g.rows(); row++) {
        if (g.count(column, row) > 0) {
          assertThat(g.centreX(column)).isEqualTo(0, within(0.13));
          assertThat(g.centreY(row)).isEqualTo(-3.1, within(0.13));
        }
      }
    }
  }

  @Test
  void nothingIsKnownOfNothing() {
    TeamLimits limits = limits();
    for (LimitEstimate e :
        List.of(
            limits.velocity(),
            limits.acceleration(),
            limits.braking(),
            limits.leagueVelocity(),
            limits.leagueAcceleration(),
            limits.leagueBraking())) {
      assertThat(e.known()).isFalse();
      assertThat(e.note()).isNotEmpty();
    }
    assertThat(limits.deviations()).isEmpty();
  }

  @Test
  void theLeagueCountsVelocitiesAndDifferences() {
    LeagueStatistics league = team.league();
    league.add(1, 0, 1.5, 0, 0.1);
    league.add(1.5, 0, 1.1, 0.3, 0.1);
    league.add(0.2, 0, 0.05, 0, 0.1);
    assertThat(league.velocity().samples()).isEqualTo(3);
    assertThat(league.acceleration().percentile(0.5)).isEqualTo(5.05, within(1e-9));
    assertThat(league.braking().samples()).as("below 0.1 m/s nothing counts").isEqualTo(1);
    assertThat(league.velocityLimit().known()).isFalse();
    for (int i = 0; i < LeagueStatistics.MIN_SAMPLES; i++) {
      league.add(1, 0, 1.25, 0, 0.1);
    }
    assertThat(league.velocityLimit().value()).isEqualTo(1.3, within(0.01));
    assertThat(league.accelerationLimit().value()).isEqualTo(2.575, within(0.01));
    assertThat(league.brakingLimit().known()).isFalse();
  }

  @Test
  void gridsRefuseNonsense() {
    assertThatThrownBy(() -> new Grid(0, 0, 3, 0, 1, 3))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Grid.centred(0.5, 4).merge(Grid.centred(0.5, 6)))
        .isInstanceOf(IllegalArgumentException.class);
    Grid g = Grid.centred(0.5, 4);
    g.add(Double.NaN, 0, 1);
    g.add(7, 0, 2);
    g.add(-1, 0.99, 3);
    assertThat(g.total()).isEqualTo(3);
    assertThat(g.outside()).isEqualTo(2);
    assertThat(g.count(0, 3)).isEqualTo(3);
  }
}
