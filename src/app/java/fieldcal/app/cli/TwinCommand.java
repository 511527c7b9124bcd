package fieldcal.app.cli;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.twin.TwinOutcome;
import fieldcal.app.twin.TwinSession;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal twin}: a simulated field that behaves like the recorded one. */
@Command(
    name = "twin",
    mixinStandardHelpOptions = true,
    description =
        "Makes a simulated field that behaves like the recorded one, records the same kicks on it,"
            + " and compares both recordings.",
    footer = {
      "",
      "Play on it:     fieldcal play --sim --like DIR/twin.json --kind flat --kicks 20",
      "Serve it:       fieldcal simulate --serve --like DIR/twin.json",
      "New recordings: fieldcal simulate --like DIR/twin.json --scenario flat --kicks 24 --out"
          + " FILE"
    })
final class TwinCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "LOG",
      description = "SSL game logs of one field, .log or .log.gz")
  private List<Path> logs;

  @Option(
      names = "--commands",
      paramLabel = "CSV",
      description =
          "CSV file of the robots' commands:"
              + " t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg; without it, kickers"
              + " get a usual scatter")
  private Path commands;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "seed of the diagnosis and of the twin's recordings (default: ${DEFAULT-VALUE})",
      defaultValue = "20260101")
  private long seed;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "DIR",
      description =
          "writes twin.json, twin_check.json, twin.html and the twin's recordings,"
              + " NAME.twin.log.gz, to this directory")
  private Path out;

  @Override
  public Integer call() throws IOException {
    OutputPlaces.check(out, null);
    List<CommandFile.Command> told = commands == null ? List.of() : CommandFile.read(commands);
    TwinOutcome outcome;
    try (WorkProgress progress = new WorkProgress(Heartbeat.of(spec))) {
      outcome =
          new TwinSession(FitSettings.defaults().withSeed(seed), logOptions.opener())
              .run(logs, told, out, progress);
    }
    new TwinText(spec.commandLine().getOut()).print(outcome, out);
    return 0;
  }
}
