package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.live.BallParameter;
import fieldcal.live.BallSamples;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class MonitorCommandTest {
  @TempDir private static Path folder;
  private static Path log;

  private record Outcome(int status, String out, String err) {}

  @BeforeAll
  static void simulate() {
    log = folder.resolve("match.log.gz");
    // Of four cameras, one is 22 mm off from each of the others.
    Outcome done =
        run(
            "simulate",
            "--scenario=match",
            "--minutes=1",
            "--seed=5",
            "--effect=camera_offset:x_mm=16.5,camera=1",
            "--out=" + log);
    assertThat(done.status()).as(done.err()).isZero();
  }

  private static Outcome run(String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine program = Main.commandLine();
    program.setOut(new PrintWriter(out, true));
    program.setErr(new PrintWriter(err, true));
    return new Outcome(program.execute(arguments), out.toString(), err.toString());
  }

  @Test
  void aRecordingIsWatchedInPlainLines() {
    Outcome done = run("monitor", "--log", "" + log);
    assertThat(done.status()).as(done.err()).isZero();
    assertThat(done.out())
        .doesNotContain("\u001b")
        .startsWith("watching " + log)
        .containsOnlyOnce("referee is heard: ")
        .contains("referee: first half, normal start")
        .containsPattern("#\\d+ +flat +\\d\\.\\d m/s (yellow|blue) \\d+")
        .contains("BALL     ")
        .containsPattern("rolling deceleration, m/s² +−0\\.\\d\\d\\d")
        .contains("ROBOTS")
        .doesNotContain("by –")
        .contains("CAMERAS")
        .contains("100 % read");
  }

  @Test
  void camerasHaveANoiseAndThoseThatAreApartAreMarked() {
    String out = run("monitor", "--log", "" + log).out();
    String row = " +\\d\\d\\.\\d Hz +[1-4]\\.\\d\\d mm +−?\\d+\\.\\d, −?\\d+\\.\\d mm +\\d+ .*";
    assertThat(out)
        .containsPattern("\n +1" + row + " +2[0-4] mm apart from camera [023]\n")
        .containsPattern("\n +0" + row + " +2[0-4] mm apart from camera 1\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "30", "1000"})
  void kicksArePrintedInTheirOrderHoweverFastTheReplayIs(String speed) {
    String out = speed.equals("0") ? watched() : watched("--speed", speed);
    List<Integer> numbers = new ArrayList<>();
    List<String> times = new ArrayList<>();
    Matcher kick = Pattern.compile("(?m)^([\\d:]{8})  #(\\d+) ").matcher(out);
    while (kick.find()) {
      times.add(kick.group(1));
      numbers.add(Integer.parseInt(kick.group(2)));
    }
    assertThat(numbers).hasSizeGreaterThan(5).isSorted().doesNotHaveDuplicates();
    assertThat(times).isSorted();
  }

  private static String watched(String... options) {
    List<String> all = new ArrayList<>(List.of("monitor", "--log", "" + log));
    all.addAll(List.of(options));
    Outcome done = run(all.toArray(String[]::new));
    assertThat(done.status()).as(done.err()).isZero();
    return done.out();
  }

  /** The published sliding deceleration is a third too small; a minute has fewer than 31 kicks that show it. */
  @Test
  void aParameterThatIsFarOffIsWarnedAboutWithinTheFirstMinuteAndTheWarningSaysWhatToDo()
      throws IOException {
    Path models = folder.resolve("models.txt");
    Files.writeString(
        models,
        "straight_two_phase { acc_slide: -2.1 acc_roll: -0.26 k_switch: 0.66 } chip_fixed_loss {"
            + " damping_xy_first_hop: 0.8 damping_xy_other_hops: 0.85 damping_z: 0.47 }");
    assertThat(watched("--models", "" + models))
        .containsPattern(
            "WARNING +sliding deceleration \\(acc_slide\\) is −\\d\\.\\d+ m/s², \\d\\d % more than"
                + " the published −2\\.100 m/s² \\(median of \\d kicks\\)\\. Let the AI use"
                + " −\\d\\.\\d+ m/s² until the ball is calibrated again on this carpet\\.")
        .containsPattern("sliding deceleration, m/s² .* too few yet +\\d+/31");
  }

  @Test
  void everyLineOfTheChangesIsJson() throws IOException {
    Path changes = folder.resolve("new/changes.jsonl");
    assertThat(run("monitor", "--log", "" + log, "--json", "" + changes).status()).isZero();
    List<String> events = new ArrayList<>();
    JsonNode last = null;
    for (String line : Files.readAllLines(changes)) {
      last = new ObjectMapper().readTree(line);
      events.add(last.path("event").asText());
      assertThat(last.has("t")).isTrue();
    }
    assertThat(events)
        .startsWith("start")
        .contains("referee", "kick", "estimate", "limits")
        .endsWith("summary");
    int kicks = (int) events.stream().filter("kick"::equals).count();
    assertThat(last.path("kicks").path("used").asInt() + last.path("kicks").path("unused").asInt())
        .isEqualTo(kicks);
    assertThat(last.path("parameters").path("acc_slide").path("median").asDouble())
        .isBetween(-3.6, -2.6);
    assertThat(last.path("cameras").size()).isPositive();
  }

  @Test
  void matchesArePooledInAStateFile() throws IOException {
    Path state = folder.resolve("state.json");
    Files.deleteIfExists(state);
    assertThat(run("monitor", "--log", "" + log, "--state", "" + state).status()).isZero();
    BallSamples once = StateFile.read(state);
    assertThat(once.of(BallParameter.ACC_SLIDE)).isNotEmpty();
    Path second = folder.resolve("second.log");
    Outcome other =
        run(
            "simulate",
            "--scenario",
            "match",
            "--minutes",
            "1",
            "--seed",
            "6",
            "--out",
            "" + second);
    assertThat(other.status()).isZero();
    assertThat(run("monitor", "--log", "" + second, "--state", "" + state).status()).isZero();
    assertThat(StateFile.read(state).of(BallParameter.ACC_SLIDE))
        .containsAll(once.of(BallParameter.ACC_SLIDE))
        .hasSizeGreaterThan(once.of(BallParameter.ACC_SLIDE).size());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "[]",
        "{\"schema\":",
        "{\"schema\":\"fieldcal.live_state/2\",\"samples\":{}}",
        "{\"schema\":\"fieldcal.live_state/1\",\"samples\":{\"acc_roll\":[{\"t\":1}]}}"
      })
  void aBrokenStateIsOneLineThatNamesTheFileAndStaysAsItIs(String content) throws IOException {
    Path state = folder.resolve("broken.json");
    Files.writeString(state, content);
    Outcome done = run("monitor", "--log", "" + log, "--state", "" + state);
    assertThat(done.status()).isEqualTo(1);
    assertThat(done.err().strip()).hasLineCount(1).contains("" + state);
    assertThat(state).hasContent(content);
  }

  @Test
  void robotsAreComparedWithWhatIsConfigured() throws IOException {
    Path changes = folder.resolve("limits.jsonl");
    Outcome done =
        run("monitor", "--log", "" + log, "--robot-limits", "blue:1,9,9", "--json", "" + changes);
    assertThat(done.status()).as(done.err()).isZero();
    assertThat(done.out())
        .containsPattern("WARNING +velocity of blue is .* than the configured 1.00");
    assertThat(changes).content().contains("\"event\":\"limit_warning\"");
    Outcome wrong = run("monitor", "--log", "" + log, "--robot-limits", "green:1,2,3");
    assertThat(wrong.status()).isEqualTo(2);
    assertThat(wrong.err()).contains("but is 'green:1,2,3'");
    assertThat(run("monitor", "--log", "" + log, "--robot-limits", "blue:1,2").status())
        .isEqualTo(2);
  }

  @Test
  void whatCannotBeIsRefused() {
    assertThat(run("monitor", "--multicast", "224.5.23.2:0").err()).contains("port 0");
    Outcome foreign = run("monitor", "--multicast", "192.0.2.7:10006");
    assertThat(foreign.status()).isEqualTo(1);
    assertThat(foreign.err()).contains("neither a multicast group nor an address of this machine");
    assertThat(run("monitor").status()).isEqualTo(2);
    assertThat(run("monitor", "--log", "" + log, "--speed", "-1").status()).isEqualTo(2);
    assertThat(run("monitor", "--log", "" + log, "--multicast", "224.5.23.2:10006").status())
        .isEqualTo(2);
    Outcome noPlace = run("monitor", "--multicast", "224.5.23.2");
    assertThat(noPlace.status()).isEqualTo(2);
    assertThat(noPlace.err()).contains("'224.5.23.2' is not an address with a port");
    Outcome noInterface = run("monitor", "--multicast", "224.5.23.2:10006", "--interface", "moon0");
    assertThat(noInterface.status()).isEqualTo(2);
    assertThat(noInterface.err()).contains("no network interface 'moon0'");
    Outcome noLog = run("monitor", "--log", "" + folder.resolve("none.log"));
    assertThat(noLog.status()).isEqualTo(1);
    assertThat(noLog.err().strip()).hasLineCount(1).contains("none.log");
  }
}
