package fieldcal.effect;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import java.io.PrintStream;
import java.util.Collection;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/** The queries of {@link ExtendedQueryBenchmark} against their goal, and what they allocate. */
public final class ExtendedQueries {
  private static final Goal NANOSECONDS = Goal.atMost(1000, "%.0f ns");

  private ExtendedQueries() {}

  /**
   * Measures and prints.
   *
   * @param settings not used: the micro benchmarks have their own
   * @param out for people
   * @param findings the numbers with a goal
   * @throws RunnerException when JMH cannot run
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws RunnerException {
    Collection<RunResult> results =
        new Runner(
                new OptionsBuilder()
                    .include(ExtendedQueryBenchmark.class.getSimpleName())
                    .forks(1)
                    .addProfiler(GCProfiler.class)
                    .verbosity(VerboseMode.SILENT)
                    .build())
            .run();
    out.printf("%-26s %9s %10s %10s  %s%n", "query", "time", "allocates", "goal", Goal.VERDICT);
    for (RunResult result : results) {
      double time = result.getPrimaryResult().getScore();
      Result<?> allocated = result.getSecondaryResults().get("gc.alloc.rate.norm");
      double bytes = allocated == null ? Double.NaN : allocated.getScore();
      String name = result.getParams().getBenchmark();
      out.printf(
          "%-26s %6.1f ns %8.0f B %10s  %s%n",
          name.substring(name.lastIndexOf('.') + 1) + ", " + result.getParams().getParam("kick"),
          time,
          bytes,
          NANOSECONDS,
          NANOSECONDS.verdict(time));
      String what = "a path with three effects, %s: %s";
      findings.value(
          what.formatted(
              result.getParams().getParam("kick"), name.substring(name.lastIndexOf('.') + 1)),
          "%.0f ns",
          time,
          NANOSECONDS);
    }
  }
}
