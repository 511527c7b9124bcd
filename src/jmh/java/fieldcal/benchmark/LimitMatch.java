package fieldcal.benchmark;

import fieldcal.movement.MovementObserver;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiConsumer;

/** A simulated match with its referee, watched by an observer of movements. */
final class LimitMatch {
  private final MovementObserver observer = new MovementObserver();
  private final Map<Team, Double> driven = new EnumMap<>(Map.of(Team.YELLOW, 0.0, Team.BLUE, 0.0));

  /** What calibrations and lenses enlarge by, in parts, at most: a camera of 5 m that hangs 5 mm elsewhere than published. */
  private static final double ENLARGED = 0.001;

  /** Robots of one team differ by one per cent (standard deviation), as those of the independent generator of docs/studies.md do … */
  private static final double DIFFERENCE = 0.01;

  /** … and their acceleration changes within up to that time, s, as there. */
  private static final double LONGEST_SETTLING = 0.08;

  private LimitMatch() {}

  /** Robots as they are built: not all alike, and with corners of any roundness. */
  static TeamManner drawnManner(long seed) {
    RandomStream random = RandomStream.of(seed, "manner");
    return TeamManner.USUAL
        .withDifference(DIFFERENCE)
        .withSettling(random.uniform(0, LONGEST_SETTLING));
  }

  /** Cameras that each enlarge what they see a little, or make it smaller: an error of the estimates covers that, too. */
  static SimulationSettings enlarging(SimulationSettings settings) {
    RandomStream random = RandomStream.of(settings.seed(), "enlarging");
    double most = 1000 * ENLARGED * settings.cameras().height();
    List<String> effects = new ArrayList<>();
    for (int camera = 0; camera < settings.cameras().count(); camera++) {
      effects.add(
          String.format(
              Locale.ROOT,
              "camera_pose_error:height_mm=%.3f,camera=%d",
              random.uniform(-most, most),
              camera));
    }
    return settings.withEffects(effects.toArray(String[]::new));
  }

  /** Simulates a match; frames reach the observer by the given way. */
  static LimitMatch play(
      SimulationSettings settings, BiConsumer<MovementObserver, VisionFrame> feed) {
    LimitMatch match = new LimitMatch();
    Simulation simulation = Simulation.of(settings);
    int[] next = {0};
    simulation.run(
        packet ->
            packet
                .packet()
                .frame()
                .ifPresent(
                    frame -> {
                      List<RefereePhase> phases = simulation.phases();
                      while (next[0] < phases.size()
                          && phases.get(next[0]).time() <= frame.captureTime()) {
                        match.observer.phase(phase(phases.get(next[0]++).command()));
                      }
                      for (SimulatedRobot r : simulation.world().robots()) {
                        match.driven.merge(r.id().team(), r.speed(), Math::max);
                      }
                      feed.accept(match.observer, frame);
                    }));
    match.observer.finish();
    return match;
  }

  private static PlayPhase phase(String command) {
    if (command.endsWith("_START") || command.startsWith("DIRECT_")) {
      return PlayPhase.RUNNING;
    }
    if (command.startsWith("TIMEOUT")) {
      return PlayPhase.BREAK;
    }
    return command.equals("HALT") ? PlayPhase.HALTED : PlayPhase.STOPPED;
  }

  TeamLimits limits(Team team) {
    return observer.limits(team);
  }

  /** The highest speed of any robot of a team, m/s. */
  double driven(Team team) {
    return driven.get(team);
  }
}
