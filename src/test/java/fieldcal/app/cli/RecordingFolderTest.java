package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.RecordingFolder;
import fieldcal.app.recording.LogOpener;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** A folder of recordings is calibrated without the rehearsals and matches in it. */
class RecordingFolderTest {
  private static final Path REAL =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", "grsim-flat.log.gz");

  /** A few kicks, where what they say does not matter. */
  private static final Path SMALL =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."),
          "test-data",
          "mujoco-rolling-chip.log.gz");

  @TempDir private Path folder;

  @Test
  void rehearsingDoesNotChangeTheVerdict() throws IOException {
    Files.copy(REAL, folder.resolve("real.log.gz"));
    JsonNode before = calibrated("before").path("verdict");
    run("simulate", "--scenario=flat", "--kicks=8", "--seed=2", "--out=" + folder.resolve("a.log"));
    // Without its truth the recording still says what it is.
    Files.delete(folder.resolve("a.truth.json"));
    run(
        "simulate",
        "--scenario=match",
        "--minutes=1",
        "--seed=3",
        "--out=" + folder.resolve("b.log.gz"));
    String text = run("calibrate", folder.toString());
    assertThat(text)
        .contains("left out: " + folder.resolve("a.log") + ": from a simulated field")
        .contains("left out: " + folder.resolve("b.log.gz") + ": from a simulated field");
    assertThat(calibrated("after").path("verdict")).isEqualTo(before);
    // Nobody is told that the rehearsals' commands belong to no kick.
    assertThat(RecordingFolder.commands(folder)).isNotEmpty();
    assertThat(LogArguments.of(List.of(folder), LogOpener.USUAL).commands(null)).isEmpty();

    Files.writeString(
        folder.resolve("recordings.json"),
        "{\"schema\":\"fieldcal.recordings/1\",\"use\":{\"a.log\":true}}");
    JsonNode mixed = calibrated("mixed").path("verdict");
    assertThat(mixed.path("decision").asText()).isEqualTo("do_not_publish");
    assertThat(mixed.toString()).contains("simulated_field");
  }

  /** A full disk cut one off before its first byte, another is no recording: the console calibrates the others, and so does this. */
  @Test
  void whatCannotBeReadIsLeftOutAndNamed() throws IOException {
    Files.copy(SMALL, folder.resolve("small.log.gz"));
    Files.createFile(folder.resolve("empty.log"));
    Files.writeString(folder.resolve("notes.log"), "hello");
    String text = run("calibrate", folder.toString(), "--out=" + folder.resolve("out"));
    assertThat(text)
        .startsWith("Verdict: ")
        .contains("1 of 3 recordings used.")
        .contains("left out: " + folder.resolve("empty.log") + " (byte 0): is empty")
        .contains("left out: " + folder.resolve("notes.log") + " (byte 0): is not an SSL game log");
    assertThat(Files.readString(folder.resolve("out/report.html"))).contains("empty.log");
    String diagnosed = run("diagnose", folder.toString());
    assertThat(diagnosed).contains("left out: " + folder.resolve("empty.log"));
  }

  /** Counting kicks twice would make all errors too small, and few kicks enough. */
  @Test
  void copiesAreRecognisedByWhatTheyHold() throws IOException {
    Files.copy(REAL, folder.resolve("a.log.gz"));
    JsonNode alone = calibrated("alone");
    Files.copy(REAL, folder.resolve("b.log.gz"));
    try (InputStream packed = new GZIPInputStream(Files.newInputStream(REAL))) {
      Files.copy(packed, folder.resolve("c.log"));
    }
    Path out = folder.resolve("out");
    String text = run("calibrate", folder.toString(), "--out=" + out);
    assertThat(text)
        .contains("left out: " + folder.resolve("b.log.gz") + ": a copy of a.log.gz")
        .contains("left out: " + folder.resolve("c.log") + ": a copy of a.log.gz");
    JsonNode json = new ObjectMapper().readTree(out.resolve("calibration.json").toFile());
    assertThat(json.path("kicks")).isEqualTo(alone.path("kicks"));
    assertThat(json.path("verdict")).isEqualTo(alone.path("verdict"));
    assertThat(json.path("problems").toString()).contains("b.log.gz").contains("c.log");
    assertThat(Files.readString(out.resolve("report.html"))).contains("b.log.gz");

    Path named = folder.resolve("named.json");
    String both =
        run(
            "calibrate",
            folder.resolve("a.log.gz").toString(),
            folder.resolve("c.log").toString(),
            "--json=" + named);
    assertThat(both).contains("c.log: a copy of");
    assertThat(new ObjectMapper().readTree(named.toFile()).path("kicks"))
        .isEqualTo(alone.path("kicks"));
  }

  /** Somebody stopped a copy too early, and another one lacks the beginning. */
  @Test
  void partsAreRecognisedByWhatTheyHold() throws IOException {
    Path whole = Files.copy(REAL, folder.resolve("whole.log.gz"));
    JsonNode alone = calibrated("alone");
    byte[] bytes = Files.readAllBytes(REAL);
    Path cut = folder.resolve("cut.log.gz");
    Files.write(cut, Arrays.copyOf(bytes, bytes.length * 2 / 3));
    Path late = folder.resolve("late.log");
    try (GameLogReader reader = GameLogReader.open(REAL);
        GameLogWriter writer = GameLogWriter.create(late)) {
      for (int i = 0; reader.next(); i++) {
        if (i >= 1000) {
          writer.write(reader.message());
        }
      }
    }
    String text = run("calibrate", folder.toString());
    assertThat(text)
        .contains("left out: " + cut + ": a part of whole.log.gz; the file is cut off")
        .contains("left out: " + late + ": a part of whole.log.gz");
    Path named = folder.resolve("named.json");
    String all =
        run("calibrate", cut.toString(), late.toString(), whole.toString(), "--json=" + named);
    assertThat(all.replaceAll("\\s+", " "))
        .contains("cut.log.gz: a part of " + whole + "; left out.")
        .contains("late.log: a part of " + whole + "; left out.");
    assertThat(new ObjectMapper().readTree(named.toFile()).path("kicks"))
        .isEqualTo(alone.path("kicks"));
  }

  /** Only the truth beside it says that it is simulated, and the copy that is named first has none. */
  @Test
  void aSimulatedRecordingStaysOneWhereItsCopyIsNamedFirst() throws IOException {
    Path marked = Files.copy(REAL, folder.resolve("marked.log.gz"));
    Files.writeString(folder.resolve("marked.truth.json"), "{}");
    Path copy = Files.copy(REAL, folder.resolve("copy.log.gz"));
    Path json = folder.resolve("json");
    String text = run("calibrate", copy.toString(), marked.toString(), "--json=" + json);
    assertThat(text.replaceAll("\\s+", " ")).contains(copy + ": a copy of " + marked);
    assertThat(new ObjectMapper().readTree(json.toFile()).path("verdict").toString())
        .contains("simulated_field");
  }

  @Test
  void aFolderOfNothingReadableIsOneClearError() throws IOException {
    Files.writeString(folder.resolve("notes.log"), "hello");
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setErr(new PrintWriter(err));
    assertThat(commands.execute("calibrate", folder.toString())).isEqualTo(1);
    assertThat(err.toString()).contains("notes.log (byte 0): is not an SSL game log");
  }

  @Test
  void anEmptyFolderIsOneClearError() {
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setErr(new PrintWriter(err));
    assertThat(commands.execute("calibrate", folder.toString())).isEqualTo(1);
    assertThat(err.toString()).contains("there is no recording").contains(folder.toString());
  }

  private JsonNode calibrated(String name) throws IOException {
    Path json = folder.resolve(name + ".json");
    run("calibrate", folder.toString(), "--json=" + json);
    return new ObjectMapper().readTree(json.toFile());
  }

  private static String run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    assertThat(commands.execute(args)).as(err.toString()).isZero();
    return out.toString();
  }
}
