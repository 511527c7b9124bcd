package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.CommandFile;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.DatagramSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class PlayCommandTest {
  @TempDir Path directory;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String line) {
    CommandLine command = Main.commandLine();
    command.setOut(new PrintWriter(out)).setErr(new PrintWriter(err));
    return command.execute(line.replace("DIR", directory.toString()).split(" "));
  }

  private JsonNode json(String name) throws IOException {
    return new ObjectMapper().readTree(directory.resolve(name).toFile());
  }

  @Test
  void aSessionEndsWithACalibratedModelBesideTheTruth() throws Exception {
    assertThat(run("play --sim --kind flat --kicks 4 --seed 2 --out DIR")).isZero();
    assertThat(out.toString())
        .contains("4 good kicks of 4 made")
        .contains("Flat model: 4 of 4 kicks used")
        .contains("Against the truth")
        .contains("Kick strength");
    JsonNode play = json("play.json");
    assertThat(play.get("complete").asBoolean()).isTrue();
    assertThat(play.get("kicks")).hasSize(4);
    assertThat(play.get("kick_strength").get(0).get("gain").asDouble()).isBetween(0.9, 1.1);
    assertThat(json("session-flat.truth.json").get("ideal_model").get("k_switch").asDouble())
        .isEqualTo(0.65);
    double kSwitch = json("calibration.json").get("flat").get("k_switch").get("mean").asDouble();
    assertThat(kSwitch).isBetween(0.645, 0.655);
    assertThatTheVerdictIsThatOf(json("calibration.json"));

    // A second session is calibrated together with the first.
    assertThat(run("play --sim --kind chip --kicks 3 --seed 2 --out DIR")).isZero();
    assertThat(json("calibration.json").get("sources")).hasSize(2);
    assertThat(json("calibration.json").get("chip").get("damping_z").get("mean").asDouble())
        .isBetween(0.515, 0.525);
  }

  @Test
  void aPlayOfOneChipTellsOfOneChip() {
    assertThat(run("play --sim --kind chip --kicks 1 --seed 2")).isZero();
    assertThat(out.toString())
        .contains("Chip model: 1 of 1 kick used")
        .doesNotContain("Flat model")
        .doesNotContainPattern("\\b1 kicks\\b");
  }

  /** The play ends with the same verdict and the same reasons as its files have. */
  private void assertThatTheVerdictIsThatOf(JsonNode calibration) {
    JsonNode verdict = calibration.path("verdict");
    assertThat(verdict.path("decision").asText()).isEqualTo("record_more");
    String words = out.toString().replaceAll("\\s+", " ");
    assertThat(words).contains(verdict.path("headline").asText());
    assertThat(verdict.path("because")).isNotEmpty();
    for (String list : new String[] {"because", "notes"}) {
      verdict.path(list).forEach(reason -> assertThat(words).contains(reason.asText()));
    }
  }

  /** One kick cannot show what differs from kick to kick: at least six are made, by both robots. */
  @Test
  void whoAsksForAPrecisionIsToldThatItWasReached() throws IOException {
    assertThat(run("play --sim --kind flat --kicks 30 --adaptive --precision 5 --seed 2 --out DIR"))
        .isZero();
    assertThat(out.toString())
        .containsPattern(
            "Finished after \\d+ s of field time: \\d+ good kicks of \\d+ made\\.\\REvery parameter"
                + " is known to 5 %, as asked\\. The rest of the 30 kicks is not needed\\.");
    assertThat(json("play.json").get("kicks")).hasSizeBetween(6, 29);
    assertThat(Set.copyOf(json("play.json").get("kicks").findValuesAsText("robot"))).hasSize(2);
  }

  /** Kickers that strike twice, as in grSim: their strength scatters, the ball does not. */
  @Test
  void unevenKickersDoNotDisturbTheModel() throws Exception {
    assertThat(
            run(
                "play --sim --kind flat --kicks 8 --seed 2 --robots-like uneven-kicker"
                    + " --vision-like noiseless --out DIR"))
        .isZero();
    double kSwitch = json("calibration.json").get("flat").get("k_switch").get("mean").asDouble();
    assertThat(kSwitch).isBetween(0.645, 0.655);
    assertThat(json("play.json").get("kicks")).hasSizeLessThan(12);
  }

  /** Somebody who exports the folder's model afterwards gets that of the carpet. */
  @Test
  void aRehearsalLeavesTheResultsOfARealFieldAlone() throws Exception {
    Path real =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", "grsim-flat.log.gz");
    Files.copy(real, directory.resolve("real.log.gz"));
    assertThat(run("calibrate DIR --out DIR")).isZero();
    byte[] model = Files.readAllBytes(directory.resolve("geometry_models.pb"));
    JsonNode before = json("calibration.json");
    JsonNode decisions = json("selection.json");

    assertThat(run("play --sim --kind flat --kicks 2 --seed 2 --out DIR")).isZero();
    assertThat(out.toString()).contains(directory.resolve("rehearsal/report.html").toString());
    assertThat(directory.resolve("geometry_models.pb")).hasBinaryContent(model);
    assertThat(json("calibration.json")).isEqualTo(before);
    assertThat(json("selection.json")).isEqualTo(decisions);
    assertThat(json("rehearsal/calibration.json").get("kicks")).hasSize(2);
    assertThat(json("rehearsal/play.json").get("kicks")).hasSize(2);
    assertThat(directory.resolve("session-flat.log")).exists();
  }

  @Test
  void whatStopsItIsSaidInOneLine() {
    int status =
        run("play --sim --kind flat --kicks 2 --robots yellow0,blue1 --patience 0.2 --troubles 60");
    assertThat(status).isEqualTo(1);
    assertThat(err.toString().lines()).hasSize(1);
    assertThat(err.toString())
        .startsWith("fieldcal: The play stopped after ")
        .contains(" of 2 good kicks: ");
  }

  @Test
  void whoPlaysOnAnotherFieldIsToldWhichSessionIsLeftOut() {
    assertThat(run("play --sim --kind flat --kicks 1 --seed 2 --out DIR")).isZero();
    assertThat(out.toString()).doesNotContain("left out");
    assertThat(run("play --sim --kind flat --kicks 1 --seed 3 --out DIR")).isZero();
    assertThat(out.toString()).contains("left out: " + directory.resolve("session-flat.log"));
  }

  @Test
  void whoWaitsForVisionIsToldSo() throws IOException {
    int port;
    try (DatagramSocket free = new DatagramSocket()) {
      port = free.getLocalPort();
    }
    String line = "play --ssl-sim 127.0.0.1 --kind flat --kicks 1 --patience 2 --vision 127.0.0.1:";
    assertThat(run(line + port)).isEqualTo(1);
    assertThat(out.toString()).contains("waiting for the geometry of the field from vision");
    assertThat(err.toString()).contains("vision sent no geometry for 5 s. ").doesNotContain("?.");
  }

  @Test
  void aLineOffTheFieldIsRefused() {
    assertThat(run("play --sim --kind chip --kicks 3 --across 40 --out DIR")).isEqualTo(1);
    assertThat(err.toString().lines()).hasSize(1);
    assertThat(err.toString()).contains("leaves the field");
    // No empty recording is left in the way of the next session.
    assertThat(directory).isEmptyDirectory();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "play --kind flat --kicks 3",
        "play --sim --kicks 3",
        "play --sim --kind curved --kicks 3",
        "play --sim --kind flat --kicks 0",
        "play --sim --kind flat --kicks 3 --robots yellow1",
        "play --sim --kind flat --kicks 3 --robots yellow1,yellow1",
        "play --sim --kind flat --kicks 3 --robots red1,blue2",
        "play --sim --kind flat --kicks 3 --half left",
        "play --sim --kind flat --kicks 3 --speed-min 9 --speed-max 4",
        "play --sim --kind flat --kicks 3 --preset moon",
        "play --sim --kind flat --kicks 3 --referee 224.5.23.1:10003",
        "play --sim --kind flat --kicks 3 --port 10300",
        "play --ssl-sim 127.0.0.1 --kind flat --kicks 3 --preset lab",
        "play --robots-at 127.0.0.1:10400 --kind flat --kicks 3 --robots-like sluggish",
        "play --robots-at 127.0.0.1:10400 --kind flat --kicks 3 --troubles 2",
        "play --robots-at 127.0.0.1:10400 --kind flat --kicks 3 --port 10300",
        "play --robots-at 127.0.0.1:10400 --kind flat --kicks 3 --robots yellow1,yellow1",
        "play --sim --kind flat --kicks 3 --receiver-distance 0.05",
        "play --sim --kind flat --kicks 3 --elevation 45",
        "play --sim --kind flat --kicks 3 --across 2",
        "play --sim --kind chip --kicks 3 --half positive",
        "play --sim --kind flat --kicks 3 --drive-speed 1e9",
        "play --sim --kind chip --kicks 3 --elevation 0",
        "play --sim --kind flat --kicks 3 --effect gravity:g=2"
      })
  void badUsageIsStatusTwo(String line) {
    assertThat(run(line)).as(err.toString()).isEqualTo(2);
    assertThat(err.toString()).contains("fieldcal play --help");
  }

  @Test
  void whatWasFinishedSurvivesAKill() throws Exception {
    Process play = startedInAProcessOfItsOwn();
    Path commands = directory.resolve("session-flat.commands.csv");
    try {
      awaitKicks(play, commands, 3);
    } finally {
      play.destroyForcibly();
      play.waitFor(10, TimeUnit.SECONDS);
    }

    // The last line may have been cut in the middle, as the recording may.
    List<CommandFile.Command> told = CommandFile.read(commands);
    assertThat(told).hasSizeGreaterThanOrEqualTo(3);
    Path log = directory.resolve("session-flat.log");
    Path json = directory.resolve("after.json");
    assertThat(run("calibrate " + log + " --commands " + commands + " --json " + json))
        .as(err.toString())
        .isZero();
    List<Double> times = new ArrayList<>();
    JsonNode found = json("after.json").get("kicks");
    found.forEach(kick -> times.add(kick.get("t").asDouble()));
    assertThat(told)
        .allSatisfy(t -> assertThat(times).anyMatch(k -> Math.abs(k - t.unixTime()) < 0.3));
    assertThat(found).filteredOn(k -> k.get("selected").asBoolean()).isNotEmpty();
  }

  @Test
  void whoEndsItIsToldThatTheRobotsStandAndWhatIsKept() throws Exception {
    Process play = startedInAProcessOfItsOwn();
    try {
      awaitKicks(play, directory.resolve("session-flat.commands.csv"), 2);
      play.destroy(); // as Ctrl-C does
      assertThat(play.waitFor(10, TimeUnit.SECONDS)).isTrue();
    } finally {
      play.destroyForcibly();
    }
    List<String> said = Files.readAllLines(directory.resolve("output.txt"));
    String last = said.get(said.size() - 1);
    assertThat(last)
        .matches(
            "fieldcal: The play was interrupted. Both robots stand still. \\d+ kicks were made. To"
                + " calibrate: .*");
    String command = last.substring(last.indexOf("fieldcal calibrate ") + 9);
    assertThat(run(command.replace("session-*.log", "session-flat.log"))).as(command).isZero();
    assertThat(json("calibration.json").get("kicks").size()).isGreaterThanOrEqualTo(2);
  }

  private Process startedInAProcessOfItsOwn() throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            "fieldcal.app.cli.Main",
            "play",
            "--sim",
            "--kind",
            "flat",
            "--kicks",
            "200",
            "--pace",
            "25",
            "--out",
            directory.toString())
        .redirectErrorStream(true)
        .redirectOutput(directory.resolve("output.txt").toFile())
        .start();
  }

  private void awaitKicks(Process play, Path commands, int kicks) throws Exception {
    for (int i = 0; i < 2400 && lines(commands) < kicks + 1; i++) {
      assertThat(play.isAlive()).as(Files.readString(directory.resolve("output.txt"))).isTrue();
      Thread.sleep(50);
    }
  }

  private static long lines(Path file) throws IOException {
    return Files.exists(file) ? Files.readAllLines(file).size() : 0;
  }
}
