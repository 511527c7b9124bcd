package fieldcal.app.twin;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.compare.DrawnPair;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.CpuTime;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Scratch;
import fieldcal.benchmark.ShareGoal;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Twins of drawn fields: how many statistics of their recordings are within their bounds, how far calibrated parameters lie apart, and whether the same causes are diagnosed. Five fields per run. */
public final class TwinBenchmark {
  private static final int FIELDS_PER_RUN = 5;

  /** Flat kicks and chips, half of each. */
  private static final int KICKS = 32;

  /** Standard errors of the difference. */
  private static final double CLOSE = 2;

  private static final ShareGoal WITHIN = ShareGoal.atLeast(0.95);
  private static final ShareGoal PARAMETERS = ShareGoal.atLeast(0.95);
  private static final ShareGoal CAUSES = ShareGoal.atLeast(0.95);

  private final PrintStream out;
  private int fields;
  private int sameCauses;
  private int statistics;
  private int within;
  private int parameters;
  private int close;

  private TwinBenchmark(PrintStream out) {
    this.out = out;
  }

  /**
   * Prints each field, and the counts beside their goals.
   *
   * @param settings runs and seed
   * @param out where to
   * @param findings the numbers of the page
   * @throws IOException when a recording cannot be written
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws IOException {
    TwinBenchmark benchmark = new TwinBenchmark(out);
    for (int i = 0; i < FIELDS_PER_RUN * settings.runs(); i++) {
      benchmark.field(i, DrawnPair.of(settings.seed(), i));
    }
    out.println();
    out.println(
        WITHIN.row("statistics within their bounds", benchmark.within, benchmark.statistics));
    out.println(
        PARAMETERS.row(
            "parameters within 2 standard errors", benchmark.close, benchmark.parameters));
    findings.share(
        "statistics of the recordings within their bounds",
        benchmark.within,
        benchmark.statistics,
        WITHIN);
    findings.share(
        "parameters within two standard errors of each other",
        benchmark.close,
        benchmark.parameters,
        PARAMETERS);
    findings.share(
        "fields whose twin's recording is diagnosed with the same causes",
        benchmark.sameCauses,
        benchmark.fields,
        CAUSES);
    out.println(CAUSES.row("fields with the same causes", benchmark.sameCauses, benchmark.fields));
  }

  private void field(int index, DrawnPair pair) throws IOException {
    try (Scratch scratch = new Scratch("fieldcal-twin-benchmark")) {
      RecordingFiles files = RecordingFiles.besides(scratch.path().resolve("field.log"));
      files.write(pair.simulator(KICKS), share -> {});
      double before = CpuTime.seconds();
      TwinOutcome twin =
          new TwinSession(FitSettings.defaults(), LogOpener.USUAL)
              .run(
                  List.of(files.log()),
                  CommandFile.read(files.commands()),
                  scratch.path().resolve("twin"),
                  DiagnosisSession.Progress.UNSEEN);
      double took = CpuTime.seconds() - before;
      TwinCheck check = twin.check();
      statistics += check.comparisons().size();
      within += check.comparisons().size() - check.different().size();
      for (TwinCheck.Parameter p : check.parameters()) {
        parameters++;
        close += p.sigmas() <= CLOSE ? 1 : 0;
      }
      Set<String> causes = causes(twin.diagnosis());
      Set<String> again = causes(diagnosedAgain(twin));
      fields++;
      sameCauses += causes.equals(again) ? 1 : 0;
      out.printf(
          Locale.ROOT,
          "field %d: %.1f s of CPU, %d of %d kicks found again, causes %s%n",
          index + 1,
          took,
          check.found(),
          check.kicks(),
          causes);
      check.sentences().forEach(s -> out.printf("  DIFFERS %s%n", s));
      check.parameters().stream()
          .filter(p -> !(p.sigmas() <= CLOSE))
          .forEach(
              p ->
                  out.printf(
                      Locale.ROOT,
                      "  APART %s by %.1f standard errors: %.5g ± %.2g and %.5g ± %.2g%n",
                      p.name(),
                      p.sigmas(),
                      p.recorded(),
                      p.recordedError(),
                      p.twin(),
                      p.twinError()));
      if (!causes.equals(again)) {
        out.printf("  OTHER CAUSES of the twin: %s%n", again);
      }
    }
  }

  private static DiagnosisOutcome diagnosedAgain(TwinOutcome twin) throws IOException {
    return new DiagnosisSession(FitSettings.defaults(), DiagnosisProblem.DEFAULT_MAX_CAUSES)
        .run(twin.recordings(), HandSelection.none(), List.of(), DiagnosisSession.Progress.UNSEEN);
  }

  /** Those that kicks alone show: what robots were commanded is not in the twin's recording. */
  private static Set<String> causes(DiagnosisOutcome diagnosed) {
    return diagnosed.diagnosis().causes().stream()
        .map(c -> c.effect().id())
        .filter(id -> !id.equals("robot_kick_bias"))
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
