package fieldcal.app.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal info LOG}. */
@Command(
    name = "info",
    description =
        "Shows what is in a recording: duration, cameras, rates, noise on the resting ball, gaps,"
            + " geometry, models, referee, problems.",
    mixinStandardHelpOptions = true)
final class InfoCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(paramLabel = "LOG", description = "an SSL game log, .log or .log.gz")
  private Path log;

  @Option(names = "--json", description = "prints JSON instead of text")
  private boolean json;

  InfoCommand() {}

  @Override
  public Integer call() throws IOException {
    RecordingInfo info;
    PrintWriter out = spec.commandLine().getOut();
    try (Heartbeat heartbeat = Heartbeat.of(spec);
        TerminalProgress progress = TerminalProgress.ofBytes("reading", heartbeat)) {
      info = RecordingInfo.of(log, logOptions.opener(), progress);
    }
    if (json) {
      out.println(new InfoJson().of(info));
      out.flush();
    } else {
      new InfoText(out).print(info);
    }
    return 0;
  }
}
