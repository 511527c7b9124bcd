package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The command as an operator runs it: exit codes, and one line on bad input. */
class DiagnoseCommandTest {
  @TempDir private Path folder;

  private record Answer(int exit, String out, String err) {}

  private static Answer run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    int exit = commands.execute(args);
    return new Answer(exit, out.toString(), err.toString());
  }

  private Path simulated(int kicks) {
    Path log = folder.resolve("flat" + kicks + ".log.gz");
    Answer answer =
        run("simulate", "--scenario=flat", "--kicks=" + kicks, "--seed=4", "--out=" + log);
    assertThat(answer.exit()).as(answer.err()).isZero();
    return log;
  }

  private static void assertOneLine(Answer answer, Object file) {
    assertThat(answer.exit()).as(answer.toString()).isEqualTo(1);
    assertThat(answer.err().lines()).as(answer.err()).hasSize(1);
    assertThat(answer.err()).startsWith("fieldcal: ").contains(file.toString());
    assertThat(answer.err()).doesNotContain("defect").doesNotContain("Exception");
  }

  @Test
  void wrongUsageIsTwo() {
    assertThat(run("diagnose").exit()).isEqualTo(2);
    assertThat(run("diagnose", "x.log", "--max-causes=-1").exit()).isEqualTo(2);
    assertThat(run("diagnose", "x.log", "--max-causes=-1").err()).contains("0 or more");
    assertThat(run("diagnose", "x.log", "--max-causes=two").exit()).isEqualTo(2);
    assertThat(run("diagnose", "x.log", "--colour=red").exit()).isEqualTo(2);
    Answer help = run("diagnose", "--help");
    assertThat(help.exit()).isZero();
    assertThat(help.out()).contains("--commands", "--max-causes", "--out", "--json", "--seed");
  }

  @Test
  void aFileThatIsNoLogIsOneLine() throws IOException {
    Path missing = folder.resolve("missing.log.gz");
    assertOneLine(run("diagnose", missing.toString()), missing);
    Path notes = Files.writeString(folder.resolve("notes.log.gz"), "these are notes, no recording");
    assertOneLine(run("diagnose", notes.toString()), notes);
  }

  @Test
  void badSideFilesAndPlacesAreOneLine() throws IOException {
    Path log = folder.resolve("any.log");
    Path notes = Files.writeString(folder.resolve("notes.txt"), "notes");
    for (String option : List.of("--commands=", "--selection=", "--out=")) {
      assertOneLine(run("diagnose", log.toString(), option + notes), notes);
    }
    assertOneLine(run("diagnose", log.toString(), "--json=" + folder), folder);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void tooFewKicksAreOneLineThatSaysHowMany(int kicks) {
    Path log = simulated(kicks);
    Answer answer = run("diagnose", log.toString(), "--out=" + folder.resolve("out"));
    assertOneLine(answer, log);
    assertThat(answer.err()).contains(kicks + " kick").contains("needs at least");
    assertThat(folder.resolve("out")).doesNotExist();
  }

  @Test
  void noKickAtAllIsOneLine() throws IOException {
    Path log = simulated(1);
    // The head of the recording: frames, and no kick yet.
    byte[] all = Files.readAllBytes(log);
    Path head = Files.write(folder.resolve("head.log.gz"), java.util.Arrays.copyOf(all, 20000));
    Answer answer = run("diagnose", head.toString());
    assertOneLine(answer, head);
    assertThat(answer.err()).contains("no kick found");
  }
}
