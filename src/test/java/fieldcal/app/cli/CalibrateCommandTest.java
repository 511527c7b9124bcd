package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.camera.ChangedCalibration;
import fieldcal.vision.BallModels;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The command as an operator runs it: files, text, exit codes, and what it makes of bad input. */
class CalibrateCommandTest {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir private static Path shared;

  /** Four flat and four chip kicks. */
  private static Path log;

  private static Path out;
  private static String text;

  @TempDir private Path folder;

  private record Answer(int exit, String out, String err) {}

  @BeforeAll
  static void calibrate() {
    log = shared.resolve("mixed.log.gz");
    assertThat(run("simulate", "--scenario=mixed", "--kicks=8", "--seed=3", "--out=" + log).exit())
        .isZero();
    out = shared.resolve("out");
    Path commands = shared.resolve("mixed.commands.csv");
    Answer answer = run("calibrate", log.toString(), "--commands=" + commands, "--out=" + out);
    assertThat(answer.err()).isEmpty();
    assertThat(answer.exit()).isZero();
    text = answer.out();
  }

  private static Answer run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    int exit = commands.execute(args);
    return new Answer(exit, out.toString(), err.toString());
  }

  @Test
  void commandsOfAnotherRecordingAreTold() throws IOException {
    Path other = folder.resolve("other.commands.csv");
    String[] lines =
        Files.readString(shared.resolve("mixed.commands.csv")).replace("\n1", "\n2").split("\n");
    Files.writeString(other, String.join("\n", lines) + "\n");
    assertThat(run("calibrate", log.toString(), "--commands=" + other).out())
        .contains("None of the 8 commands in " + other + " belongs to a kick");
    assertThat(text).doesNotContain("None of the");
  }

  /** Their bounces are none: what a fit makes of them is not worth a word, and no minus sign is a hyphen. */
  @Test
  void flatKicksThatWereFittedAsChipsHaveNoNotesOnSpin() {
    Path flat =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data/grsim-flat.log.gz");
    String forced = run("calibrate", flat.toString(), "--kind=chip").out();
    assertThat(forced).startsWith("Verdict: do not publish").contains("stay on the ground");
    assertThat(forced).doesNotContain("have spin", "does not explain a part");
    assertThat(forced)
        .as("numbers that must not be used")
        .doesNotContain("Chip model:", "damping_z");
    assertThat(forced).doesNotContainPattern("[ (]-\\d\\.\\d{4}");
    List<String> verdict = forced.lines().takeWhile(l -> !l.isEmpty()).toList();
    assertThat(verdict).allMatch(l -> l.length() <= 98);
  }

  /** Of a single kick, a joint fit knows no more than the kick. Its residual is the first reason. */
  @Test
  void oneKickFarFromTheModelIsCheckedFirst() {
    Path one =
        Path.of(
            System.getProperty("fieldcal.projectDir", "."), "test-data/mujoco-rolling-chip.log.gz");
    String out = run("calibrate", one.toString()).out();
    assertThat(out)
        .startsWith("Verdict: check first. Run diagnose")
        .contains("12.4 times the noise")
        .containsPattern("Record at least twelve chips, among\\s+them")
        .contains("Chip model: 0 of 1 kick used.")
        .containsPattern("damping_xy_first_hop +undetermined +0 +undetermined")
        .doesNotContain("calibrate the cameras");
  }

  /** Terminal, report and JSON follow one rule. */
  @Test
  void oneKickHasNoJointFit() throws IOException {
    Path one = folder.resolve("one.log.gz");
    run("simulate", "--scenario=flat", "--kicks=1", "--seed=3", "--out=" + one);
    Path out = folder.resolve("one");
    assertThat(run("calibrate", one.toString(), "--out=" + out).out())
        .containsPattern("acc_slide, m/s² +−\\d\\.\\d+ ± \\d\\.\\d+ +1 +undetermined");
    JsonNode slide = json(out.resolve("calibration.json")).at("/joint/flat/acc_slide");
    assertThat(slide.has("mean")).isFalse();
    assertThat(slide.path("undetermined").asText()).isEqualTo("it needs two kicks");
    assertThat(Files.readString(out.resolve("report.html")))
        .contains("\"accSlide\"")
        .doesNotContainPattern("\"joint\":-?[0-9]");
  }

  /** A diagnosis of these kicks lets one model describe all of them; so does the verdict. */
  @Test
  void oneModelHasToDescribeAllKicks() {
    for (String name : List.of("ode-chip", "erforce-chip", "erforce-flat", "integrated-mixed")) {
      Path log =
          Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", name + ".log.gz");
      assertThat(run("calibrate", log.toString()).out())
          .startsWith("Verdict: " + (name.equals("ode-chip") ? "check first" : "publish"));
    }
  }

  /** Its cameras have no poses, and its time may run at any pace: that is told, as info does, and holds nobody back. */
  @Test
  void theClockOfASimulatorWithoutPosesIsARemark() {
    Path flat =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data/grsim-flat.log.gz");
    String out = run("calibrate", flat.toString()).out();
    assertThat(out)
        .startsWith("Verdict: check first. Run diagnose")
        .contains(
            "  - Cameras 0, 1, 2 and 3: vision's clock runs 3.3 % slower than the recorder's.");
  }

  private static JsonNode json(Path file) throws IOException {
    return JSON.readTree(file.toFile());
  }

  private static JsonNode calibration() throws IOException {
    return json(out.resolve("calibration.json"));
  }

  @Test
  void allFilesAreThere() {
    for (String name :
        List.of(
            "calibration.json",
            "report.html",
            "selection.json",
            "geometry_models.pb",
            "geometry_models.txt")) {
      assertThat(out.resolve(name)).isNotEmptyFile();
    }
  }

  @Test
  void theTextShowsTheModelWithItsErrors() {
    assertThat(text).contains("±");
    assertThat(text).containsAnyOf("accSlide", "acc_slide");
    assertThat(text).containsAnyOf("dampingZ", "damping_z");
    assertThat(text).doesNotContain("NaN");
  }

  @Test
  void theJsonKeepsItsContract() throws IOException {
    JsonNode root = calibration();
    assertThat(root.get("schema").textValue()).isEqualTo("fieldcal.calibration/1");
    assertThat(root.get("sources").get(0).textValue()).isEqualTo(log.toString());
    assertThat(root.get("cameras")).isNotEmpty();
    for (JsonNode camera : root.get("cameras")) {
      assertThat(camera.get("id").isInt()).isTrue();
      assertThat(camera.get("noise_mm").isDouble()).isTrue();
      assertThat(camera.get("rate_hz").doubleValue()).isBetween(50.0, 100.0);
    }
    assertThat(root.get("kicks")).hasSize(8);
    root.get("kicks").forEach(CalibrateCommandTest::checkKick);
    for (String name : List.of("acc_slide", "acc_roll", "k_switch")) {
      checkAverage(root.get("flat").get(name));
      assertThat(root.get("joint").get("flat").get(name).get("mean").isDouble()).isTrue();
    }
    for (String name : List.of("damping_xy_first_hop", "damping_xy_other_hops", "damping_z")) {
      checkAverage(root.get("chip").get(name));
      assertThat(root.get("joint").get("chip").get(name).get("mean").isDouble()).isTrue();
    }
  }

  private static void checkAverage(JsonNode average) {
    assertThat(average.get("mean").isDouble()).isTrue();
    assertThat(average.get("standard_error").doubleValue()).isPositive();
    assertThat(average.get("n").isInt()).isTrue();
    assertThat(average.get("n").intValue()).isBetween(1, 4);
  }

  private static void checkKick(JsonNode kick) {
    assertThat(kick.get("id").isInt()).isTrue();
    assertThat(kick.get("kind").textValue()).isIn("flat", "chip");
    assertThat(kick.get("t").doubleValue()).isGreaterThan(1e9);
    assertThat(kick.get("team").textValue()).isIn("yellow", "blue");
    assertThat(kick.get("robot").isInt()).isTrue();
    assertThat(kick.get("end").textValue())
        .isIn("stopped", "left_field", "touched_robot", "lost", "recording_ended");
    assertThat(kick.get("observations").isInt()).isTrue();
    assertThat(kick.get("rms_mm").doubleValue()).isPositive();
    assertThat(kick.get("kick_position")).hasSize(2);
    assertThat(kick.get("kick_velocity")).hasSize(3);
    boolean chip = kick.get("kind").textValue().equals("chip");
    double up = kick.get("kick_velocity").get(2).doubleValue();
    if (chip) {
      assertThat(up).isPositive();
    } else {
      assertThat(up).isZero();
    }
    assertThat(kick.get("parameters").isObject()).isTrue();
    kick.get("parameters")
        .fieldNames()
        .forEachRemaining(
            name -> assertThat(kick.get("standard_errors").get(name).doubleValue()).isPositive());
    assertThat(kick.get("parameters").size()).isEqualTo(kick.get("standard_errors").size());
    assertThat(kick.get("selected").isBoolean()).isTrue();
    assertThat(kick.has("rejected_because")).isTrue();
    assertThat(kick.get("rejected_because").isNull()).isEqualTo(kick.get("selected").asBoolean());
    assertThat(kick.get("rejected_because").asText() + kick.get("dropped_parameters"))
        .as("parameters are named as on the terminal")
        .doesNotContainPattern("(?<!\\()\\b(acc_slide|acc_roll|k_switch) ");
    assertThat(kick.get("commanded").get("speed").isDouble()).isTrue();
  }

  @Test
  void theJsonHoldsNoNotANumber() throws IOException {
    String content = Files.readString(out.resolve("calibration.json"));
    assertThat(content).doesNotContain("NaN").doesNotContain("Infinity");
  }

  @Test
  void theKicksAreThoseOfTheTruth() throws IOException {
    JsonNode truth = json(shared.resolve("mixed.truth.json")).get("kicks");
    JsonNode kicks = calibration().get("kicks");
    for (int i = 0; i < 8; i++) {
      assertThat(kicks.get(i).get("kind")).isEqualTo(truth.get(i).get("kind"));
      assertThat(kicks.get(i).get("t").doubleValue())
          .isEqualTo(truth.get(i).get("t0_unix").doubleValue(), within(0.005));
    }
  }

  @Test
  void theModelsServeAsTheNextStart() throws IOException {
    BallModels models = InitialModels.read(out.resolve("geometry_models.pb"));
    assertThat(InitialModels.read(out.resolve("geometry_models.txt"))).isEqualTo(models);
    JsonNode flat = calibration().get("flat");
    assertThat(models.flat().orElseThrow().accSlide())
        .isEqualTo(flat.get("acc_slide").get("mean").doubleValue(), within(1e-6));
    Path json = folder.resolve("next.json");
    Answer next =
        run(
            "calibrate",
            log.toString(),
            "--initial=" + out.resolve("calibration.json"),
            "--json=" + json);
    assertThat(next.exit()).as(next.err()).isZero();
    assertThat(json(json).get("published").get("acc_slide").doubleValue())
        .isEqualTo(flat.get("acc_slide").get("mean").doubleValue(), within(1e-12));
    assertThat(json(json).get("flat").get("acc_slide").get("mean").doubleValue())
        .isEqualTo(
            flat.get("acc_slide").get("mean").doubleValue(),
            within(flat.get("acc_slide").get("standard_error").doubleValue()));
  }

  @Test
  void theSameRunGivesTheSameJson() throws IOException {
    Path json = folder.resolve("again.json");
    run(
        "calibrate",
        log.toString(),
        "--commands=" + shared.resolve("mixed.commands.csv"),
        "--json=" + json);
    assertThat(json).hasSameTextualContentAs(out.resolve("calibration.json"));
  }

  @Test
  void aKickDroppedInTheFileIsNotUsedAndTheDecisionSurvives() throws IOException {
    Path mine = folder.resolve("mine");
    Files.createDirectories(mine);
    ObjectNode selection = (ObjectNode) json(out.resolve("selection.json"));
    assertThat(selection.get("kicks")).hasSize(8);
    ObjectNode entry = (ObjectNode) selection.get("kicks").get(2);
    entry.put("decision", "drop").put("reason", "the ball hit a cable");
    JSON.writeValue(mine.resolve("selection.json").toFile(), selection);
    for (int round = 0; round < 2; round++) {
      Answer answer = run("calibrate", log.toString(), "--out=" + mine);
      assertThat(answer.exit()).as(answer.err()).isZero();
      JsonNode kick = json(mine.resolve("calibration.json")).get("kicks").get(2);
      assertThat(kick.get("selected").booleanValue()).isFalse();
      assertThat(kick.get("rejected_because").textValue()).contains("the ball hit a cable");
      JsonNode written = json(mine.resolve("selection.json")).get("kicks").get(2);
      assertThat(written.get("decision").textValue()).isEqualTo("drop");
      assertThat(written.get("reason").textValue()).isEqualTo("the ball hit a cable");
      assertThat(written.get("used").booleanValue()).isFalse();
      assertThat(json(mine.resolve("selection.json")).get("kicks")).hasSize(8);
    }
    assertThat(Files.readString(mine.resolve("report.html"))).contains("the ball hit a cable");
  }

  @Test
  void wrongUsageIsTwo() {
    assertThat(run("calibrate").exit()).isEqualTo(2);
    assertThat(run("calibrate", log.toString(), "--kind=lob").exit()).isEqualTo(2);
    assertThat(run("calibrate", log.toString(), "--kind=lob").err()).contains("auto, flat or chip");
    assertThat(run("calibrate", log.toString(), "--colour=red").exit()).isEqualTo(2);
    assertThat(run("calibrate", log.toString(), "--seed=x").exit()).isEqualTo(2);
    assertThat(run("calibrate", "--help").exit()).isZero();
    assertThat(run("calibrate", "--help").out()).contains("--initial").contains("--commands");
  }

  private void assertOneLine(Answer answer, Object file) {
    assertThat(answer.exit()).as(answer.toString()).isEqualTo(1);
    assertThat(answer.err().lines()).as(answer.err()).hasSize(1);
    assertThat(answer.err()).startsWith("fieldcal: ").contains(file.toString());
    assertThat(answer.err()).doesNotContain("defect").doesNotContain("Exception");
  }

  @Test
  void aFileThatIsNoLogIsOneLine() throws IOException {
    Path missing = folder.resolve("missing.log.gz");
    assertOneLine(run("calibrate", missing.toString()), missing);
    Path empty = Files.write(folder.resolve("empty.log"), new byte[0]);
    assertOneLine(run("calibrate", empty.toString()), empty);
    Path emptyGzip = Files.write(folder.resolve("empty.log.gz"), new byte[0]);
    assertOneLine(run("calibrate", emptyGzip.toString()), emptyGzip);
    Path notes = Files.writeString(folder.resolve("notes.log.gz"), "these are notes, no recording");
    assertOneLine(run("calibrate", notes.toString()), notes);
    assertOneLine(run("calibrate", folder.toString()), folder);
    // The second of two.
    assertOneLine(run("calibrate", log.toString(), notes.toString()), notes);
  }

  @Test
  void badSideFilesAreOneLine() throws IOException {
    Path notes = Files.writeString(folder.resolve("notes.txt"), "notes");
    for (String option : List.of("--commands=", "--initial=", "--selection=")) {
      assertOneLine(run("calibrate", log.toString(), option + notes), notes);
      Path missing = folder.resolve("missing");
      assertOneLine(run("calibrate", log.toString(), option + missing), missing);
    }
  }

  @Test
  void aPlaceThatCannotBeWrittenIsOneLine() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    assertOneLine(run("calibrate", log.toString(), "--out=" + file), file);
  }

  /** What was bad, in the account of the JSON. */
  private List<String> problems(Answer answer, Path json) throws IOException {
    assertThat(answer.exit()).as(answer.toString()).isZero();
    assertThat(answer.err()).isEmpty();
    List<String> what = new ArrayList<>();
    json(json)
        .get("problems")
        .forEach(p -> what.add(p.get("where").textValue() + ": " + p.get("what").textValue()));
    return what;
  }

  private Answer calibrate(Path bad, Path json) {
    return org.junit.jupiter.api.Assertions.assertTimeoutPreemptively(
        Duration.ofSeconds(30),
        () -> run("calibrate", bad.toString(), "--json=" + json, "--out=" + folder.resolve("bad")));
  }

  private int kicks(Path json) throws IOException {
    return json(json).get("kicks").size();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.02, 0.6, 0.99})
  void aTruncatedGzipIsReadUpToThereAndTold(double share) throws IOException {
    byte[] all = Files.readAllBytes(log);
    Path cut =
        Files.write(folder.resolve("cut.log.gz"), Arrays.copyOf(all, (int) (share * all.length)));
    Path json = folder.resolve("cut.json");
    List<String> problems = problems(calibrate(cut, json), json);
    assertThat(problems).anyMatch(p -> p.contains(cut.toString()) && p.contains("ends early"));
    assertThat(kicks(json)).isBetween(0, 8);
  }

  @Test
  void aRecordLongerThanTheFileIsTold() throws IOException {
    byte[] raw = unzipped();
    byte[] more = Arrays.copyOf(raw, raw.length + 16);
    // A header that promises 100 000 bytes.
    java.nio.ByteBuffer.wrap(more, raw.length, 16)
        .putLong(1_700_000_000_000_000_000L)
        .putInt(4)
        .putInt(100_000);
    Path file = Files.write(folder.resolve("long.log"), more);
    Path json = folder.resolve("long.json");
    assertThat(problems(calibrate(file, json), json))
        .anyMatch(p -> p.contains(file + ", byte " + raw.length));
    assertThat(kicks(json)).isEqualTo(8);
  }

  private static byte[] unzipped() throws IOException {
    try (var in = new java.util.zip.GZIPInputStream(Files.newInputStream(log))) {
      return in.readAllBytes();
    }
  }

  @Test
  void garbageBetweenRecordsIsSkippedAndTold() throws IOException {
    byte[] raw = unzipped();
    // At the first record boundary after the middle.
    int at = 16;
    while (at < raw.length / 2) {
      at += 16 + java.nio.ByteBuffer.wrap(raw, at + 12, 4).getInt();
    }
    byte[] garbage = new byte[5000];
    new Random(1).nextBytes(garbage);
    Path file = folder.resolve("garbage.log.gz");
    try (GZIPOutputStream gzip = new GZIPOutputStream(Files.newOutputStream(file))) {
      gzip.write(raw, 0, at);
      gzip.write(garbage);
      gzip.write(raw, at, raw.length - at);
    }
    Path json = folder.resolve("garbage.json");
    assertThat(problems(calibrate(file, json), json)).anyMatch(p -> p.contains(file + ", byte "));
    assertThat(kicks(json)).isEqualTo(8);
  }

  @Test
  void aLogWithoutKicksIsTold() throws IOException {
    Path still =
        EditedLog.copy(
            log,
            folder.resolve("still.log.gz"),
            p -> p.frame().isPresent() ? EditedLog.withBalls(p, List.of()) : p);
    Path json = folder.resolve("still.json");
    Answer answer = calibrate(still, json);
    assertThat(problems(answer, json)).anyMatch(p -> p.contains("no kick found"));
    assertThat(answer.out()).contains("no kick");
    assertThat(kicks(json)).isZero();
    assertThat(json(json).get("flat")).isEmpty();
    assertThat(folder.resolve("bad/geometry_models.pb")).doesNotExist();
    assertThat(folder.resolve("bad/report.html")).isNotEmptyFile();
  }

  @Test
  void aLogWithoutVisionIsTold() throws IOException {
    Path none = EditedLog.copy(log, folder.resolve("none.log"), p -> VisionPacket.EMPTY);
    Path json = folder.resolve("none.json");
    Answer answer = calibrate(none, json);
    assertThat(answer.exit()).isZero();
    assertThat(problems(answer, json)).anyMatch(p -> p.contains("no vision frame"));
  }

  @Test
  void withoutGeometryFlatKicksAreFittedAllTheSame() throws IOException {
    Path bare =
        EditedLog.copy(
            log,
            folder.resolve("bare.log.gz"),
            p -> p.geometry().isPresent() ? VisionPacket.EMPTY : p);
    Path json = folder.resolve("bare.json");
    Answer answer = calibrate(bare, json);
    assertThat(problems(answer, json)).anyMatch(p -> p.contains("no geometry"));
    assertThat(kicks(json)).isEqualTo(8);
    assertThat(json(json).get("flat").get("acc_slide").get("mean").doubleValue())
        .isEqualTo(
            calibration().get("flat").get("acc_slide").get("mean").doubleValue(), within(0.1));
  }

  @Test
  void coordinatesThatAreNoNumbersAreSkippedAndTold() throws IOException {
    AtomicInteger count = new AtomicInteger();
    Path file =
        EditedLog.copy(
            log,
            folder.resolve("nan.log.gz"),
            p -> {
              if (p.frame().isEmpty() || count.incrementAndGet() % 10 != 0) {
                return p;
              }
              double wrong = count.get() % 20 == 0 ? Double.NaN : Double.POSITIVE_INFINITY;
              return EditedLog.withBalls(
                  p,
                  p.frame().get().balls().stream()
                      .map(
                          b ->
                              new fieldcal.vision.BallDetection(
                                  wrong,
                                  b.y(),
                                  b.z(),
                                  b.confidence(),
                                  b.area(),
                                  b.pixelX(),
                                  b.pixelY()))
                      .toList());
            });
    Path json = folder.resolve("nan.json");
    assertThat(problems(calibrate(file, json), json)).anyMatch(p -> p.contains(file.toString()));
    assertThat(kicks(json)).isEqualTo(8);
  }

  @Test
  void aCameraCalibratedAnewMidwayIsAnotherCamera() throws IOException {
    AtomicInteger geometries = new AtomicInteger();
    Path file =
        EditedLog.copy(
            log,
            folder.resolve("changed.log.gz"),
            p ->
                p.geometry().isPresent() && geometries.incrementAndGet() > 15
                    ? VisionPacket.of(p.geometry().get().withCameras(moved(p)))
                    : p);
    Path json = folder.resolve("changed.json");
    assertThat(problems(calibrate(file, json), json))
        .anyMatch(p -> p.contains("another calibration"));
    assertThat(kicks(json)).isBetween(7, 9);
    List<Integer> ids = new ArrayList<>();
    json(json).get("cameras").forEach(c -> ids.add(c.get("id").intValue()));
    assertThat(ids).contains(0, 100);
  }

  private static List<fieldcal.camera.CameraCalibration> moved(VisionPacket packet) {
    return packet.geometry().orElseThrow().cameras().stream()
        .map(c -> ChangedCalibration.withFocalLength(c, c.focalLength() + 1))
        .toList();
  }
}
