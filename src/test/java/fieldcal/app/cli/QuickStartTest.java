package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The command line that looks at one command alone answers as the one that knows them all. */
class QuickStartTest {
  private record Answer(int status, String out, String err) {}

  private static Answer answer(CommandLine commands, String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    int status = commands.execute(args);
    return new Answer(status, out.toString(), err.toString());
  }

  private static void assertSame(String... args) {
    assertThat(answer(Main.commandLineFor(args), args)).isEqualTo(answer(Main.commandLine(), args));
  }

  static Stream<String> commands() {
    return Main.commandLine().getSubcommands().keySet().stream();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "-h",
        "--help",
        "-V",
        "--version",
        "--hlep",
        "-h -V",
        "--help info",
        "calibrat x.log",
        "info info"
      })
  void whatIsAskedOfTheProgram(String line) {
    assertSame(line.isEmpty() ? new String[0] : line.split(" "));
  }

  @ParameterizedTest
  @MethodSource("commands")
  void whatIsAskedOfACommand(String command) {
    assertSame(command, "--help");
    assertSame(command, "--no-such-option");
  }

  @Test
  void oneCommandIsLookedAt() {
    assertThat(Main.commandLineFor("info", "x.log").getSubcommands()).containsOnlyKeys("info");
    assertThat(Main.commandLineFor("--help").getSubcommands().get("info").getCommandSpec().args())
        .as("described alone")
        .isEmpty();
  }
}
