package fieldcal.app.diagnose;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.report.diagnosis.DiagnosisReport;
import fieldcal.app.report.diagnosis.DiagnosisReportBuilder;
import fieldcal.app.report.diagnosis.DiagnosisReportWriter;
import fieldcal.app.wording.PublishWords;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.KickCommand;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** Recordings in, diagnosis and its files out. */
public final class DiagnosisSession {
  /** A single kick shows what the model gets wrong of it; to hold kicks out, and to be sure, it takes more. */
  public static final int MIN_KICKS = 1;

  private final FitSettings settings;
  private final int maxCauses;
  private final LogOpener opener;

  /**
   * A session.
   *
   * @param settings of the fits; their seed is also the diagnosis's
   * @param maxCauses how many causes may be named, 0 or more
   */
  public DiagnosisSession(FitSettings settings, int maxCauses) {
    this(settings, maxCauses, LogOpener.USUAL);
  }

  /**
   * A session with a limit of its own.
   *
   * @param settings of the fits; their seed is also the diagnosis's
   * @param maxCauses how many causes may be named, 0 or more
   * @param opener opens the recordings
   */
  public DiagnosisSession(FitSettings settings, int maxCauses, LogOpener opener) {
    this.settings = settings;
    this.maxCauses = maxCauses;
    this.opener = opener;
  }

  /** Told how far the work is. */
  public interface Progress extends CalibrationSession.Progress {
    /** Nobody looks. */
    Progress UNSEEN = (log, bytesRead, totalBytes) -> {};

    /**
     * The diagnosis does something.
     *
     * @param what in words
     */
    default void diagnosing(String what) {}
  }

  /**
   * Reads, calibrates and diagnoses.
   *
   * @param logs at least one recording
   * @param selection decisions by hand
   * @param commands what the robots were commanded; may be empty
   * @param progress told how far it is
   * @return the outcome
   * @throws InputException when the kicks are from different fields, or too few; one line for the operator
   * @throws IOException when a recording cannot be read; one line for the operator
   */
  public DiagnosisOutcome run(
      List<Path> logs,
      HandSelection selection,
      List<CommandFile.Command> commands,
      Progress progress)
      throws IOException {
    CalibrationOutcome calibration =
        new CalibrationSession(settings, opener)
            .run(CalibrationRequest.of(logs, selection, commands), progress);
    return diagnose(calibration, progress::diagnosing);
  }

  /**
   * Diagnoses what was calibrated before.
   *
   * @param calibration of the simple model, with the decisions that say which kicks are left out
   * @param progress told what is done, in words
   * @return the outcome
   * @throws InputException when the kicks are from different fields, are too few, or have too few detections; one line for the operator
   */
  public DiagnosisOutcome diagnose(CalibrationOutcome calibration, Consumer<String> progress)
      throws InputException {
    requireOneField(calibration);
    DiagnosisProblem problem = problem(calibration);
    requireKicks(calibration, problem);
    try {
      Diagnosis diagnosis = new Diagnoser().diagnose(problem, progress);
      return new DiagnosisOutcome(calibration, problem, diagnosis);
    } catch (IllegalArgumentException e) {
      throw new InputException(logs(calibration) + ": " + e.getMessage());
    }
  }

  private DiagnosisProblem problem(CalibrationOutcome outcome) {
    // A kick with fewer detections than twice its parameters determines nothing.
    List<KickFit> fits =
        outcome.calibration().fitted().stream()
            .filter(f -> outcome.selection().droppedBecause(outcome.key(f.kick())).isEmpty())
            .filter(f -> f.statistics().used() > 2 * f.estimates().size())
            .toList();
    Map<Integer, KickCommand> commands = new HashMap<>();
    for (KickFit fit : fits) {
      // A command of speed zero is no kick, whatever moved the ball.
      outcome
          .command(fit.kick())
          .filter(c -> c.speed() > 0)
          .ifPresent(
              c ->
                  commands.put(
                      fit.kick().id(),
                      new KickCommand(c.robot(), c.speed(), c.direction(), c.elevation())));
    }
    return new DiagnosisProblem(
        fits,
        outcome.calibration().cameras(),
        outcome.data().observers(),
        outcome.data().sessionStart(),
        commands,
        maxCauses,
        settings.seed());
  }

  /** What would be found in kicks of several fields is how these differ: no cause on any of them. */
  private static void requireOneField(CalibrationOutcome outcome) throws InputException {
    Optional<String> mixture = PublishWords.mixture(outcome.verdict());
    if (mixture.isPresent()) {
      throw new InputException(mixture.get() + " Diagnose each field on its own.");
    }
  }

  private static void requireKicks(CalibrationOutcome outcome, DiagnosisProblem problem)
      throws InputException {
    int used = problem.fits().size();
    if (used >= MIN_KICKS) {
      return;
    }
    int found = outcome.data().kicks().size();
    String have =
        found == 0
            ? "no kick found"
            : found + (found == 1 ? " kick" : " kicks") + " found, " + used + " of use";
    String why =
        outcome.calibration().kicks().stream()
            .filter(k -> !problem.fits().contains(k.fit()))
            .findFirst()
            .map(k -> " (kick " + k.fit().kick().id() + ": " + reason(k) + ")")
            .orElse("");
    throw new InputException(
        logs(outcome)
            + ": "
            + have
            + why
            + "; a diagnosis needs at least "
            + MIN_KICKS
            + ", better 20");
  }

  private static String logs(CalibrationOutcome outcome) {
    return outcome.logs().stream().map(Path::toString).collect(Collectors.joining(", "));
  }

  private static String reason(CalibratedKick kick) {
    return kick.distrusted().orElse("too few detections");
  }

  /**
   * Writes {@code diagnosis.json} alone.
   *
   * @param outcome what to write
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void writeJson(DiagnosisOutcome outcome, Path file) throws IOException {
    JsonFiles.write(new DiagnosisJson(outcome).build(), file);
  }

  /**
   * Writes {@code diagnosis.html}, {@code diagnosis.json} and {@code extended_model.json}.
   *
   * @param outcome what to write
   * @param directory made if needed
   * @throws IOException when a file cannot be written
   */
  public static void writeAll(DiagnosisOutcome outcome, Path directory) throws IOException {
    Files.createDirectories(directory);
    writeJson(outcome, directory.resolve("diagnosis.json"));
    CalibrationOutcome calibration = outcome.calibration();
    ExtendedModelFile.write(
        outcome.diagnosis().model(),
        calibration.data().epoch(),
        MadeFrom.of(calibration),
        directory.resolve("extended_model.json"));
    DiagnosisReport report =
        new DiagnosisReportBuilder(
                outcome.diagnosis(),
                calibration.data(),
                calibration.logs().stream().map(Path::toString).toList(),
                LeftOutKick.remarks(LeftOutKick.of(outcome)))
            .build();
    new DiagnosisReportWriter().write(report, directory.resolve("diagnosis.html"));
  }
}
