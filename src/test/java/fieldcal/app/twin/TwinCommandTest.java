package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.simulation.KickBehaviour.SpinTable;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.TabulatedError;
import fieldcal.simulation.physics.Table;
import fieldcal.simulation.physics.TabulatedLaw;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** {@code twin} as an operator runs it, and its file in other commands. */
class TwinCommandTest {
  @TempDir private static Path folder;

  private static Answer answer;

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

  /** A field with a cause, whose twin all tests look at. */
  @BeforeAll
  static void makeATwin() {
    Path log = folder.resolve("field.log.gz");
    Answer made =
        run(
            "simulate",
            "--scenario=flat",
            "--kicks=10",
            "--seed=6",
            "--cameras=2",
            "--effect=camera_offset:x_mm=20,camera=1",
            "--out=" + log);
    assertThat(made.exit()).as(made.err()).isZero();
    answer =
        run(
            "twin",
            log.toString(),
            "--commands=" + folder.resolve("field.commands.csv"),
            "--out=" + folder.resolve("out"));
  }

  private static Path twin() {
    return folder.resolve("out").resolve("twin.json");
  }

  private static JsonNode json(Path file) throws IOException {
    return new ObjectMapper().readTree(file.toFile());
  }

  @Test
  void theTwinHasTheFieldsCauseAndBehavesLikeIt() throws IOException {
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out())
        .contains("10 of 10 kicks were found again")
        .contains("- offset of camera 0 (x −20");
    JsonNode twin = json(twin());
    assertThat(twin.get("schema").asText()).isEqualTo("fieldcal.twin/1");
    assertThat(twin.get("cameras")).hasSize(2);
    assertThat(twin.get("cameras").get(0).get("ball_noise").asDouble()).isBetween(0.0016, 0.0024);
    assertThat(twin.get("kickers").get("speed_scatter").asDouble()).isBetween(0.005, 0.03);
    assertThat(twin.get("causes").get(0).get("effect").asText()).isEqualTo("camera_offset");
    JsonNode check = json(folder.resolve("out/twin_check.json"));
    assertThat(check.get("schema").asText()).isEqualTo("fieldcal.twin_check/1");
    assertThat(check.get("share_within_bounds").asDouble()).isGreaterThanOrEqualTo(0.95);
    assertThat(check.get("statistics").size()).isGreaterThan(15);
    check
        .get("parameters")
        .forEach(p -> assertThat(p.get("sigmas").asDouble()).as(p.toString()).isLessThan(3));
    try (GameLogReader reader = GameLogReader.open(folder.resolve("out/field.twin.log.gz"))) {
      assertThat(reader.next()).isTrue();
      assertThat(RecordingOrigin.isSimulationMark(reader)).as("says what it is").isTrue();
    }
    assertThat(Files.readString(folder.resolve("out/twin.html"))).contains("\"statistics\":");
  }

  /** Every other kick of a field with spin has another spin; the twin's kicks have them again. */
  @Test
  void aFieldWhoseKicksHaveSpinHasATwin() throws IOException {
    Path log = folder.resolve("spun.log.gz");
    Answer made =
        run(
            "simulate",
            "--scenario=flat",
            "--kicks=10",
            "--seed=7",
            "--cameras=2",
            "--physics=contact",
            "--effect=kick_spin:fraction=-0.4,scatter=0.1",
            "--out=" + log);
    assertThat(made.exit()).as(made.err()).isZero();
    Answer spun = run("twin", log.toString(), "--out=" + folder.resolve("spun"));
    assertThat(spun.exit()).as(spun.err()).isZero();
    assertThat(spun.out()).contains("10 of 10 kicks were found again").contains("- backspin");
    JsonNode kickers = json(folder.resolve("spun/twin.json")).get("kickers");
    assertThat(kickers.get("roll_spin").asDouble()).isBetween(-0.6, -0.2);
  }

  @Test
  void simulateLikeItGivesTheSameBytesTwice() throws IOException {
    List<byte[]> logs = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Path log = folder.resolve("like" + i + ".log");
      Answer made =
          run(
              "simulate",
              "--like=" + twin(),
              "--scenario=flat",
              "--kicks=1",
              "--seed=9",
              "--out=" + log);
      assertThat(made.exit()).as(made.err()).isZero();
      assertThat(made.out()).contains("of 2 cameras").contains("effect camera_offset");
      logs.add(Files.readAllBytes(log));
    }
    assertThat(logs.get(0)).isEqualTo(logs.get(1));
  }

  @Test
  void playOnIt() {
    Answer played =
        run("play", "--sim", "--like=" + twin(), "--kind=flat", "--kicks=1", "--seed=3");
    assertThat(played.exit()).as(played.err()).isZero();
  }

  @Test
  void whatIsReadIsWhatWasWritten() throws IOException {
    Twin read = TwinFile.read(twin());
    SimulationSettings s = read.settings();
    Table curve = Table.curve(new double[] {0, 1}, new double[] {0.1, -0.1}, 0);
    Table round = Table.curve(new double[] {-3, 3}, new double[] {0.2, 0.1}, 6.283);
    Table surface =
        Table.surface(new double[] {0, 1}, new double[] {0, 2}, new double[] {0, 1, 4, 5});
    TabulatedError shift =
        new TabulatedError(
            TabulatedError.Quantity.SHIFT,
            TabulatedError.Variable.IMAGE_POSITION,
            List.of(surface, surface));
    InstalledCamera first = s.installed().get(0);
    List<InstalledCamera> cameras = new ArrayList<>(s.installed());
    cameras.set(0, first.withErrors(first.errors().withTable(shift)));
    SimulationSettings more =
        s.withPhysics(
                s.physics()
                    .withExtra(
                        new TabulatedLaw(
                            TabulatedLaw.Quantity.ACCELERATION_ALONG,
                            TabulatedLaw.Variable.SPEED,
                            curve)))
            .withKickBehaviour(
                s.kickBehaviour().withSpinTables(List.of(new SpinTable(true, round))))
            .withInstalled(cameras);
    Twin rich = new Twin(read.sources(), more, List.of("a note"));
    Path file = folder.resolve("rich.json");
    TwinFile.write(rich, file);
    Twin again = TwinFile.read(file);
    assertThat(again.settings().installed()).isEqualTo(cameras);
    assertThat(again.settings().physics().extras()).isEqualTo(more.physics().extras());
    assertThat(again.settings().effects()).hasToString(more.effects().toString());
    assertThat(again.settings().scenario()).isEqualTo(more.scenario());
    assertThat(TwinFile.document(again)).hasToString(json(file).toString());
    assertThat(again.settings().kickBehaviour().spinTables())
        .isEqualTo(more.kickBehaviour().spinTables());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          "schema" : "fieldcal.twin/1" | "schema" : "other/9"       | field schema
          "k_switch"                   | "k_swich"                  | field ball.
          "exposure" : "free"          | "exposure" : "sometimes"   | field vision.exposure
          "noise_growth" : "image"     | "noise_growth" : 3         | field cameras[0].noise_growth
          "camera_offset"              | "camera_offfset"           | unknown effect
          """)
  void aDamagedFileIsOneLineWithItsField(String from, String to, String told) throws IOException {
    String text = Files.readString(twin());
    Path file = folder.resolve("damaged.json");
    Files.writeString(file, text.replace(from, to));
    Answer wrong =
        run(
            "simulate",
            "--like=" + file,
            "--scenario=flat",
            "--kicks=1",
            "--out=" + folder.resolve("x.log"));
    assertThat(wrong.exit()).as(wrong.err()).isEqualTo(1);
    assertThat(wrong.err().lines()).hasSize(1);
    assertThat(wrong.err()).startsWith("fieldcal: " + file).contains(told);
  }

  @Test
  void wrongUsageIsTwoAndBadInputOne() throws IOException {
    assertThat(run("twin").exit()).isEqualTo(2);
    assertThat(run("twin", "x.log").exit()).isEqualTo(2);
    Answer missing = run("twin", "x.log", "--out=" + folder.resolve("o"));
    assertThat(missing.exit()).isEqualTo(1);
    assertThat(missing.err().lines()).hasSize(1);
    Answer both =
        run("simulate", "--like=" + twin(), "--cameras=2", "--scenario=flat", "--out=x.log");
    assertThat(both.exit()).isEqualTo(2);
    assertThat(both.err()).contains("--cameras contradicts --like");
    Answer noTwin =
        run("play", "--sim", "--like=" + folder.resolve("none.json"), "--kind=flat", "--kicks=1");
    assertThat(noTwin.exit()).isEqualTo(1);
    assertThat(noTwin.err()).contains("none.json: no such file");
  }
}
