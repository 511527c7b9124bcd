package fieldcal.benchmark;

import fieldcal.movement.Envelope;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementObserver;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.robot.DirectionShape;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.Team;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;

/**
 * What the limits of 36 teams in simulated matches are by direction, how fast they turn, and which robot is weak, against the truth: four shapes, drawn sizes, half of the matches with robots that look where they drive and so turn by much, a weak robot in every third match.
 */
final class ShapesBenchmark {
  private static final int MATCHES = 18;
  private static final Goal WITHIN = Goal.atMost(5, "%.0f %%");
  private static final Goal NONE = Goal.atMost(0, "%.0f");
  private static final Goal ALL = Goal.atLeast(1, "%.2f");
  private static final Goal COVERED = Goal.atLeast(0.9, "%.2f");

  private final BenchmarkSettings settings;
  private final PrintStream out;
  private final Tally directions = new Tally();
  private final Tally rates = new Tally();
  private final Tally faster = new Tally();
  private final Tally braking = new Tally();
  private int bounds;
  private int falseBounds;
  private int refused;
  private int weak;
  private int weakFound;
  private int invented;

  /** Estimates against the truth. */
  private static final class Tally {
    private int all;
    private int near;
    private int covered;
    private double worst;

    /** Off by at most 5 % or a tolerance, whichever is wider. */
    void add(double value, double error, double truth, double tolerance) {
      all++;
      near += Math.abs(value - truth) <= Math.max(tolerance, 0.05 * truth) ? 1 : 0;
      covered += Math.abs(value - truth) <= 2 * error ? 1 : 0;
      worst = Math.max(worst, Math.abs(value / truth - 1));
    }
  }

  private ShapesBenchmark(BenchmarkSettings settings, PrintStream out) {
    this.settings = settings;
    this.out = out;
  }

  static void run(BenchmarkSettings settings, PrintStream out) {
    new ShapesBenchmark(settings, out).run();
  }

  private void run() {
    RandomStream random = RandomStream.of(settings.seed(), "shapes");
    for (int i = 0; i < MATCHES; i++) {
      RobotLimits yellow = drawn(random, DirectionShape.values()[i % 4]);
      RobotLimits blue = drawn(random, DirectionShape.values()[(i + 1 + i / 4) % 4]);
      boolean turns = i % 2 == 0;
      boolean hasWeak = i % 3 == 0;
      TeamManner manner =
          TeamManner.USUAL
              .withFacing(turns ? TeamManner.Facing.TARGET : TeamManner.Facing.BALL)
              .withWeakRobot(hasWeak ? 1 + i % 5 : -1, hasWeak ? random.uniform(0.6, 0.88) : 1);
      match(i, yellow, blue, manner);
    }
    summary();
  }

  private static RobotLimits drawn(RandomStream random, DirectionShape shape) {
    return RobotLimits.uniform(
            random.uniform(1.8, 3.6), random.uniform(2, 4.5), random.uniform(2.8, 6))
        .withDirectionality(random.uniform(0.15, 0.55))
        .withShape(shape)
        .withTurning(random.uniform(4, 15), random.uniform(15, 60));
  }

  private void match(int number, RobotLimits yellow, RobotLimits blue, TeamManner manner) {
    SimulationSettings s =
        SimulationSettings.DEFAULT
            .withSeed(1000 * settings.seed() + number)
            .withScenario(
                ScenarioSettings.of(ScenarioKind.MATCH, 0)
                    .withMatch(6, settings.minutes())
                    .withLimits(yellow, blue)
                    .withManner(manner));
    s = s.withCameras(s.cameras().withNoise(0.002, 0.0025).withRegistration(0.0215, 0.023));
    Simulation simulation = Simulation.of(s);
    MovementObserver observer = new MovementObserver();
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
                        String command = phases.get(next[0]++).command();
                        boolean running =
                            command.endsWith("_START") || command.startsWith("DIRECT_");
                        observer.phase(running ? PlayPhase.RUNNING : PlayPhase.STOPPED);
                      }
                      observer.accept(frame);
                    }));
    observer.finish();
    judge(observer.limits(Team.YELLOW), yellow, manner);
    judge(observer.limits(Team.BLUE), blue, manner);
  }

  private void judge(TeamLimits found, RobotLimits truth, TeamManner manner) {
    int known = 0;
    double worst = 0;
    for (Envelope envelope : found.envelopes()) {
      for (Envelope.Point p : envelope.points()) {
        // Robots plan to brake with 97 % of what they have, which is all that can be seen.
        boolean speedsUp = envelope.seenIn().equals("acceleration");
        double most = speedsUp ? truth.acceleration() : 0.97 * truth.braking();
        double there = most * truth.directionFactor(p.angle());
        if (speedsUp) {
          known++;
          worst = Math.max(worst, Math.abs(p.value() / there - 1));
          directions.add(p.value(), p.standardError(), there, 0);
        } else {
          braking.add(p.value(), p.standardError(), there, 0);
        }
      }
    }
    LimitEstimate rate = found.turning().velocity();
    LimitEstimate change = found.turning().acceleration();
    if (rate.known() && rate.reached()) {
      rates.add(rate.value(), rate.standardError(), truth.angularVelocity(), 0.2);
    } else if (rate.known()) {
      bounds++;
      falseBounds += rate.value() - 2 * rate.standardError() > truth.angularVelocity() ? 1 : 0;
    } else {
      refused++;
    }
    if (change.known() && change.reached()) {
      faster.add(change.value(), change.standardError(), truth.angularAcceleration(), 0.2);
    }
    int robot = manner.weakRobot();
    weak += robot >= 0 ? 1 : 0;
    boolean named = found.robots().stream().anyMatch(r -> r.robot() == robot);
    weakFound += named ? 1 : 0;
    for (RobotDifference r : found.robots()) {
      invented += r.robot() == robot ? 0 : 1;
    }
    out.printf(
        Locale.ROOT,
        "%-12s %.2f  acceleration in %2d directions, worst %4.1f %%;  turning %5.2f: %s  %5.2f:"
            + " %s  weak: %s%n",
        truth.shape(),
        truth.directionality(),
        known,
        100 * worst,
        truth.angularVelocity(),
        words(rate),
        truth.angularAcceleration(),
        words(change),
        robot < 0 ? "none" : named ? "found" : "missed");
  }

  private static String words(LimitEstimate e) {
    return e.known()
        ? String.format(Locale.ROOT, "%s%.2f", e.reached() ? "" : "≥", e.value())
        : "refused";
  }

  private void summary() {
    out.printf("%n%-44s %6s %8s %9s %8s%n", "", "all", "near", "covered", "worst");
    print("acceleration by direction", directions);
    print("braking by direction", braking);
    print("rate of turning, reached", rates);
    print("angular acceleration, reached", faster);
    double share = (double) directions.near / directions.all;
    out.printf(
        Locale.ROOT,
        "directions within 5 %%: %.3f; worst %.1f %% (%s)  %s%n",
        share,
        100 * directions.worst,
        WITHIN,
        WITHIN.verdict(100 * directions.worst));
    out.printf(
        Locale.ROOT,
        "angular limits within 5 %% or 0.2 where reached: %d of %d  %s; covered %.2f  %s%n",
        rates.near + faster.near,
        rates.all + faster.all,
        ALL.verdict((double) (rates.near + faster.near) / (rates.all + faster.all)),
        (double) (rates.covered + faster.covered) / (rates.all + faster.all),
        COVERED.verdict((double) (rates.covered + faster.covered) / (rates.all + faster.all)));
    out.printf(
        Locale.ROOT,
        "rates of turning: %d lower bounds, %d false  %s; %d refused%n",
        bounds,
        falseBounds,
        NONE.verdict(falseBounds),
        refused);
    out.printf(
        Locale.ROOT,
        "weak robots: %d of %d found, %d invented  %s%n",
        weakFound,
        weak,
        invented,
        NONE.verdict(invented));
  }

  private void print(String name, Tally tally) {
    out.printf(
        Locale.ROOT,
        "%-44s %6d %8d %9d %6.1f %%%n",
        name,
        tally.all,
        tally.near,
        tally.covered,
        100 * tally.worst);
  }
}
