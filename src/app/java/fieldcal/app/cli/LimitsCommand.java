package fieldcal.app.cli;

import fieldcal.app.limits.LimitsOutcome;
import fieldcal.app.limits.LimitsSession;
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

/** {@code fieldcal limits}: how fast the robots of both teams move. */
@Command(
    name = "limits",
    mixinStandardHelpOptions = true,
    description =
        "Measures velocity, acceleration and braking limits of both teams from the raw detections"
            + " of matches, and shows where one limit for all speeds and directions is wrong.")
final class LimitsCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "LOG",
      description = "SSL game logs of the same two teams, .log or .log.gz; read in parallel")
  private List<Path> logs;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "writes limits.html and limits.json to this directory")
  private Path out;

  @Option(names = "--json", paramLabel = "FILE", description = "writes limits.json to this file")
  private Path json;

  @Override
  public Integer call() throws IOException {
    OutputPlaces.check(out, json);
    LimitsSession session =
        new LimitsSession(Runtime.getRuntime().availableProcessors(), logOptions.opener());
    LimitsOutcome outcome;
    try (Heartbeat heartbeat = Heartbeat.of(spec);
        TerminalProgress bar = TerminalProgress.ofBytes("reading", heartbeat)) {
      outcome = session.run(logs, bar::at);
    }
    if (out != null) {
      LimitsSession.writeAll(outcome, out);
    }
    if (json != null) {
      LimitsSession.writeJson(outcome, json);
    }
    new LimitsText(spec.commandLine().getOut()).print(outcome, out);
    return 0;
  }
}
