package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.report.CalibrationReportWriter;
import fieldcal.app.wording.PublishWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.ExtendedCalibration;
import fieldcal.calibration.ExtendedCalibrator;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.FitSettings;
import fieldcal.kick.Kick;
import fieldcal.verdict.PublishDecision;
import fieldcal.verdict.PublishVerdict;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Recordings in, calibration and its files out. */
public final class CalibrationSession {
  private final FitSettings settings;
  private final LogOpener opener;

  /**
   * A session.
   *
   * @param settings of the fits
   */
  public CalibrationSession(FitSettings settings) {
    this(settings, LogOpener.USUAL);
  }

  /**
   * A session with a limit of its own.
   *
   * @param settings of the fits
   * @param opener opens the recordings
   */
  public CalibrationSession(FitSettings settings, LogOpener opener) {
    this.settings = settings;
    this.opener = opener;
  }

  /** Is called with how far the work is. */
  public interface Progress extends KickCollector.Progress {
    /** Nobody looks. */
    Progress UNSEEN = (log, bytesRead, totalBytes) -> {};

    /**
     * Fitting begins.
     *
     * @param kicks how many there are
     */
    default void fitting(int kicks) {}

    /** One more kick is fitted; called from several threads. */
    default void fitted() {}
  }

  /**
   * Reads and calibrates.
   *
   * @param request what is wanted
   * @param progress is called with how far it is
   * @return the outcome
   * @throws IOException when a recording cannot be read; one line for the operator
   */
  public CalibrationOutcome run(CalibrationRequest request, Progress progress) throws IOException {
    return calibrate(
        new KickCollector(progress, opener).collect(request.logs()), request, progress);
  }

  /**
   * Calibrates what was read before.
   *
   * @param data the kicks of the recordings
   * @param request what is wanted of them
   * @param progress is called with how far it is
   * @return the outcome
   */
  public CalibrationOutcome calibrate(
      CollectedKicks data, CalibrationRequest request, Progress progress) {
    BallModels start = request.initial().orElse(data.published());
    progress.fitting(data.kicks().size());
    CalibrationProblem problem =
        new CalibrationProblem(
            data.kicks(),
            data.epoch(),
            data.cameras(),
            start.flat().orElse(FlatModel.typical()),
            start.chip().orElse(ChipModel.typical()),
            request.kind(),
            request.selection());
    Consumer<Kick> fitted = kick -> progress.fitted();
    Optional<ExtendedCalibration> extended =
        request.model().map(m -> under(m, problem, data, fitted));
    Calibration calibration =
        extended
            .map(ExtendedCalibration::calibration)
            .orElseGet(() -> new Calibrator(settings).calibrate(problem, fitted));
    return new CalibrationOutcome(
        request.logs(),
        data,
        start,
        request.selection(),
        request.commands(),
        calibration,
        extended,
        RecordingFacts.surroundings(data.recordings()),
        request.kind(),
        Optional.empty());
  }

  private ExtendedCalibration under(
      ExtendedModel model, CalibrationProblem problem, CollectedKicks data, Consumer<Kick> fitted) {
    // What grows with time grows from here on: how far it had come when the recordings began is in
    // the parameters that are calibrated.
    ExtendedModel here = model.withSessionStart(data.sessionStart());
    return new ExtendedCalibrator(settings, here, data.observers()).calibrate(problem, fitted);
  }

  /**
   * Whether a {@code calibration.json} holds a calibration, whatever verdict it has: the same numbers from the same recordings, with the same decisions, commands and published model.
   *
   * @param outcome the calibration
   * @param document the content of the file
   * @return true when writing it again would change the verdict at most
   */
  public static boolean isIn(JsonNode document, CalibrationOutcome outcome) {
    return numbers(document)
        .equals(numbers(JsonFiles.asRead(new CalibrationJson(outcome).build())));
  }

  /** Without what a diagnosis of the same kicks changes: some warnings are about that. */
  private static JsonNode numbers(JsonNode calibration) {
    JsonNode copy = calibration.deepCopy();
    return copy instanceof ObjectNode object ? object.remove(List.of("verdict", "warnings")) : copy;
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
      String comments =
          caution(outcome)
              + outcome.extended().map(e -> ExtendedModelNotes.comments(e.model())).orElse("");
      JsonFiles.write((comments + models.toText()).getBytes(StandardCharsets.UTF_8), text);
    }
    new CalibrationReportWriter()
        .write(new ReportBuilder(outcome).build(), directory.resolve("report.html"));
  }

  /** Comment lines for the text form of a model that should not be published as it is. */
  private static String caution(CalibrationOutcome outcome) {
    PublishVerdict verdict = outcome.verdict();
    if (verdict.decision() == PublishDecision.PUBLISH) {
      return "";
    }
    PublishWords words = PublishWords.of(verdict);
    return Stream.concat(Stream.of(words.headline()), words.reasons().stream())
        .map(line -> "# " + line + "\n")
        .collect(Collectors.joining());
  }
}
