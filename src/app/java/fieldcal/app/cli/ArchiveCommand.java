package fieldcal.app.cli;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveRequest;
import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal archive}: tables of many game logs. */
@Command(
    name = "archive",
    mixinStandardHelpOptions = true,
    description =
        "Turns hundreds of game logs into Parquet tables of kicks, matches, cameras and robots, and"
            + " into an atlas of carpets, cameras and teams. Runs on Apache Spark, on all cores of"
            + " this machine or on a cluster.")
final class ArchiveCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "1..*",
      paramLabel = "PATH",
      description =
          "game logs, and folders that are searched for them (*.log, *.log.gz); a tournament is"
              + " named after the folder that its logs lie in")
  private List<Path> paths;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "DIR",
      description = "writes the tables and archive.html to this directory")
  private Path out;

  @Option(
      names = "--master",
      paramLabel = "URL",
      description =
          "Spark's master, for example spark://HOST:7077 or local[4] (default: all cores of this"
              + " machine)")
  private String master;

  @Option(
      names = "--resume",
      description = "continues the archive in DIR: logs that are in it are not read again")
  private boolean resume;

  @Override
  public Integer call() throws IOException {
    OutputPlaces.checkDirectory("--out", out);
    ArchiveEngine engine =
        ArchiveEngine.find()
            .orElseThrow(
                () ->
                    new InputException(
                        "archive: needs Apache Spark, which is not part of this distribution;"
                            + " ./fieldcal archive in the source tree downloads it on first use"));
    ArchiveOutcome outcome;
    try (ArchiveDisplay display = new ArchiveDisplay(spec)) {
      outcome =
          engine.run(
              new ArchiveRequest(
                  paths, out, Optional.ofNullable(master), resume, logOptions.opener()),
              display);
    }
    print(outcome);
    if (outcome.broken() == outcome.logs()) {
      throw new InputException("none of the logs can be read");
    }
    return 0;
  }

  private void print(ArchiveOutcome outcome) {
    PrintWriter text = spec.commandLine().getOut();
    text.println(summary(outcome));
    outcome.findings().forEach(text::println);
    text.printf("atlas: %s%n", out.resolve("archive.html"));
    text.flush();
  }

  /** How much is in the archive, in one line. */
  static String summary(ArchiveOutcome outcome) {
    StringBuilder line = new StringBuilder();
    line.append(counted(outcome.logs(), "log"))
        .append(String.format(Locale.ROOT, ", %.1f minutes, ", outcome.play() / 60))
        .append(counted(outcome.kicks(), "kick"));
    if (outcome.skipped() > 0) {
      line.append("; ")
          .append(outcome.skipped())
          .append(outcome.skipped() == 1 ? " was" : " were")
          .append(" in the archive already");
    }
    if (outcome.broken() > 0) {
      line.append("; ")
          .append(outcome.broken())
          .append(" could not be read, see the table problems");
    }
    return line.toString();
  }

  private static String counted(long number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }
}
