package fieldcal.simulation.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A match has what monitors need: all kinds of kicks, restarts, and robots that use their limits. */
class MatchScenarioTest {
  private static SimulationSettings match(int size, double minutes, long seed) {
    return SimulationSettings.DEFAULT
        .withScenario(ScenarioSettings.of(ScenarioKind.MATCH, 0).withMatch(size, minutes))
        .withCameras(CameraSettings.DEFAULT.withCount(2))
        .withSeed(seed);
  }

  /** Robots of a team differ only where they are to, and by as much as they are to. */
  @Test
  void robotsMayDiffer() {
    SimulationSettings alike = match(11, 1, 5);
    SimulationSettings unlike =
        alike.withScenario(alike.scenario().withManner(TeamManner.USUAL.withDifference(0.01)));
    double[] same = brakings(alike);
    double[] different = brakings(unlike);
    double squares = 0;
    for (int i = 0; i < same.length; i++) {
      assertThat(same[i]).isEqualTo(same[0]);
      squares += Math.pow(different[i] / same[0] - 1, 2);
    }
    assertThat(Math.sqrt(squares / same.length)).isEqualTo(0.01, within(0.005));
  }

  private static double[] brakings(SimulationSettings settings) {
    return Simulation.of(settings).world().robots().stream()
        .filter(r -> r.id().team() == Team.YELLOW)
        .mapToDouble(r -> r.limits().braking())
        .toArray();
  }

  @ParameterizedTest
  @CsvSource({"6, 1", "6, 2", "11, 3"})
  void isPlayed(int size, long seed) {
    Truth truth = Simulation.of(match(size, 4, seed)).run(packet -> {});
    Map<String, Long> purposes =
        truth.kicks().stream()
            .collect(Collectors.groupingBy(KickTruth::purpose, Collectors.counting()));
    assertThat(purposes.getOrDefault("pass", 0L)).isGreaterThan(20);
    assertThat(purposes.getOrDefault("chip_pass", 0L)).isGreaterThan(3);
    assertThat(purposes).containsKey("redirect");
    assertThat(truth.commandedKicks()).hasSizeGreaterThan(40);
    assertThat(truth.holds()).hasSizeGreaterThan(10);
    assertThat(truth.robots()).hasSize(2 * size);
    List<String> commands = truth.phases().stream().map(RefereePhase::command).toList();
    assertThat(commands).contains("HALT", "STOP", "NORMAL_START").startsWith("HALT");
    assertThat(commands.get(commands.size() - 1)).isEqualTo("HALT");
    assertThat(truth.phases().stream().map(RefereePhase::stage))
        .contains("NORMAL_FIRST_HALF", "NORMAL_HALF_TIME", "NORMAL_SECOND_HALF", "POST_GAME");
    assertThat(truth.duration()).isEqualTo(4 * 60 + 10, within(10.0));
    // Kicks do not overlap, except that one ends when the next begins.
    for (int i = 1; i < truth.kicks().size(); i++) {
      KickTruth before = truth.kicks().get(i - 1);
      assertThat(truth.kicks().get(i).time())
          .isGreaterThanOrEqualTo(before.time() + before.duration() - 1e-9);
    }
  }

  @Test
  void nobodyKicksWhileTheGameIsHalted() {
    Truth truth = Simulation.of(match(6, 4, 5)).run(packet -> {});
    for (KickTruth kick : truth.commandedKicks()) {
      RefereePhase phase = truth.phases().get(0);
      for (RefereePhase p : truth.phases()) {
        phase = p.time() <= kick.time() - SimulatedWorld.TICK ? p : phase;
      }
      assertThat(phase.command()).as("kick at %s", kick.time()).isNotIn("HALT", "STOP");
    }
  }

  /** Up to the last ball's end: it may bounce off robots, be taken, leave the field or come to rest. */
  @ParameterizedTest
  @CsvSource({"6, 1, 1", "6, 24, 2", "2, 9, 3", "1, 5, 4", "11, 40, 5", "6, 7, 6"})
  void endsAfterTheKicksThatWereOrdered(int size, int kicks, long seed) {
    ScenarioSettings usual = ScenarioSettings.of(ScenarioKind.MATCH, kicks);
    SimulationSettings settings =
        match(size, 1, seed).withScenario(usual.withMatch(size, usual.minutes()));
    Truth truth = Simulation.of(settings).run(packet -> {});
    assertThat(truth.commandedKicks()).hasSize(kicks);
    RefereePhase end = truth.phases().get(truth.phases().size() - 1);
    assertThat(end.command()).isEqualTo("HALT");
    assertThat(end.stage()).isEqualTo("POST_GAME");
    // Robots that brake at the end may still push the ball.
    List<KickTruth> played = truth.kicks().stream().filter(k -> k.time() < end.time()).toList();
    assertThat(played).extracting(KickTruth::end).doesNotContain(EndReason.RECORDING_ENDED);
    KickTruth last = played.get(played.size() - 1);
    assertThat(end.time()).isEqualTo(last.time() + last.duration(), within(0.05));
    assertThat(truth.duration()).isEqualTo(end.time() + 2, within(0.05));
    assertThat(end.yellowScore()).isEqualTo(goals(truth, Team.YELLOW));
    assertThat(end.blueScore()).isEqualTo(goals(truth, Team.BLUE));
  }

  private static long goals(Truth truth, Team team) {
    return truth.kicks().stream()
        .filter(k -> k.end() == EndReason.GOAL)
        .filter(k -> scorer(truth, k) == team)
        .count();
  }

  private static Team scorer(Truth truth, KickTruth goal) {
    boolean secondHalf = false;
    for (RefereePhase phase : truth.phases()) {
      boolean before = phase.time() <= goal.time() + goal.duration();
      secondHalf = before ? phase.stage().contains("SECOND_HALF") : secondHalf;
    }
    boolean right = goal.path().get(goal.path().size() - 1).x() > 0;
    return right != secondHalf ? Team.YELLOW : Team.BLUE;
  }

  @Test
  void endsAfterItsTimeIfThatComesFirst() {
    SimulationSettings byTime = match(6, 1, 8);
    ScenarioSettings many = ScenarioSettings.of(ScenarioKind.MATCH, 1000).withMatch(6, 1);
    Truth truth = Simulation.of(byTime.withScenario(many)).run(packet -> {});
    Truth asLong = Simulation.of(byTime).run(packet -> {});
    assertThat(truth.duration()).isEqualTo(asLong.duration());
    assertThat(truth.kicks()).isEqualTo(asLong.kicks());
  }

  /** Robots of a match that never get to the ball must not keep the recording going. */
  @Test
  void endsWithoutAnyKick() {
    RobotLimits hardly = RobotLimits.uniform(0.001, 0.001, 0.001);
    SimulationSettings settings = match(2, 1, 9);
    ScenarioSettings two = ScenarioSettings.of(ScenarioKind.MATCH, 2);
    settings = settings.withScenario(two.withMatch(2, two.minutes()).withLimits(hardly, hardly));
    Truth truth = Simulation.of(settings).run(packet -> {});
    assertThat(truth.commandedKicks()).isEmpty();
    assertThat(truth.duration()).isEqualTo(60 * two.minutes() + 10, within(10.0));
  }

  @Test
  void howFarItIsGrowsWithKicksAndTime() {
    SimulationSettings settings = match(6, 1, 3);
    settings = settings.withScenario(ScenarioSettings.of(ScenarioKind.MATCH, 5).withMatch(6, 3));
    Simulation simulation = Simulation.of(settings);
    double before = 0;
    double largestStep = 0;
    do {
      double now = simulation.progress();
      assertThat(now).isBetween(before, 1.0);
      largestStep = Math.max(largestStep, now - before);
      before = now;
    } while (simulation.tick(packet -> {}));
    assertThat(before).isEqualTo(1);
    assertThat(largestStep).isEqualTo(0.2, within(0.1));
  }

  @Test
  void robotsUseTheirLimitsAndStayWithin() {
    RobotLimits yellow = RobotLimits.uniform(2.4, 2.6, 4.5);
    RobotLimits blue = RobotLimits.uniform(3.2, 3.8, 5.5).withTorqueLoss(0.4);
    SimulationSettings settings = match(6, 2, 6);
    settings = settings.withScenario(settings.scenario().withLimits(yellow, blue));
    MatchScenario scenario = new MatchScenario(settings);
    SimulatedWorld world =
        new SimulatedWorld(
            settings.field(),
            settings.physics(),
            settings.kickBehaviour(),
            scenario.robots(),
            settings.seed());
    List<double[]> before = new ArrayList<>();
    scenario.robots().forEach(r -> before.add(new double[2]));
    double[] fastest = new double[2];
    double[] acceleration = new double[2];
    double[] braking = new double[2];
    while (!scenario.finished(world)) {
      scenario.tick(world);
      world.tick();
      for (int i = 0; i < scenario.robots().size(); i++) {
        SimulatedRobot robot = scenario.robots().get(i);
        double[] last = before.get(i);
        int team = robot.id().team() == Team.YELLOW ? 0 : 1;
        double speed = Math.hypot(last[0], last[1]);
        double change = Math.hypot(robot.vx() - last[0], robot.vy() - last[1]);
        double rate = change / SimulatedWorld.TICK;
        fastest[team] = Math.max(fastest[team], robot.speed());
        // Not while it turns round: then a tick brakes and accelerates.
        if (speed > 0.2 && robot.speed() > speed + 0.9 * change) {
          acceleration[team] = Math.max(acceleration[team], rate);
        } else if (robot.speed() < speed - 0.9 * change) {
          braking[team] = Math.max(braking[team], rate);
        }
        last[0] = robot.vx();
        last[1] = robot.vy();
      }
    }
    RobotLimits[] limits = {yellow, blue};
    for (int team = 0; team < 2; team++) {
      assertThat(fastest[team]).isEqualTo(limits[team].velocity(), within(1e-6));
      assertThat(acceleration[team]).isEqualTo(limits[team].acceleration(), within(0.1));
      assertThat(braking[team]).isEqualTo(limits[team].braking(), within(0.05));
    }
  }
}
