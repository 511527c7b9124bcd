package fieldcal.benchmark;

import fieldcal.movement.MovementObserver;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.Team;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;

/**
 * Movement limits of 72 drawn teams, many of which seldom or never come to their highest speed: a robot of 2 m/s² and 4 m/s² needs 6 m to reach 4 m/s and to stop again. Their lower bounds must not be above what they drove.
 */
final class BoundsBenchmark {
  private static final int MATCHES = 36;
  private static final int[] SIZES = {6, 8, 11};

  private BoundsBenchmark() {}

  static void run(BenchmarkSettings settings, PrintStream out) {
    LimitScore velocity = new LimitScore("velocity");
    LimitScore acceleration = new LimitScore("acceleration");
    LimitScore braking = new LimitScore("braking");
    RandomStream random = RandomStream.of(settings.seed(), "bounds");
    int never = 0;
    for (int i = 0; i < MATCHES; i++) {
      RobotLimits yellow = drawn(random);
      RobotLimits blue = drawn(random);
      double noise = 0.001 * Math.exp(random.uniform(Math.log(0.8), Math.log(4)));
      long seed = 1000 * settings.seed() + i;
      SimulationSettings s =
          SimulationSettings.DEFAULT
              .withSeed(seed)
              .withScenario(
                  ScenarioSettings.of(ScenarioKind.MATCH, 0)
                      .withMatch(SIZES[i % SIZES.length], settings.minutes())
                      .withLimits(yellow, blue)
                      .withManner(LimitMatch.drawnManner(seed)));
      double apart = random.uniform(0, 0.025);
      s = s.withCameras(s.cameras().withNoise(0.002, noise).withRegistration(0.0215, apart));
      LimitMatch match = LimitMatch.play(LimitMatch.enlarging(s), MovementObserver::accept);
      for (Team team : Team.values()) {
        RobotLimits truth = team == Team.YELLOW ? yellow : blue;
        TeamLimits found = match.limits(team);
        double driven = match.driven(team);
        never += driven < 0.995 * truth.velocity() ? 1 : 0;
        double fastest = found.velocity().reached() ? truth.velocity() : driven;
        out.printf(
            Locale.ROOT,
            "%.1f mm, drove %.3f of%s%s%s%n",
            1000 * noise,
            driven,
            velocity.of(found.velocity(), found.leagueVelocity(), fastest),
            acceleration.of(found.acceleration(), found.leagueAcceleration(), truth.acceleration()),
            braking.of(found.braking(), found.leagueBraking(), truth.braking()));
      }
    }
    out.printf("%n%d of %d teams never came to their highest speed%n", never, 2 * MATCHES);
    List.of(velocity, acceleration, braking).forEach(score -> score.printErrors(out));
  }

  private static RobotLimits drawn(RandomStream random) {
    return RobotLimits.uniform(random.uniform(2, 6), random.uniform(1, 4), random.uniform(1.5, 6));
  }
}
