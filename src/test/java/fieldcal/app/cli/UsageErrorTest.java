package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** Bad usage is one error and where help is, not a page of options with the error above it, out of sight. */
class UsageErrorTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    return commands.execute(args);
  }

  static Stream<String> commands() {
    return Main.commandLine().getSubcommands().keySet().stream();
  }

  @ParameterizedTest
  @MethodSource("commands")
  void theErrorStandsAlone(String command) {
    assertThat(run(command, "--no-such-option")).isEqualTo(2);
    List<String> lines = err.toString().lines().toList();
    assertThat(lines.get(0)).startsWith("fieldcal: ");
    assertThat(lines.get(lines.size() - 1))
        .isEqualTo("Try 'fieldcal " + command + " --help' for the options.");
    assertThat(lines).hasSizeLessThanOrEqualTo(3);
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void aMisspeltCommandIsGuessed() {
    assertThat(run("calibrat", "x.log")).isEqualTo(2);
    assertThat(err.toString())
        .startsWith("fieldcal: there is no command 'calibrat'")
        .contains("calibrate")
        .contains("fieldcal --help");
  }

  @Test
  void oneOfTwoOptionsIsAskedFor() {
    assertThat(run("monitor")).isEqualTo(2);
    assertThat(err.toString())
        .startsWith("fieldcal: give one of these: [--log=LOG")
        .contains("--multicast=ADDR:PORT");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "calibrate x.log --seed x | 'x' is not a whole number",
        "simulate --scenario flat --kicks 0 --out x.log | --kicks must be 1 or more, but is 0",
        "play --sim --kind flat --kicks 3 --precision 0 | --precision must be above 0 %",
        "play --sim --kind flat --kicks 3 --precision x | 'x' is not a number",
      })
  void aValueThatCannotBeIsNamed(String line, String words) {
    assertThat(run(line.split(" "))).isEqualTo(2);
    assertThat(err.toString()).contains(words).doesNotContain("Exception");
  }

  @Test
  void noCommandAtAll() {
    assertThat(run()).isEqualTo(2);
    assertThat(err.toString()).startsWith("fieldcal: name a command");
  }

  /** A recording of another name would not be found by any folder's command afterwards. */
  @ParameterizedTest
  @CsvSource({"simulate,--scenario=flat", "record,--seconds=1"})
  void aRecordingNeedsTheNameOfOne(String command, String option) {
    assertThat(run(command, option, "--out=kicks.txt")).isEqualTo(2);
    assertThat(err.toString()).contains("--out must end with .log or .log.gz, but is 'kicks.txt'");
  }
}
