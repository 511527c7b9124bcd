package fieldcal.live;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.simulation.Preset;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** How fast drawn matches are replayed from memory with fits and limits, in time of one core: three of 6 against 6 and one of 11 against 11 on an ideal carpet, and two on the carpets of tournaments. */
public final class ReplayBenchmark {
  private static final double ROLL = -0.28;
  private static final Goal FAST = Goal.atLeast(300, "%.0f");

  /** The first runs are slower, until Java has compiled what is used most. */
  private static final int RUNS = 5;

  private ReplayBenchmark() {}

  /**
   * Measures.
   *
   * @param settings minutes, seed
   * @param out gets the numbers
   * @param findings those with a goal
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    long seed = 1000 * settings.seed();
    double minutes = settings.minutes();
    List<SimulatedMatch> matches = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      matches.add(SimulatedMatch.play(seed + i, minutes, ROLL, 6));
    }
    matches.add(SimulatedMatch.play(seed + 3, minutes, ROLL, 11));
    matches.add(SimulatedMatch.on(Preset.of("german-open-2026"), seed + 4, minutes, 1));
    matches.add(SimulatedMatch.on(Preset.of("robocup-2026"), seed + 5, minutes, 1));
    double[] least = new double[matches.size()];
    for (int run = 0; run < RUNS; run++) {
      for (int m = 0; m < least.length; m++) {
        double used = replay(matches.get(m));
        least[m] = run == 0 ? used : Math.min(least[m], used);
      }
    }
    double all = 0;
    double duration = 0;
    StringBuilder each = new StringBuilder();
    for (int m = 0; m < least.length; m++) {
      double length = matches.get(m).duration();
      all += least[m];
      duration += length;
      each.append(String.format(Locale.ROOT, " %.0f", length / least[m]));
    }
    out.printf(
        Locale.ROOT,
        "replay with fits and limits, best of %d runs, in time of one core: %.0f times real time "
            + " (%s)  %s; each:%s%n",
        RUNS,
        duration / all,
        FAST,
        FAST.verdict(duration / all),
        each);
    findings.value(
        "replay of six matches with fits and limits, per core, times real time",
        "%.0f",
        duration / all,
        FAST);
  }

  /** Time of this thread alone: what others do on the machine counts little. */
  private static double replay(SimulatedMatch match) {
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(60),
            match.recording().epoch(),
            LiveListener.NONE,
            Runnable::run);
    long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    match.feed(monitor, 0);
    monitor.finish();
    return 1e-9 * (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start);
  }
}
