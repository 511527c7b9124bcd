package fieldcal.benchmark;

import fieldcal.ball.BallTrajectoryBenchmark;
import fieldcal.fit.FitSpeedBenchmark;
import java.io.PrintStream;
import java.util.Collection;
import java.util.Locale;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/** The micro benchmarks that have goals, beside these. */
final class MicroBenchmarks {
  private static final Goal FLAT_FIT = Goal.atMost(2.5, "%.1f ms");
  private static final Goal CHIP_FIT = Goal.atMost(8, "%.0f ms");
  private static final Goal FLAT_STATE = Goal.atMost(10, "%.0f ns");
  private static final Goal CHIP_STATE = Goal.atMost(30, "%.0f ns");
  private static final Goal NOTHING = Goal.atMost(0, "%.0f B");

  /** What the profiler counts where nothing is allocated is below that, B. */
  private static final double ROUNDING = 0.5;

  private MicroBenchmarks() {}

  /** Median time of the fit of one kick of some 500 detections. */
  static void fit(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws RunnerException {
    for (RunResult result : run(FitSpeedBenchmark.class.getSimpleName() + ".fit", settings)) {
      String kind = result.getParams().getParam("kind").toLowerCase(Locale.ROOT);
      double median = result.getPrimaryResult().getStatistics().getPercentile(50);
      out.printf(Locale.ROOT, "%s fit: %.2f ms%n", kind, median);
      findings.value(
          "fit of a " + kind + " kick with 500 detections, one core, median",
          "%.1f ms",
          median,
          kind.equals("flat") ? FLAT_FIT : CHIP_FIT);
    }
  }

  /** Time and memory of the state on a path at a time. */
  static void trajectories(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws RunnerException {
    String pattern = BallTrajectoryBenchmark.class.getSimpleName() + ".(flat|chip)State";
    for (RunResult result : run(pattern, settings)) {
      boolean flat = result.getPrimaryResult().getLabel().startsWith("flat");
      String what = "state at a time, " + (flat ? "flat" : "chip");
      double time = result.getPrimaryResult().getScore();
      double bytes = result.getSecondaryResults().get("gc.alloc.rate.norm").getScore();
      out.printf(Locale.ROOT, "%s: %.1f ns, %.3f B%n", what, time, bytes);
      findings.value(what, "%.1f ns", time, flat ? FLAT_STATE : CHIP_STATE);
      double allocated = bytes < ROUNDING ? 0 : bytes;
      findings.value(what + ": allocated", "%.0f B", allocated, NOTHING);
    }
  }

  private static Collection<RunResult> run(String pattern, BenchmarkSettings settings)
      throws RunnerException {
    return new Runner(
            new OptionsBuilder()
                .include(pattern)
                .forks(1)
                .measurementIterations(settings.runs())
                .addProfiler(GCProfiler.class)
                .verbosity(VerboseMode.SILENT)
                .build())
        .run();
  }
}
