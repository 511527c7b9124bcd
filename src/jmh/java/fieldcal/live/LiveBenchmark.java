package fieldcal.live;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Goal;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.vision.VisionFrame;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Simulated matches of 6 against 6 and 11 against 11 whose cameras disagree by 23 mm, watched: medians against the truth, warnings with and without another carpet, how long a frame takes.
 */
public final class LiveBenchmark {
  private static final double ROLL = -0.28;
  private static final int SMALL = 6;
  private static final int LARGE = 11;
  private static final int MATCHES_PER_RUN = 10;
  private static final int LARGE_MATCHES_PER_RUN = 2;

  /** Before the carpet changes there must be 31 samples, min. */
  private static final double SHORTEST_HALF = 5;

  private static final Map<BallParameter, Double> TOLERANCE =
      Map.of(
          BallParameter.ACC_SLIDE, 8.0,
          BallParameter.ACC_ROLL, 5.0,
          BallParameter.K_SWITCH, 5.0,
          BallParameter.DAMPING_XY_FIRST_HOP, 8.0,
          BallParameter.DAMPING_XY_OTHER_HOPS, 8.0,
          BallParameter.DAMPING_Z, 8.0);

  private final BenchmarkSettings settings;
  private final PrintStream out;

  private LiveBenchmark(BenchmarkSettings settings, PrintStream out) {
    this.settings = settings;
    this.out = out;
  }

  /** Notes what it is told. */
  private static final class Notes implements LiveListener {
    private int kicks;
    private int rollSamples;
    private int raised;
    private int kicksAtWarning = -1;
    private int samplesAtWarning = -1;

    @Override
    public void kick(LiveKick kick) {
      kicks++;
      rollSamples += kick.samples().containsKey(BallParameter.ACC_ROLL) ? 1 : 0;
    }

    @Override
    public void warningRaised(LiveWarning warning) {
      raised++;
      if (warning.parameter() == BallParameter.ACC_ROLL && kicksAtWarning < 0) {
        kicksAtWarning = kicks;
        samplesAtWarning = rollSamples;
      }
    }
  }

  /**
   * Measures.
   *
   * @param settings matches per run, minutes, seed
   * @param out gets the numbers
   */
  public static void run(BenchmarkSettings settings, PrintStream out) {
    LiveBenchmark benchmark = new LiveBenchmark(settings, out);
    benchmark.unchanged(SMALL);
    benchmark.unchanged(LARGE);
    benchmark.changed();
    benchmark.speed();
  }

  private SimulatedMatch match(int number, double minutes, double roll, int size) {
    return SimulatedMatch.play(1000 * settings.seed() + number, minutes, roll, size);
  }

  private static LiveMonitor monitor(SimulatedMatch match, LiveListener listener) {
    return new LiveMonitor(
        LiveSettings.defaults().withLimitsInterval(60),
        match.recording().epoch(),
        listener,
        Runnable::run);
  }

  private void unchanged(int size) {
    int matches = (size == SMALL ? MATCHES_PER_RUN : LARGE_MATCHES_PER_RUN) * settings.runs();
    Map<BallParameter, List<Double>> errors = new EnumMap<>(BallParameter.class);
    int warnings = 0;
    long kicks = 0;
    for (int i = 0; i < matches; i++) {
      SimulatedMatch match = match(i, settings.minutes(), ROLL, size);
      Notes notes = new Notes();
      LiveMonitor monitor = monitor(match, notes);
      match.feed(monitor, 0);
      monitor.finish();
      warnings += notes.raised;
      kicks += notes.kicks;
      if ((i + 1) % MATCHES_PER_RUN == 0) {
        out.printf("%d matches: %d kicks, %d warnings%n", i + 1, kicks, warnings);
      }
      for (ParameterEstimate e : monitor.snapshot().ball().parameters()) {
        if (e.enough()) {
          errors
              .computeIfAbsent(e.parameter(), p -> new ArrayList<>())
              .add(100 * Math.abs(e.deviation()));
        }
      }
    }
    out.printf(
        Locale.ROOT,
        "%d matches of %d against %d, %d minutes, %d kicks; the published model is the truth%n",
        matches,
        size,
        size,
        settings.minutes(),
        kicks);
    for (BallParameter parameter : BallParameter.values()) {
      List<Double> of = errors.getOrDefault(parameter, List.of());
      double worst = of.stream().mapToDouble(v -> v).max().orElse(Double.NaN);
      double middle = of.stream().sorted().skip(of.size() / 2).findFirst().orElse(Double.NaN);
      Goal goal = Goal.atMost(TOLERANCE.get(parameter), "%.0f %%");
      if (of.isEmpty()) {
        out.printf("  %-22s in no match 31 samples%n", parameter.id());
        continue;
      }
      out.printf(
          Locale.ROOT,
          "  %-22s in %3d matches 31 samples; error of the median %.2f %%, at most %.2f %%  (%s)"
              + "  %s%n",
          parameter.id(),
          of.size(),
          middle,
          worst,
          goal,
          goal.verdict(worst));
    }
    Goal none = Goal.atMost(0, "%.0f");
    out.printf("  warnings: %d  (%s)  %s%n", warnings, none, none.verdict(warnings));
  }

  private void changed() {
    int matches = 2 * settings.runs();
    int[] kicks = new int[matches];
    int[] samples = new int[matches];
    for (int i = 0; i < matches; i++) {
      double half = Math.max(SHORTEST_HALF, settings.minutes() / 2.0);
      SimulatedMatch first = match(500 + i, half, ROLL, SMALL);
      SimulatedMatch second = match(500 + i, half, 1.3 * ROLL, SMALL);
      Notes notes = new Notes();
      LiveMonitor monitor = monitor(first, notes);
      first.feed(monitor, 0);
      int before = notes.kicks;
      int samplesBefore = notes.rollSamples;
      second.feed(monitor, first.duration() + 0.1);
      monitor.finish();
      boolean warned = notes.kicksAtWarning >= before;
      // Never warned counts as after all that came.
      kicks[i] = (warned ? notes.kicksAtWarning : notes.kicks) - before;
      samples[i] = (warned ? notes.samplesAtWarning : notes.rollSamples) - samplesBefore;
    }
    Arrays.sort(kicks);
    Arrays.sort(samples);
    Goal goal = Goal.atMost(31, "%.0f kicks");
    out.printf(
        "accRoll +30 %% at half time, %d matches: warned after %d kicks, at most %d  (%s)  %s;"
            + " %d samples, at most %d%n",
        matches,
        kicks[matches / 2],
        kicks[matches - 1],
        goal,
        goal.verdict(kicks[matches - 1]),
        samples[matches / 2],
        samples[matches - 1]);
  }

  private void speed() {
    SimulatedMatch match = match(900, settings.minutes(), ROLL, SMALL);
    SimulatedRecording recording = match.recording();
    List<VisionFrame> frames = recording.frames();
    LiveMonitor monitor =
        new LiveMonitor(LiveSettings.defaults(), recording.epoch(), LiveListener.NONE);
    Thread worker = new Thread(() -> work(monitor));
    worker.setDaemon(true);
    worker.start();
    monitor.geometry(recording.geometry());
    long[] nanos = new long[frames.size()];
    for (int i = 0; i < nanos.length; i++) {
      long start = System.nanoTime();
      monitor.accept(frames.get(i));
      monitor.snapshot();
      nanos[i] = System.nanoTime() - start;
    }
    worker.interrupt();
    Arrays.sort(nanos);
    double p99 = 1e-6 * nanos[(int) (0.99 * nanos.length)];
    Goal soon = Goal.atMost(2, "%.0f ms");
    out.printf(
        Locale.ROOT,
        "frame to a snapshot that has it, fits beside it: median %.3f ms, p99 %.3f ms, p99.9 %.2f"
            + " ms  (%s)  %s%n",
        1e-6 * nanos[nanos.length / 2],
        p99,
        1e-6 * nanos[(int) (0.999 * nanos.length)],
        soon,
        soon.verdict(p99));
  }

  private static void work(LiveMonitor monitor) {
    try {
      while (true) {
        if (!monitor.poll()) {
          Thread.sleep(1);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
