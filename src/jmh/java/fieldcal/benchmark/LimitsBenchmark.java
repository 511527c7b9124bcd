package fieldcal.benchmark;

import com.sun.management.ThreadMXBean;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.MovementEffect;
import fieldcal.movement.MovementObserver;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Movement limits of simulated matches against the truth, the league's estimator beside ours: 6 against 6 and 11 against 11, 1.3 and 3.5 mm of noise, cameras that disagree by 23 mm and enlarge by up to 0.1 %, robots that differ by 1 % and change their acceleration within up to 80 ms, over the range of
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

  private final BenchmarkSettings settings;
  private final PrintStream out;
  private final LimitScore velocity = new LimitScore("velocity");
  private final LimitScore acceleration = new LimitScore("acceleration");
  private final LimitScore braking = new LimitScore("braking");
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

  static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    new LimitsBenchmark(settings, out).run(findings);
  }

  private void run(Findings findings) {
    out.printf(
        Locale.ROOT,
        "%d-minute matches; own estimate (error), league's (error)%n",
        settings.minutes());
    int block = 0;
    for (double noise : NOISES) {
      for (int size : SIZES) {
        out.printf(Locale.ROOT, "%n%.1f mm, %d against %d%n", 1000 * noise, size, size);
        for (int i = 0; i < UNIFORM.length; i += 2) {
          match(noise, size, limits(UNIFORM[i]), limits(UNIFORM[i + 1]), block + i);
        }
        for (int i = 0; i < ODD.length; i += 2) {
          match(noise, size, limits(ODD[i]), limits(ODD[i + 1]), block + 100 + i);
        }
        block += UNIFORM.length; // each match has cameras of its own
      }
    }
    summary();
    for (LimitScore score : List.of(velocity, acceleration, braking)) {
      score.tell(findings);
    }
    Goal none = Goal.atMost(0, "%.0f");
    findings.value("effects invented", "%.0f", inventedNames, none);
    findings.share("effects named", rightNames, rightNames + missedNames);
    findings.value("a frame, p99", "%.2f ms", costs.percentile(0.99), Goal.atMost(2, "%.0f ms"));
  }

  private static RobotLimits limits(double[] numbers) {
    RobotLimits plain = RobotLimits.uniform(numbers[0], numbers[1], numbers[2]);
    return numbers.length == 3
        ? plain
        : plain.withTorqueLoss(numbers[3]).withDirectionality(numbers[4]);
  }

  private void match(double noise, int size, RobotLimits yellow, RobotLimits blue, int number) {
    long seed = 1000 * settings.seed() + number;
    SimulationSettings s =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withScenario(
                ScenarioSettings.of(ScenarioKind.MATCH, 0)
                    .withMatch(size, settings.minutes())
                    .withLimits(yellow, blue)
                    .withManner(LimitMatch.drawnManner(seed)));
    s = s.withCameras(s.cameras().withNoise(0.002, noise).withRegistration(0.0215, 0.023));
    LimitMatch match = LimitMatch.play(LimitMatch.enlarging(s), costs::accept);
    judge(match.limits(Team.YELLOW), yellow, match.driven(Team.YELLOW));
    judge(match.limits(Team.BLUE), blue, match.driven(Team.BLUE));
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
    for (LimitScore score : List.of(velocity, acceleration, braking)) {
      score.print(out);
    }
    for (LimitScore score : List.of(velocity, acceleration, braking)) {
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
