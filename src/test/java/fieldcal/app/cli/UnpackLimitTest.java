package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** A packed recording that unpacks to far more than recordings do is read by nobody who did not ask for it. */
class UnpackLimitTest {
  /** Beyond the 16 MB up to which the ratio does not matter. */
  private static final int BLANKS = 20;

  private static final int BLANK_BYTES = 1_000_000;

  @TempDir static Path folder;

  private static Path bomb;
  private final StringWriter err = new StringWriter();

  @BeforeAll
  static void packZeros() throws IOException {
    bomb = folder.resolve("bomb.log.gz");
    try (GameLogWriter log = GameLogWriter.create(bomb)) {
      for (int i = 0; i < BLANKS; i++) {
        log.write(1_763_712_345_000_000_000L + i, MessageType.BLANK, new byte[BLANK_BYTES]);
      }
    }
  }

  private int run(List<String> args) {
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(new StringWriter()));
    err.getBuffer().setLength(0);
    commands.setErr(new PrintWriter(err));
    return commands.execute(args.toArray(String[]::new));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "info LOG",
        "calibrate LOG",
        "calibrate FOLDER",
        "diagnose LOG",
        "limits LOG",
        "monitor --log LOG",
        "twin LOG --out FOLDER/twin",
        "compare LOG --with LOG"
      })
  void everyCommandHoldsItAndCanLiftIt(String line) {
    List<String> args =
        List.of(
            line.replace("LOG", bomb.toString()).replace("FOLDER", folder.toString()).split(" "));

    assertThat(run(args)).isEqualTo(1);
    assertThat(err.toString())
        .startsWith("fieldcal: " + bomb + " (byte ")
        .contains("unpacks to more than 100 times its size")
        .contains("--unpack-limit");
    assertThat(err.toString().lines()).hasSize(1);

    List<String> lifted = new ArrayList<>(args);
    lifted.add("--unpack-limit=Infinity");
    run(lifted);
    assertThat(err.toString()).doesNotContain("unpack", "defect");
  }

  @Test
  void theLimitThatWasGivenIsTheOneThatHolds() {
    assertThat(run(List.of("info", bomb.toString(), "--unpack-limit", "120.5"))).isEqualTo(1);
    assertThat(err.toString()).contains("unpacks to more than 120.5 times its size");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.5", "NaN", "-1", "much"})
  void aLimitThatIsNoneIsBadUsage(String limit) {
    assertThat(run(List.of("info", bomb.toString(), "--unpack-limit", limit))).isEqualTo(2);
    assertThat(err.toString()).contains("--unpack-limit").contains(limit);
  }

  @Test
  void whoeverReadsRecordingsHasTheOption() {
    List<String> with =
        Main.commandLine().getSubcommands().entrySet().stream()
            .filter(c -> c.getValue().getCommandSpec().findOption("--unpack-limit") != null)
            .map(Map.Entry::getKey)
            .toList();
    assertThat(with)
        .containsExactlyInAnyOrder(
            "info",
            "calibrate",
            "diagnose",
            "limits",
            "monitor",
            "twin",
            "compare",
            "console",
            "archive");
  }
}
