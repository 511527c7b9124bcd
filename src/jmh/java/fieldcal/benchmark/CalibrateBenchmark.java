package fieldcal.benchmark;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Wall time of calibrating the two recordings of test-data, the files of --out included: in this process, first and warm, and as
 * the operator has it, a process of its own.
 */
final class CalibrateBenchmark {
  private static final Goal SECONDS = Goal.atMost(6, "%.0f s");
  private static final List<String> LOGS =
      List.of("test-data/erforce-flat.log.gz", "test-data/erforce-chip.log.gz");

  private CalibrateBenchmark() {}

  static void run(BenchmarkSettings settings, PrintStream out) throws Exception {
    Path project = Path.of(System.getProperty("fieldcal.projectDir", ".")).toAbsolutePath();
    try (Scratch scratch = new Scratch("calibrate-benchmark")) {
      Path directory = scratch.path();
      double[] fresh = new double[settings.runs()];
      FieldcalProcess.run(project, List.of("--help")); // builds, when something has changed
      for (int run = 0; run < fresh.length; run++) {
        List<String> arguments = new ArrayList<>(List.of("calibrate"));
        arguments.addAll(LOGS);
        arguments.addAll(List.of("--out", directory.resolve("fresh").toString()));
        fresh[run] = FieldcalProcess.run(project, arguments).seconds();
      }
      double[] here = new double[1 + settings.runs()];
      for (int run = 0; run < here.length; run++) {
        here[run] = inProcess(project, directory.resolve("here"));
      }
      out.printf("%-40s %9s %9s %9s %8s  %s%n", "", "fastest", "median", "slowest", "goal", "");
      print(out, "./fieldcal calibrate, fresh process", fresh, true);
      print(out, "in this process, first", Arrays.copyOf(here, 1), false);
      print(out, "in this process, warm", Arrays.copyOfRange(here, 1, here.length), false);
    }
  }

  private static double inProcess(Path project, Path directory) throws IOException {
    long before = System.nanoTime();
    CalibrationOutcome outcome =
        new CalibrationSession(FitSettings.defaults())
            .run(
                CalibrationRequest.of(
                    LOGS.stream().map(project::resolve).toList(), HandSelection.none(), List.of()),
                CalibrationSession.Progress.UNSEEN);
    CalibrationSession.writeAll(outcome, directory);
    return (System.nanoTime() - before) * 1e-9;
  }

  private static void print(PrintStream out, String what, double[] seconds, boolean judged) {
    double[] sorted = seconds.clone();
    Arrays.sort(sorted);
    double median = sorted[sorted.length / 2];
    out.printf(
        Locale.ROOT,
        "%-40s %7.2f s %7.2f s %7.2f s %8s  %s%n",
        what,
        sorted[0],
        median,
        sorted[sorted.length - 1],
        judged ? SECONDS : "",
        judged ? SECONDS.verdict(median) : "");
  }
}
