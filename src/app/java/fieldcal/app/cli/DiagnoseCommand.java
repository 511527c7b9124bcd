package fieldcal.app.cli;

import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.SelectionFile;
import fieldcal.app.diagnose.CalibrationBeside;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal diagnose}: what the calibrated model gets wrong, why, and what it gains to know. */
@Command(
    name = "diagnose",
    mixinStandardHelpOptions = true,
    description =
        "Finds what the calibrated ball model gets wrong, which causes explain it, how certain that"
            + " is, and how much better a model with them predicts.")
final class DiagnoseCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "LOG",
      description =
          "SSL game logs, .log or .log.gz, or a folder, of which the same recordings are used as by"
              + " calibrate")
  private List<Path> logs;

  @Option(
      names = "--commands",
      paramLabel = "CSV",
      description =
          "CSV file of the robots' commands:"
              + " t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg; without it, kickers"
              + " cannot be judged")
  private Path commands;

  @Option(
      names = "--max-causes",
      paramLabel = "N",
      description = "how many causes may be named (default: ${DEFAULT-VALUE})",
      defaultValue = "" + DiagnosisProblem.DEFAULT_MAX_CAUSES)
  private int maxCauses;

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
      description =
          "seed of the random search and of the choice of kicks that are held out (default:"
              + " ${DEFAULT-VALUE})",
      defaultValue = "20260101")
  private long seed;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "writes diagnosis.html, diagnosis.json and extended_model.json to this directory")
  private Path out;

  @Option(names = "--json", paramLabel = "FILE", description = "writes diagnosis.json to this file")
  private Path json;

  @Override
  public Integer call() throws IOException {
    if (maxCauses < 0) {
      throw new ParameterException(
          spec.commandLine(), "--max-causes must be 0 or more, not " + maxCauses);
    }
    OutputPlaces.check(out, json);
    LogArguments arguments = LogArguments.of(logs, logOptions.opener());
    HandSelection byHand = SelectionFile.readOrFormer(selection, arguments.decisions(out));
    List<CommandFile.Command> told = arguments.commands(commands);
    FitSettings settings = FitSettings.defaults().withSeed(seed);
    DiagnosisSession session = new DiagnosisSession(settings, maxCauses, logOptions.opener());
    DiagnosisOutcome outcome;
    try (WorkProgress progress = new WorkProgress(Heartbeat.of(spec))) {
      CollectedKicks data =
          new KickCollector(progress, logOptions.opener())
              .collect(arguments.logs())
              .withProblems(arguments.notRead());
      outcome =
          session.diagnose(
              new CalibrationSession(settings, logOptions.opener())
                  .calibrate(data, CalibrationRequest.of(arguments.logs(), byHand, told), progress),
              progress::diagnosing);
    }
    CalibrationBeside beside = CalibrationBeside.NONE;
    if (out != null) {
      DiagnosisSession.writeAll(outcome, out);
      beside = CalibrationBeside.judgeAgain(outcome, out);
    }
    if (json != null) {
      DiagnosisSession.writeJson(outcome, json);
    }
    DiagnosisText text = new DiagnosisText(spec.commandLine().getOut());
    text.print(outcome, out);
    arguments.tell(spec.commandLine().getOut());
    text.model(beside, outcome, out);
    return 0;
  }
}
