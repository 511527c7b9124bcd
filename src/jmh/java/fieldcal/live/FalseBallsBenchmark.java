package fieldcal.live;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.simulation.FieldSize;
import fieldcal.vision.BallDetection;
import fieldcal.vision.ChangedFrame;
import fieldcal.vision.VisionFrame;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** Replay of a match whose every frame has 0, 10 or 100 false balls anywhere on the field: how fast it is, and which kicks are lost or invented by them. */
public final class FalseBallsBenchmark {
  private static final int[] AMOUNTS = {0, 10, 100};
  private static final int FEW = 10;
  private static final double ROLL = -0.28;

  /** Two looks at one kick agree to a frame or two, s. */
  private static final double SAME = 0.03;

  private static final Goal FAST = Goal.atLeast(5, "%.0f");
  private static final Goal NONE = Goal.atMost(0, "%.0f");

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final SimulatedMatch match;
  private final long seed;

  private FalseBallsBenchmark(BenchmarkSettings settings) {
    seed = settings.seed();
    match = SimulatedMatch.play(seed, settings.minutes(), ROLL);
  }

  /** What a replay gave: kicks, by their times, and how much of a core it took, s. */
  private record Replay(List<Double> kicks, double seconds) {
    /** How many of these kicks the other replay does not have. */
    long without(Replay other) {
      return kicks.stream()
          .filter(t -> other.kicks.stream().noneMatch(o -> Math.abs(o - t) < SAME))
          .count();
    }
  }

  /**
   * Measures.
   *
   * @param settings minutes and seed of the match
   * @param out gets the numbers
   * @param findings those with a goal
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    FalseBallsBenchmark benchmark = new FalseBallsBenchmark(settings);
    benchmark.replay(0); // until Java has compiled what is used most
    Replay clean = null;
    for (int amount : AMOUNTS) {
      Replay replay = benchmark.replay(amount);
      clean = clean == null ? replay : clean;
      double times = benchmark.match.duration() / replay.seconds();
      long lost = clean.without(replay);
      long invented = replay.without(clean);
      out.printf(
          Locale.ROOT,
          "%3d false balls in a frame: %.1f times real time, %d kicks, %d lost, %d invented%n",
          amount,
          times,
          replay.kicks().size(),
          lost,
          invented);
      for (double kick : clean.kicks()) {
        double nearest =
            replay.kicks().stream().mapToDouble(k -> Math.abs(k - kick)).min().orElse(Double.NaN);
        if (nearest >= SAME) {
          out.printf(
              Locale.ROOT,
              "  lost: the kick %.2f s after the first one; the nearest is %.2f s off%n",
              kick - clean.kicks().get(0),
              nearest);
        }
      }
      String each = amount + " false balls in each frame";
      findings.value(each + ": replay, per core, times real time", "%.1f", times, FAST);
      if (amount > 0) {
        String what = each + ": kicks lost, of " + clean.kicks().size();
        if (amount <= FEW) {
          findings.value(what, "%.0f", lost, NONE);
        } else {
          findings.note(what, Long.toString(lost));
        }
        findings.note(each + ": kicks invented", Long.toString(invented));
      }
    }
  }

  private Replay replay(int falseBalls) {
    List<Double> kicks = new ArrayList<>();
    LiveListener notes =
        new LiveListener() {
          @Override
          public void kick(LiveKick kick) {
            kicks.add(kick.time());
          }
        };
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(60),
            match.recording().epoch(),
            notes,
            Runnable::run);
    monitor.geometry(match.recording().geometry());
    Random random = new Random(seed);
    long used = 0;
    for (VisionFrame frame : match.recording().frames()) {
      VisionFrame disturbed = with(falseBalls, frame, random);
      long before = threads.getCurrentThreadCpuTime();
      monitor.accept(disturbed);
      used += threads.getCurrentThreadCpuTime() - before;
    }
    long before = threads.getCurrentThreadCpuTime();
    monitor.finish();
    used += threads.getCurrentThreadCpuTime() - before;
    return new Replay(kicks, 1e-9 * used);
  }

  private static VisionFrame with(int falseBalls, VisionFrame frame, Random random) {
    List<BallDetection> balls = new ArrayList<>(frame.balls());
    FieldSize field = FieldSize.DIVISION_A;
    for (int i = 0; i < falseBalls; i++) {
      double x = field.length() * (random.nextDouble() - 0.5);
      double y = field.width() * (random.nextDouble() - 0.5);
      balls.add(new BallDetection(x, y, Double.NaN, 0.5, 50, Double.NaN, Double.NaN));
    }
    return ChangedFrame.withBalls(frame, balls);
  }
}
