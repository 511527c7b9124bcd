package fieldcal.app.calibrate;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.report.CalibrationReportWriter;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Recordings in, calibration and its files out. */
public final class CalibrationSession {
  private final FitSettings settings;

  /**
   * A session.
   *
   * @param settings of the fits
   */
  public CalibrationSession(FitSettings settings) {
    this.settings = settings;
  }

  /** Told how far the work is. */
  public interface Progress extends KickCollector.Progress {
    /**
     * Fitting begins.
     *
     * @param kicks how many there are
     */
    void fitting(int kicks);

    /** One more kick is fitted; called from several threads. */
    void fitted();
  }

  /**
   * Reads and calibrates.
   *
   * @param logs at least one recording
   * @param kind when present, all kicks are of that kind
   * @param initial where to start; without it, from what the recordings publish, or typical values
   * @param selection decisions by hand
   * @param commands what the robots were told; may be empty
   * @param progress told how far it is
   * @return the outcome
   * @throws IOException when a recording cannot be read; one line for the operator
   */
  public CalibrationOutcome run(
      List<Path> logs,
      Optional<KickKind> kind,
      Optional<BallModels> initial,
      HandSelection selection,
      List<CommandFile.Command> commands,
      Progress progress)
      throws IOException {
    CollectedKicks data = new KickCollector(progress).collect(logs);
    BallModels start = initial.orElse(data.published());
    progress.fitting(data.kicks().size());
    CalibrationProblem problem =
        new CalibrationProblem(
            data.kicks(),
            data.epoch(),
            data.cameras(),
            start.flat().orElse(FlatModel.typical()),
            start.chip().orElse(ChipModel.typical()),
            kind,
            selection);
    Calibration calibration =
        new Calibrator(settings).calibrate(problem, kick -> progress.fitted());
    return new CalibrationOutcome(logs, data, start, selection, commands, calibration);
  }

  /**
   * Writes {@code calibration.json} alone.
   *
   * @param outcome what to write
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void writeJson(CalibrationOutcome outcome, Path file) throws IOException {
    JsonFiles.write(new CalibrationJson(outcome).build(), file);
  }

  /**
   * Writes {@code calibration.json}, {@code report.html}, {@code selection.json} and, when a model is complete, {@code
   * geometry_models.pb} and {@code geometry_models.txt}.
   *
   * @param outcome what to write
   * @param directory made if needed
   * @throws IOException when a file cannot be written
   */
  public static void writeAll(CalibrationOutcome outcome, Path directory) throws IOException {
    Files.createDirectories(directory);
    writeJson(outcome, directory.resolve("calibration.json"));
    SelectionFile.write(
        outcome.calibration(),
        outcome.selection(),
        outcome.data().epoch(),
        directory.resolve("selection.json"));
    BallModels models = outcome.models();
    Path binary = directory.resolve("geometry_models.pb");
    Path text = directory.resolve("geometry_models.txt");
    if (models.equals(BallModels.NONE)) {
      // A model of an earlier run must not be taken for one of this run.
      Files.deleteIfExists(binary);
      Files.deleteIfExists(text);
    } else {
      JsonFiles.write(models.toBytes(), binary);
      JsonFiles.write(models.toText().getBytes(StandardCharsets.UTF_8), text);
    }
    new CalibrationReportWriter()
        .write(new ReportBuilder(outcome).build(), directory.resolve("report.html"));
  }
}
