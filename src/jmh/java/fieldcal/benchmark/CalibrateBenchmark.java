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
 * Wall time of {@code --help}, of calibrating 60 simulated kicks, and of calibrating the two recordings of test-data, the files of --out included: in this process, first and warm, and as
 * the operator has it, a process of its own.
 */
final class CalibrateBenchmark {
  private static final Goal SECONDS = Goal.atMost(6, "%.0f s");
  private static final Goal SIXTY = Goal.atMost(2, "%.0f s");
  private static final Goal HELP = Goal.atMost(0.25, "%.2f s");
  private static final List<String> LOGS =
      List.of("test-data/erforce-flat.log.gz", "test-data/erforce-chip.log.gz");

  private CalibrateBenchmark() {}

  static void run(BenchmarkSettings settings, PrintStream out, Findings findings) throws Exception {
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
      findings.value(
          "`./fieldcal calibrate` of the two ER-Force recordings, median",
          "%.2f s",
          median(fresh),
          SECONDS);
      double[] sixty = new double[settings.runs()];
      double[] help = new double[settings.runs()];
      Path log = directory.resolve("sixty.log.gz");
      FieldcalProcess.run(
          project,
          List.of(
              "simulate",
              "--scenario=mixed",
              "--kicks=60",
              "--seed=" + settings.seed(),
              "--out=" + log));
      for (int run = 0; run < sixty.length; run++) {
        help[run] = FieldcalProcess.run(project, List.of("--help")).seconds();
        sixty[run] =
            FieldcalProcess.run(
                    project,
                    List.of("calibrate", log.toString(), "--out=" + directory.resolve("sixty")))
                .seconds();
      }
      print(out, "./fieldcal calibrate, 60 kicks", sixty, false);
      print(out, "./fieldcal --help", help, false);
      findings.value(
          "`./fieldcal calibrate` of a recording of 60 kicks, files included, median",
          "%.2f s",
          median(sixty),
          SIXTY);
      findings.value("`./fieldcal --help`, median", "%.2f s", median(help), HELP);
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

  private static double median(double[] seconds) {
    double[] sorted = seconds.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static void print(PrintStream out, String what, double[] seconds, boolean judged) {
    double[] sorted = seconds.clone();
    Arrays.sort(sorted);
    double median = median(seconds);
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
