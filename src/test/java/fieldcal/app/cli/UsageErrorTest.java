package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.simulation.EffectParameter;
import fieldcal.simulation.SimulatedEffect;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
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
        .startsWith(
            """
            fieldcal: there is no command 'calibrat'
            Did you mean 'calibrate'?
            """)
        .contains("fieldcal --help");
  }

  @Test
  void aMisspeltOptionIsGuessed() {
    assertThat(run("calibrate", "--kinds=flat", "x.log")).isEqualTo(2);
    assertThat(err.toString())
        .startsWith(
            """
            fieldcal: there is no option '--kinds=flat'
            Did you mean '--kind'?
            """);
  }

  @Test
  void oneOfTwoOptionsIsAskedFor() {
    assertThat(run("monitor")).isEqualTo(2);
    assertThat(err.toString()).startsWith("fieldcal: give --log LOG or --multicast ADDR:PORT\n");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "calibrate | LOG is missing",
        "record | --out FILE is missing",
        "twin | --out DIR and LOG are missing",
        "play | --kind flat|chip and --kicks N are missing",
        "simulate --scenario flat | --out FILE is missing",
        "simulate --serve --out x.log | --serve writes no recording: leave out --out",
        "simulate --serve --scenario flat | --serve plays no scenario: leave out --scenario",
        "record --out | --out needs a value: FILE",
        "play --sim --kind flat --kicks 3 --kicks 4 | --kicks is given more than once",
        "play --sim --kind flat --kicks 3 --pace 0 | --pace must be a positive number, but is 0",
        "play --sim --kind chip --kicks 3 --elevation 95 | --elevation must be 10 to 80°, but is"
            + " 95",
        "play --sim --kind flat --kicks 3 --troubles -1 | --troubles must be 0 to 100, but is -1",
        "play --sim --kind flat --kicks 3 --patience -1 | --patience must be a positive number, but"
            + " is -1",
        "console . --port 99999 | --port must be 0 to 65535, but is 99999",
        "info a.log b.log | one argument too many: 'b.log'",
        "calibrate x.log --seed x | --seed: 'x' is not a whole number",
        "calibrate x.log --nothing | there is no option '--nothing'",
        "monitor --log a.log --multicast 224.5.23.2:10006 | give --log LOG or --multicast"
            + " ADDR:PORT, not both",
        "play --sim --kind flat --kicks 3 --robots yellow1,yellow1 | --robots takes two different"
            + " robots, not yellow 1 twice",
      })
  void whatIsWrongIsSaidInPlainWords(String line) {
    int split = line.indexOf(" | ");
    assertThat(run(line.substring(0, split).split(" "))).isEqualTo(2);
    assertThat(err.toString()).startsWith("fieldcal: " + line.substring(split + 3) + "\n");
  }

  /** Also an option at its usual value: whoever writes it wants something of it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--scenario MATCH --speed-min 3 | --speed-min | --scenario match | --scenario flat, chip or"
            + " mixed",
        "--scenario match --speed-max 3 | --speed-max | --scenario match | --scenario flat, chip or"
            + " mixed",
        "--scenario match --reception 1 | --reception | --scenario match | --scenario flat, chip or"
            + " mixed",
        "--scenario flat --minutes 2 | --minutes | --scenario flat | --scenario match",
        "--scenario mixed --team-size 6 | --team-size | --scenario mixed | --scenario match",
        "--scenario chip --robots yellow1,blue2 | --robots | --scenario chip | --serve",
        "--scenario flat --robots-like sluggish | --robots-like | --scenario flat | --serve",
        "--scenario flat --vision 224.5.23.2:1 | --vision | --scenario flat | --serve",
        "--scenario match --port 10300 | --port | --scenario match | --serve",
        "--scenario flat --loss 0 | --loss | --scenario flat | --serve",
        "--scenario flat --delay-ms 5 | --delay-ms | --scenario flat | --serve",
        "--serve --kicks 3 | --kicks | --serve | --scenario flat, chip, mixed or match",
        "--serve --minutes 3 | --minutes | --serve | --scenario match",
      })
  void anOptionThatChangesNothingIsRefused(String line, String option, String with, String isFor) {
    String out = line.startsWith("--serve") ? "" : " --out x.log";
    assertThat(run(("simulate " + line + out).split(" "))).isEqualTo(2);
    assertThat(err.toString())
        .startsWith(
            "fieldcal: %s changes nothing with %s: it is for %s\n".formatted(option, with, isFor));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "calibrate x.log --seed x | 'x' is not a whole number",
        "simulate --scenario flat --kicks 0 --out x.log | --kicks must be 1 or more, but is 0",
        "play --sim --kind flat --kicks 0 | --kicks must be 1 to 1000, but is 0",
        "play --sim --kind flat --kicks 3 --precision 0 | --precision must be above 0 %",
        "play --sim --kind flat --kicks 3 --precision x | 'x' is not a number",
      })
  void aValueThatCannotBeIsNamed(String line, String words) {
    assertThat(run(line.split(" "))).isEqualTo(2);
    assertThat(err.toString()).contains(words).doesNotContain("Exception");
  }

  /** 192.0.2.1 is of a network that is reserved for documents, so no machine has it. */
  @Test
  void anAddressOfAnotherMachineIsNotABusyPort(@TempDir Path session) {
    assertThat(run("console", session.toString(), "--address=192.0.2.1", "--port=0")).isEqualTo(1);
    assertThat(err.toString())
        .startsWith("fieldcal: 192.0.2.1:0: this machine does not have that address");
  }

  @ParameterizedTest
  @EnumSource(SimulatedEffect.class)
  void theHelpListsEveryEffectWithItsParameters(SimulatedEffect effect) {
    assertThat(run("simulate", "--help")).isZero();
    String names =
        effect.parameters().stream().map(EffectParameter::name).collect(Collectors.joining(","));
    assertThat(out.toString().replaceAll(",\\s+", ",")).contains("  " + effect.id() + ":" + names);
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
