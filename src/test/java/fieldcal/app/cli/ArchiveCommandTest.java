package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveProgress;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The command where Spark is not: the tests of the engine are in src/archiveTest. */
class ArchiveCommandTest {
  @TempDir private Path folder;

  private int run(StringWriter err, String... arguments) {
    CommandLine program = Main.commandLine();
    program.setErr(new PrintWriter(err, true));
    return program.execute(arguments);
  }

  @Test
  void saysInOneLineWhatIsMissing() {
    StringWriter err = new StringWriter();
    Path out = folder.resolve("out");
    assertThat(run(err, "archive", folder.toString(), "--out", out.toString())).isEqualTo(1);
    assertThat(err.toString().strip())
        .startsWith("fieldcal: archive: needs Apache Spark")
        .hasLineCount(1);
    assertThat(out).doesNotExist();
  }

  @Test
  void outMustBeADirectory() throws Exception {
    StringWriter err = new StringWriter();
    Path file = Files.createFile(folder.resolve("file"));
    assertThat(run(err, "archive", folder.toString(), "--out", file.toString())).isEqualTo(1);
    assertThat(err.toString()).contains("file: is a file; --out needs a directory");
    assertThat(run(err, "archive", folder.toString())).isEqualTo(2);
  }

  @Test
  void whatIsInTheArchiveIsCountedInWords() {
    assertThat(ArchiveCommand.summary(new ArchiveOutcome(1, 0, 0, 90, 1, List.of())))
        .isEqualTo("1 log, 1.5 minutes, 1 kick");
    assertThat(ArchiveCommand.summary(new ArchiveOutcome(4, 1, 2, 600, 30, List.of())))
        .isEqualTo(
            "4 logs, 10.0 minutes, 30 kicks; 1 was in the archive already; 2 could not be read,"
                + " see the table problems");
  }

  @Test
  void progressHasThroughputAndTheTimeLeft() {
    assertThat(ArchiveDisplay.words(new ArchiveProgress(10, 0, 1000, 0, 0), 5)).isEmpty();
    assertThat(ArchiveDisplay.words(new ArchiveProgress(10, 4, 1000, 250, 1200), 10))
        .isEqualTo(", 2.0 minutes of play per second, 0:00:30 left");
  }
}
