package fieldcal.app.compare;

import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.limits.LimitsSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Recordings of a field and of a simulator in, their comparison and its files out. */
public final class CompareSession {
  private final FitSettings settings;
  private final LogOpener opener;

  /**
   * A session.
   *
   * @param settings of the fits; their seed is also that of the diagnoses
   * @param opener opens the recordings
   */
  public CompareSession(FitSettings settings, LogOpener opener) {
    this.settings = settings;
    this.opener = opener;
  }

  /**
   * Both sides and what came out.
   *
   * @param real the field
   * @param sim the simulator
   * @param comparison of both
   */
  public record Outcome(Side real, Side sim, FieldComparison comparison) {}

  /**
   * Calibrates, diagnoses and compares.
   *
   * @param real recordings of the field
   * @param realCommands what its robots were commanded; may be empty
   * @param sim recordings of the simulator
   * @param simCommands what its robots were commanded; may be empty
   * @param progress of each side, told how far it is
   * @return the outcome
   * @throws IOException when a recording cannot be read or has no kick; one line for the operator
   */
  public Outcome run(
      List<Path> real,
      List<Command> realCommands,
      List<Path> sim,
      List<Command> simCommands,
      List<DiagnosisSession.Progress> progress)
      throws IOException {
    DiagnosisOutcome first = diagnosed(real, realCommands, progress.get(0));
    DiagnosisOutcome second = diagnosed(sim, simCommands, progress.get(1));
    Side field = side(real, SecondLook.at(first, second, progress.get(0)::diagnosing));
    Side simulator = side(sim, SecondLook.at(second, first, progress.get(1)::diagnosing));
    return new Outcome(field, simulator, new FieldComparer(field, simulator).compare());
  }

  private DiagnosisOutcome diagnosed(
      List<Path> logs, List<Command> commands, DiagnosisSession.Progress progress)
      throws IOException {
    return new DiagnosisSession(settings, DiagnosisProblem.DEFAULT_MAX_CAUSES, opener)
        .run(logs, HandSelection.none(), commands, progress);
  }

  private Side side(List<Path> logs, DiagnosisOutcome diagnosis) throws IOException {
    return new Side(
        diagnosis,
        FieldRecording.of(diagnosis.calibration(), opener),
        new LimitsSession(1, opener).run(logs, (read, total) -> {}));
  }

  /**
   * Writes {@code compare.json} and {@code compare.html}.
   *
   * @param outcome what to write
   * @param directory made if needed
   * @throws IOException when a file cannot be written
   */
  public static void writeAll(Outcome outcome, Path directory) throws IOException {
    Files.createDirectories(directory);
    CompareJson.write(outcome, directory.resolve("compare.json"));
    ComparePage.write(outcome, directory.resolve("compare.html"));
  }

  /**
   * Writes {@code compare.json} alone.
   *
   * @param outcome what to write
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void writeJson(Outcome outcome, Path file) throws IOException {
    CompareJson.write(outcome, file);
  }
}
