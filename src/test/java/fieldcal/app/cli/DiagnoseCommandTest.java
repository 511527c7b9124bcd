package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.effect.ExtendedModel;
import fieldcal.vision.BallDetection;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionPacket;
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

  private static Path testData(String name) {
    return Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", name);
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

  /** What it would find is how the fields differ. */
  @Test
  void kicksOfDifferentFieldsAreNotDiagnosedTogether() {
    Path world = testData("world-null-flat.log.gz");
    Path elsewhere = testData("erforce-flat.log.gz");
    Path out = folder.resolve("mixed");
    Answer answer = run("diagnose", world.toString(), elsewhere.toString(), "--out=" + out);
    assertOneLine(answer, elsewhere.getFileName());
    assertThat(answer.err())
        .contains("The fields differ in size")
        .contains(world.getFileName().toString())
        .contains("Diagnose each field on its own.");
    assertThat(out).doesNotExist();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void aFewKicksGetAnAnswerThatSaysHowLittleTheyShow(int kicks) throws IOException {
    Path out = folder.resolve("out");
    run("calibrate", simulated(kicks).toString(), "--out=" + out);
    Answer answer = run("diagnose", simulated(kicks).toString(), "--out=" + out);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out())
        .contains("These few kicks show nothing wrong")
        .contains("Record at least twelve");
    JsonNode root = json(out.resolve("diagnosis.json"));
    assertThat(root.get("verdict").textValue()).isEqualTo("model_adequate");
    assertThat(out.resolve("diagnosis.html")).isNotEmptyFile();
    // That so few kicks show little is a warning of the calibration, too, and no reason to leave it
    // as it was.
    assertThat(answer.out().replaceAll("\\s+", " ")).contains("now count this diagnosis");
    assertThat(json(out.resolve("calibration.json")).path("verdict"))
        .isEqualTo(root.path("model_verdict"));
  }

  /** One kick shows that the model is wrong, but not what its error depends on. */
  @Test
  void aSingleKickGivesNoAdviceOnItsOwn() {
    Path log = testData("mujoco-rolling-chip.log.gz");
    assertThat(run("diagnose", log.toString()).out().replaceAll("\\s+", " "))
        .contains("a single kick shows no cause")
        .doesNotContain("each quarter of the field", "depending on", "improves the prediction");
  }

  /** The terminal's verdict, like the console's, knows of a diagnosis of the same kicks, and of no other. */
  @Test
  void calibrateCountsADiagnosisOfTheSameKicks() throws IOException {
    Path out = folder.resolve("out");
    String log =
        Path.of(
                System.getProperty("fieldcal.projectDir", "."),
                "test-data",
                "world-flat-air-drag.log.gz")
            .toString();
    String before = run("calibrate", log, "--out=" + out).out();
    assertThat(before).startsWith("Verdict: check first. Run diagnose").doesNotContain("air drag");
    assertThat(run("diagnose", log, "--out=" + out).exit()).isZero();
    String after = run("calibrate", log, "--out=" + out).out();
    assertThat(after)
        .startsWith("Verdict: check first. Let your AI load extended_model.json, which contains")
        .contains("air drag");
    JsonNode json = new ObjectMapper().readTree(out.resolve("calibration.json").toFile());
    assertThat(json.path("verdict").path("because").toString()).contains("air drag");
    Path other = simulated(1);
    assertThat(run("calibrate", other.toString(), "--out=" + out).out().replaceAll("\\s+", " "))
        .doesNotContain("air drag")
        .contains(
            "diagnosis.json, diagnosis.html and extended_model.json in "
                + out
                + " are of other recordings (world-flat-air-drag.log.gz); diagnose replaces them.");
    // The reverse: now the calibration is the one of others.
    assertThat(run("diagnose", log, "--out=" + out).out().replaceAll("\\s+", " "))
        .contains(
            "calibration.json, report.html, geometry_models.pb and geometry_models.txt in "
                + out
                + " are of other recordings ("
                + other.getFileName()
                + "); calibrate replaces them.");
    assertThat(run("calibrate", log, "--out=" + out).out()).doesNotContain("other recordings");
  }

  /** Nobody is to read "publish" beside a diagnosis that says that the model is wrong. */
  @Test
  void theVerdictBesideADiagnosisCountsIt() throws IOException {
    String log = "test-data/world-flat-air-drag.log.gz";
    Path given = Path.of(System.getProperty("fieldcal.projectDir", "."), log);
    Path out = folder.resolve("out");
    run("calibrate", given.toString(), "--out=" + out);
    JsonNode before = json(out.resolve("calibration.json"));
    assertThat(before.path("verdict").toString()).doesNotContain("\"diagnosed\"");

    Answer diagnosed = run("diagnose", given.toString(), "--out=" + out);
    assertThat(diagnosed.out().replace('\n', ' '))
        .contains("The files of calibrate in " + out + " now count this diagnosis. Verdict: check");
    JsonNode after = json(out.resolve("calibration.json"));
    assertThat(after.path("verdict").toString()).contains("\"diagnosed\"");
    assertThat(after.path("verdict"))
        .isEqualTo(json(out.resolve("diagnosis.json")).path("model_verdict"));
    assertThat(Files.readString(out.resolve("report.html"))).contains("The diagnosis explains");
    run("calibrate", given.toString(), "--out=" + out);
    assertThat(json(out.resolve("calibration.json"))).isEqualTo(after);

    // Compared with another model, the calibration is another one, and is not replaced.
    Path other = folder.resolve("other");
    run(
        "calibrate",
        given.toString(),
        "--initial=" + out.resolve("calibration.json"),
        "--out=" + other);
    String bytes = Files.readString(other.resolve("calibration.json"));
    Answer again = run("diagnose", given.toString(), "--out=" + other);
    assertThat(again.out().replace('\n', ' '))
        .contains("do not count this diagnosis: run calibrate again with the same options.");
    assertThat(Files.readString(other.resolve("calibration.json"))).isEqualTo(bytes);
    assertThat(exported(other)).contains("The diagnosis explains what is wrong: air drag.");

    // A diagnosis of other kicks does not count.
    Files.copy(
        out.resolve("diagnosis.json"),
        Files.createDirectories(folder.resolve("few")).resolve("diagnosis.json"));
    run("calibrate", simulated(12).toString(), "--out=" + folder.resolve("few"));
    assertThat(exported(folder.resolve("few"))).doesNotContain("diagnosis explains");
  }

  private String exported(Path directory) {
    return run(
            "export",
            directory.resolve("calibration.json").toString(),
            "--to=geometry-text",
            "--out=" + directory.resolve("models.txt"))
        .out();
  }

  private static JsonNode json(Path file) throws IOException {
    return new ObjectMapper().readTree(file.toFile());
  }

  /** Vision that reports whole centimetres: a resting ball has no noise at all. */
  @Test
  void roundedCoordinatesAreNoDefect() throws IOException {
    Path log = simulated(4);
    Path coarse =
        EditedLog.copy(log, folder.resolve("coarse.log.gz"), DiagnoseCommandTest::rounded);
    Answer answer = run("diagnose", coarse.toString());
    assertThat(answer.err()).doesNotContain("defect", "Exception");
    if (answer.exit() == 0) {
      assertThat(answer.out()).contains("kicks used").doesNotContain("NaN");
    } else {
      assertOneLine(answer, coarse);
    }
  }

  private static VisionPacket rounded(VisionPacket packet) {
    return packet.frame().isEmpty()
        ? packet
        : EditedLog.withBalls(
            packet,
            packet.frame().orElseThrow().balls().stream()
                .map(DiagnoseCommandTest::rounded)
                .toList());
  }

  private static BallDetection rounded(BallDetection b) {
    return new BallDetection(
        Math.rint(100 * b.x()) / 100,
        Math.rint(100 * b.y()) / 100,
        b.z(),
        b.confidence(),
        b.area(),
        Math.rint(b.pixelX()),
        Math.rint(b.pixelY()));
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

  @Test
  void twoRecordingsGiveOneDiagnosis() throws IOException {
    // The second has other cameras under the same ids.
    Path first = dragged(1);
    Path second = dragged(2);
    Path out = folder.resolve("out");
    Path json = folder.resolve("mine.json");
    Answer answer =
        run(
            "diagnose",
            first.toString(),
            second.toString(),
            "--commands=" + first.toString().replace(".log.gz", ".commands.csv"),
            "--out=" + out,
            "--json=" + json);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.err()).isEmpty();
    assertThat(answer.out().replaceAll("\\s+", " "))
        .contains("cause is found: air drag")
        .contains("kicks used");
    assertThat(answer.out()).containsPattern("[1-9]\\d? with their commands");
    for (String name : List.of("diagnosis.html", "extended_model.json")) {
      assertThat(out.resolve(name)).isNotEmptyFile();
    }
    assertThat(json).hasSameTextualContentAs(out.resolve("diagnosis.json"));
    JsonNode root = new ObjectMapper().readTree(json.toFile());
    assertThat(root.get("verdict").textValue()).isEqualTo("explained");
    assertThat(root.get("sources")).hasSize(2);
    JsonNode cause = root.get("causes").get(0);
    assertThat(cause.get("effect").textValue()).isEqualTo("air_drag");
    assertThat(cause.get("parameters").get("cd").doubleValue()).isBetween(0.4, 0.5);
    assertThat(cause.get("holdout_gain_percent").doubleValue()).isGreaterThan(30);
    ExtendedModel model = ExtendedModelFile.read(out.resolve("extended_model.json"), new Epoch(0));
    assertThat(model.effects()).hasSize(1);
    assertThat(model.flat()).isPresent();
  }

  private Path dragged(int seed) {
    Path log = folder.resolve("drag" + seed + ".log.gz");
    Answer answer =
        run(
            "simulate",
            "--scenario=flat",
            "--kicks=6",
            "--physics=contact",
            "--effect=air_drag:cd=0.45",
            "--seed=" + seed,
            "--out=" + log);
    assertThat(answer.exit()).as(answer.err()).isZero();
    return log;
  }

  @Test
  void noCauseIsNamedWhenNoneMayBe() throws IOException {
    Path log = dragged(3);
    Path json = folder.resolve("none.json");
    Answer answer = run("diagnose", log.toString(), "--max-causes=0", "--json=" + json);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(new ObjectMapper().readTree(json.toFile()).get("causes")).isEmpty();
  }
}
