package fieldcal.app.cli;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.compare.CompareSession;
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

/** {@code fieldcal compare}: what a simulator gets wrong of a field. */
@Command(
    name = "compare",
    mixinStandardHelpOptions = true,
    description =
        "Compares recordings of a field with recordings of a simulator: what its ball, cameras,"
            + " kickers and robots do differently, and what that costs an AI that was tuned on it.")
final class CompareCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "REAL",
      description = "SSL game logs of the field, .log or .log.gz")
  private List<Path> real;

  @Option(
      names = "--with",
      required = true,
      arity = "1..*",
      paramLabel = "SIM",
      description = "SSL game logs of the simulator")
  private List<Path> sim;

  @Option(
      names = "--commands",
      paramLabel = "CSV",
      description =
          "CSV file of the field robots' commands; kickers are compared only if the commands of"
              + " both sides are known")
  private Path commands;

  @Option(
      names = "--with-commands",
      paramLabel = "CSV",
      description = "CSV file of the commands of the simulator's robots")
  private Path simCommands;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "seed of both diagnoses (default: ${DEFAULT-VALUE})",
      defaultValue = "20260101")
  private long seed;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "writes compare.html and compare.json to this directory")
  private Path out;

  @Option(names = "--json", paramLabel = "FILE", description = "writes compare.json to this file")
  private Path json;

  @Override
  public Integer call() throws IOException {
    OutputPlaces.check(out, json);
    List<CommandFile.Command> told = commands == null ? List.of() : CommandFile.read(commands);
    List<CommandFile.Command> simTold =
        simCommands == null ? List.of() : CommandFile.read(simCommands);
    CompareSession.Outcome outcome;
    Heartbeat heartbeat = Heartbeat.of(spec);
    try (WorkProgress first = new WorkProgress(heartbeat);
        WorkProgress second = new WorkProgress(heartbeat)) {
      outcome =
          new CompareSession(FitSettings.defaults().withSeed(seed), logOptions.opener())
              .run(real, told, sim, simTold, List.of(first, second));
    }
    if (out != null) {
      CompareSession.writeAll(outcome, out);
    }
    if (json != null) {
      CompareSession.writeJson(outcome, json);
    }
    new CompareText(spec.commandLine().getOut()).print(outcome, out);
    return 0;
  }
}
