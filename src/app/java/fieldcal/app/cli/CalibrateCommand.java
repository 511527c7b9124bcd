package fieldcal.app.cli;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.calibrate.SelectionFile;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.app.diagnose.FormerDiagnosis;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.replay.KickReplay;
import fieldcal.app.replay.KickTables;
import fieldcal.app.wording.PublishWords;
import fieldcal.calibration.HandSelection;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.FitSettings;
import fieldcal.kick.KickKind;
import fieldcal.verdict.Finding;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal calibrate}: recordings to a ball model. */
@Command(
    name = "calibrate",
    mixinStandardHelpOptions = true,
    description =
        "Finds the kicks of one or more recordings, fits them, and computes a ball model with"
            + " standard errors.")
final class CalibrateCommand implements Callable<Integer> {
  private static final Epoch UNIX = new Epoch(0);

  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "LOG",
      description =
          "SSL game logs, .log or .log.gz, or a folder; of a folder, only recordings that belong"
              + " together are used, without those of matches, simulated fields and other fields")
  private List<Path> logs;

  @Option(
      names = "--kind",
      paramLabel = "auto|flat|chip",
      defaultValue = "auto",
      description = "what the kicks are; auto (default) decides for each kick")
  private String kind;

  @Option(
      names = "--commands",
      paramLabel = "CSV",
      description =
          "CSV file of the robots' commands:"
              + " t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg")
  private Path commands;

  @Option(
      names = "--initial",
      paramLabel = "FILE",
      description =
          "published model to start from and to compare with: SSL_GeometryModels (binary or text)"
              + " or a calibration.json; default: the model that the recording publishes")
  private Path initial;

  @Option(
      names = "--model",
      paramLabel = "FILE",
      description =
          "extended_model.json of diagnose: its effects are taken out of the detections, so that"
              + " the parameters are valid together with them")
  private Path model;

  @Option(
      names = "--selection",
      paramLabel = "FILE",
      description =
          "file with the kicks dropped or kept by hand (default: selection.json in the directory of"
              + " --out, if it exists)")
  private Path selection;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "seed of the random search (default: ${DEFAULT-VALUE})",
      defaultValue = "20260101")
  private long seed;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "writes report.html, calibration.json, geometry_models.pb, geometry_models.txt and"
              + " selection.json to this directory")
  private Path out;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "writes calibration.json to this file")
  private Path json;

  @Option(
      names = "--csv",
      paramLabel = "DIR",
      description =
          "writes kicks.csv and observations.csv to this directory, for spreadsheets, pandas and"
              + " PlotJuggler")
  private Path csv;

  @Option(
      names = "--mcap",
      paramLabel = "FILE",
      description =
          "writes frames, fitted paths and residuals of all kicks to this file, for Foxglove and"
              + " PlotJuggler")
  private Path mcap;

  @Override
  public Integer call() throws IOException {
    Optional<KickKind> forced = forcedKind();
    OutputPlaces.check(out, json);
    OutputPlaces.checkDirectory("--csv", csv);
    OutputPlaces.checkFile("--mcap", mcap);
    LogArguments arguments = LogArguments.of(logs, logOptions.opener());
    HandSelection byHand = SelectionFile.readOrFormer(selection, arguments.decisions(out));
    Optional<BallModels> start =
        initial == null ? Optional.empty() : Optional.of(InitialModels.read(initial));
    Optional<ExtendedModel> extended =
        model == null ? Optional.empty() : Optional.of(ExtendedModelFile.read(model, UNIX));
    List<CommandFile.Command> told = arguments.commands(commands);
    CalibrationRequest request =
        new CalibrationRequest(arguments.logs(), forced, start, extended, byHand, told);
    CalibrationSession session =
        new CalibrationSession(FitSettings.defaults().withSeed(seed), logOptions.opener());
    CalibrationOutcome outcome;
    try (WorkProgress progress = new WorkProgress(Heartbeat.of(spec))) {
      CollectedKicks data =
          new KickCollector(progress, logOptions.opener())
              .collect(request.logs())
              .withProblems(arguments.notRead());
      outcome = diagnosed(session.calibrate(data, request, progress), arguments.decisions(out));
    }
    if (out != null) {
      CalibrationSession.writeAll(outcome, out);
    }
    if (json != null) {
      CalibrationSession.writeJson(outcome, json);
    }
    if (csv != null) {
      new KickTables(outcome).write(csv);
    }
    if (mcap != null) {
      new KickReplay(outcome, logOptions.opener()).write(mcap);
    }
    CalibrationText text = new CalibrationText(spec.commandLine().getOut());
    text.verdict(PublishWords.of(outcome.verdict()));
    arguments.tell(spec.commandLine().getOut());
    text.details(outcome, out);
    if (commands != null) {
      text.commands(outcome, commands);
    }
    return 0;
  }

  /** With what a diagnosis of the same kicks found, if there is one beside the decisions. */
  private static CalibrationOutcome diagnosed(CalibrationOutcome outcome, Path directory) {
    Optional<Finding> finding =
        Optional.ofNullable(directory)
            .flatMap(FormerDiagnosis::read)
            .flatMap(former -> former.about(outcome));
    return outcome.knowing(finding, outcome.surroundings().vision());
  }

  private Optional<KickKind> forcedKind() {
    return switch (kind.toLowerCase(Locale.ROOT)) {
      case "auto" -> Optional.empty();
      case "flat" -> Optional.of(KickKind.FLAT);
      case "chip" -> Optional.of(KickKind.CHIP);
      default ->
          throw new ParameterException(
              spec.commandLine(), "--kind must be auto, flat or chip, not '" + kind + "'");
    };
  }
}
