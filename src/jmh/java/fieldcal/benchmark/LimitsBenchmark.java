package fieldcal.benchmark;

import com.sun.management.ThreadMXBean;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementEffect;
import fieldcal.movement.MovementObserver;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.apache.commons.math3.stat.interval.ConfidenceInterval;
import org.apache.commons.math3.stat.interval.WilsonScoreInterval;

/**
 * Movement limits of simulated matches against the truth, the league's estimator beside ours: 6 against 6 and 11 against 11, 1.3 and 3.5 mm of noise, cameras that disagree by 23 mm, over the range of
 * limits that robots have; teams with and without torque limit and direction dependence; and what a frame costs.
 */
final class LimitsBenchmark {
  private static final double[] NOISES = {0.0013, 0.0035};
  private static final int[] SIZES = {6, 11};

  /** Velocity, acceleration, braking; two teams a match. */
  private static final double[][] UNIFORM = {
    {1.5, 1.5, 2}, {1.5, 3, 5}, {1.5, 5, 8}, {2.5, 1.5, 8}, {2.5, 3, 2},
    {2.5, 5, 5}, {4, 1.5, 5}, {4, 3, 8}, {4, 5, 2}, {3.2, 2.2, 2.4}
  };

  /** Velocity, acceleration, braking, torque loss, directionality. */
  private static final double[][] ODD = {
    {3, 3, 5, 0.15, 0}, {2, 4, 6, 0.3, 0}, {3, 4, 5, 0.5, 0}, {3, 3, 5, 0, 0.15},
    {2.5, 4, 6, 0, 0.3}, {3, 3.5, 4, 0, 0.5}, {3, 4, 5, 0.3, 0.3}, {2.5, 3, 4, 0.2, 0.4}
  };

  private static final Goal UNBIASED = Goal.atMost(1, "%.1f %%");

  /** How often two standard errors hold the truth. */
  private static final Goal COVERED = new Goal(92, 98, "%.0f %%");

  /** What so few teams can tell about that. */
  private static final double CONFIDENCE = 0.95;

  private static final Goal NEVER_FALSE = Goal.atMost(0, "%.0f");
  private static final Goal NEAR = Goal.atLeast(1, "%.0f of the tolerance");

  private final BenchmarkSettings settings;
  private final PrintStream out;
  private final Score velocity = new Score("velocity");
  private final Score acceleration = new Score("acceleration");
  private final Score braking = new Score("braking");
  private final Costs costs = new Costs();
  private int bounds;
  private int teams;
  private int rightNames;
  private int missedNames;
  private int inventedNames;
  private double worstCoefficient;

  private LimitsBenchmark(BenchmarkSettings settings, PrintStream out) {
    this.settings = settings;
    this.out = out;
  }

  static void run(BenchmarkSettings settings, PrintStream out) {
    new LimitsBenchmark(settings, out).run();
  }

  private void run() {
    out.printf(
        Locale.ROOT,
        "%d-minute matches; own estimate (error), league's (error)%n",
        settings.minutes());
    for (double noise : NOISES) {
      for (int size : SIZES) {
        out.printf(Locale.ROOT, "%n%.1f mm, %d against %d%n", 1000 * noise, size, size);
        for (int i = 0; i < UNIFORM.length; i += 2) {
          match(noise, size, limits(UNIFORM[i]), limits(UNIFORM[i + 1]), i);
        }
        for (int i = 0; i < ODD.length; i += 2) {
          match(noise, size, limits(ODD[i]), limits(ODD[i + 1]), 100 + i);
        }
      }
    }
    summary();
  }

  private static RobotLimits limits(double[] numbers) {
    RobotLimits plain = RobotLimits.uniform(numbers[0], numbers[1], numbers[2]);
    return numbers.length == 3
        ? plain
        : plain.withTorqueLoss(numbers[3]).withDirectionality(numbers[4]);
  }

  private void match(double noise, int size, RobotLimits yellow, RobotLimits blue, int number) {
    SimulationSettings s =
        SimulationSettings.DEFAULT
            .withSeed(1000 * settings.seed() + number)
            .withScenario(
                ScenarioSettings.of(ScenarioKind.MATCH, 0)
                    .withMatch(size, settings.minutes())
                    .withLimits(yellow, blue));
    s = s.withCameras(s.cameras().withNoise(0.002, noise).withRegistration(0.0215, 0.023));
    Simulation simulation = Simulation.of(s);
    MovementObserver observer = new MovementObserver();
    Map<Team, Double> driven = new EnumMap<>(Map.of(Team.YELLOW, 0.0, Team.BLUE, 0.0));
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
                        observer.phase(phase(phases.get(next[0]++).command()));
                      }
                      for (SimulatedRobot r : simulation.world().robots()) {
                        driven.merge(r.id().team(), r.speed(), Math::max);
                      }
                      costs.accept(observer, frame);
                    }));
    observer.finish();
    judge(observer.limits(Team.YELLOW), yellow, driven.get(Team.YELLOW));
    judge(observer.limits(Team.BLUE), blue, driven.get(Team.BLUE));
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

  private void judge(TeamLimits found, RobotLimits truth, double driven) {
    teams++;
    StringBuilder line = new StringBuilder();
    // Nobody can see a limit that no robot came near; then the most they drove is what can be
    // known.
    double fastest = found.velocity().reached() ? truth.velocity() : driven;
    bounds += found.velocity().reached() ? 0 : 1;
    line.append(velocity.of(found.velocity(), found.leagueVelocity(), fastest));
    line.append(
        acceleration.of(found.acceleration(), found.leagueAcceleration(), truth.acceleration()));
    line.append(braking.of(found.braking(), found.leagueBraking(), truth.braking()));
    line.append(names(found, truth));
    out.println(line);
  }

  private String names(TeamLimits found, RobotLimits truth) {
    Map<MovementEffect, Double> hidden = new EnumMap<>(MovementEffect.class);
    if (truth.torqueLoss() > 0) {
      hidden.put(MovementEffect.TORQUE_LIMITED, truth.torqueLoss());
    }
    if (truth.directionality() > 0) {
      hidden.put(MovementEffect.DIRECTIONAL, truth.directionality());
    }
    Set<MovementEffect> named = EnumSet.noneOf(MovementEffect.class);
    StringBuilder words = new StringBuilder();
    for (LimitDeviation d : found.deviations()) {
      named.add(d.effect());
      words.append(
          String.format(
              Locale.ROOT,
              "  %s %.3f ± %.3f (%s; %s)",
              d.effect().id(),
              d.coefficient(),
              d.standardError(),
              d.seenIn(),
              hidden.containsKey(d.effect()) ? hidden.get(d.effect()) : "invented"));
      if (hidden.containsKey(d.effect())) {
        worstCoefficient =
            Math.max(worstCoefficient, Math.abs(d.coefficient() - hidden.get(d.effect())));
      }
    }
    for (MovementEffect effect : MovementEffect.values()) {
      boolean there = hidden.containsKey(effect);
      rightNames += there && named.contains(effect) ? 1 : 0;
      inventedNames += !there && named.contains(effect) ? 1 : 0;
      if (there && !named.contains(effect)) {
        missedNames++;
        words.append("  missed: ").append(effect.id()).append(' ').append(hidden.get(effect));
      }
    }
    return words.toString();
  }

  private void summary() {
    out.printf(
        Locale.ROOT,
        "%n%-14s %7s %22s %22s %22s  %s%n",
        "",
        "teams",
        "within 5 % or 0.1",
        "median error",
        "worst error",
        Goal.VERDICT);
    for (Score score : List.of(velocity, acceleration, braking)) {
      score.print(out);
    }
    for (Score score : List.of(velocity, acceleration, braking)) {
      score.printErrors(out);
    }
    out.printf(
        "velocity: of %d teams, %d never came to their limit; theirs is compared with the most they"
            + " drove%n",
        teams, bounds);
    out.printf(
        Locale.ROOT,
        "effects: %d named, %d missed, %d invented; coefficients off by at most %.3f%n",
        rightNames,
        missedNames,
        inventedNames,
        worstCoefficient);
    costs.print(out);
  }

  /** How far estimates are off. */
  private static final class Score {
    private final String name;
    private final List<Double> own = new ArrayList<>();
    private final List<Double> league = new ArrayList<>();
    private int ownNear;
    private int leagueNear;
    private int reached;
    private int covered;
    private int falseBounds;
    private double deviations;

    Score(String name) {
      this.name = name;
    }

    String of(LimitEstimate ours, LimitEstimate theirs, double truth) {
      double tolerance = Math.max(0.1, 0.05 * truth);
      own.add(Math.abs(ours.value() / truth - 1));
      league.add(Math.abs(theirs.value() / truth - 1));
      double two = 2 * ours.standardError();
      if (ours.reached()) {
        reached++;
        deviations += ours.value() / truth - 1;
        covered += Math.abs(ours.value() - truth) < two ? 1 : 0;
      } else {
        falseBounds += ours.value() - two > truth ? 1 : 0;
      }
      boolean near = Math.abs(ours.value() - truth) <= tolerance;
      ownNear += near ? 1 : 0;
      leagueNear += Math.abs(theirs.value() - truth) <= tolerance ? 1 : 0;
      return String.format(
          Locale.ROOT,
          "  %s %.2f: %s%.3f ± %.3f (%+.1f %%)%s, %.2f (%+.0f %%)",
          name.charAt(0),
          truth,
          ours.reached() ? "" : "≥",
          ours.value(),
          ours.standardError(),
          100 * (ours.value() / truth - 1),
          near ? "" : "!",
          theirs.value(),
          100 * (theirs.value() / truth - 1));
    }

    void print(PrintStream out) {
      out.printf(
          Locale.ROOT,
          "%-14s %7d %22s %22s %22s  %s%n",
          name,
          own.size(),
          ownNear + " (league's " + leagueNear + ")",
          percent(own, 0.5) + " (" + percent(league, 0.5) + ")",
          percent(own, 1) + " (" + percent(league, 1) + ")",
          NEAR.verdict((double) ownNear / own.size()));
    }

    void printErrors(PrintStream out) {
      double bias = 100 * deviations / Math.max(1, reached);
      int trials = Math.max(1, reached);
      double within = 100.0 * covered / trials;
      ConfidenceInterval known =
          new WilsonScoreInterval().createInterval(trials, covered, CONFIDENCE);
      double low = 100 * known.getLowerBound();
      double high = 100 * known.getUpperBound();
      out.printf(
          Locale.ROOT,
          "%-14s %d of %d reached: bias %+.2f %%  (%s)  %s; %.0f %% (%.0f to %.0f %%) within two"
              + " standard errors  (%s)  %s; false lower bounds %d of %d  (%s)  %s%n",
          name,
          reached,
          own.size(),
          bias,
          UNBIASED,
          UNBIASED.verdict(Math.abs(bias)),
          within,
          low,
          high,
          COVERED,
          Goal.verdict(low <= COVERED.highest() && high >= COVERED.lowest()),
          falseBounds,
          own.size() - reached,
          NEVER_FALSE,
          NEVER_FALSE.verdict(falseBounds));
    }

    private static String percent(List<Double> errors, double share) {
      List<Double> sorted = errors.stream().sorted().toList();
      return String.format(
          Locale.ROOT, "%.1f %%", 100 * sorted.get((int) (share * (sorted.size() - 1))));
    }
  }

  /** What frames cost: time, and memory on the heap. */
  private static final class Costs {
    private static final int BINS = 20_000;
    private static final double BIN = 1e-6;

    private final ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final long[] times = new long[BINS];
    private long frames;
    private double seconds;
    private long bytes;
    private double recorded;
    private double lastTime = Double.NaN;

    void accept(MovementObserver observer, VisionFrame frame) {
      long before = thread.getCurrentThreadAllocatedBytes();
      // Of this thread alone: what others do on the machine is not the observer's.
      long start = thread.getCurrentThreadCpuTime();
      observer.accept(frame);
      double taken = 1e-9 * (thread.getCurrentThreadCpuTime() - start);
      bytes += thread.getCurrentThreadAllocatedBytes() - before;
      seconds += taken;
      frames++;
      times[(int) Math.min(BINS - 1, taken / BIN)]++;
      double step = frame.captureTime() - lastTime;
      recorded += step > 0 && step < 1 ? step : 0;
      lastTime = frame.captureTime();
    }

    void print(PrintStream out) {
      out.printf(
          Locale.ROOT,
          "a frame, in time of one core: %.1f µs on average, p99 %.2f ms, p99.9 %.2f ms; %.0f bytes"
              + " allocated; %.0f times real time%n",
          1e6 * seconds / frames,
          percentile(0.99),
          percentile(0.999),
          (double) bytes / frames,
          recorded / seconds);
    }

    private double percentile(double share) {
      long below = 0;
      for (int i = 0; i < BINS; i++) {
        below += times[i];
        if (below >= share * frames) {
          return 1e3 * BIN * (i + 1);
        }
      }
      return Double.NaN;
    }
  }
}
