package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.proto.TrackedFrame;
import fieldcal.proto.TrackerWrapperPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class InfoCommandTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  @TempDir Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    return commands.execute(args);
  }

  @Test
  void tellsWhatIsInARecording() {
    assertThat(run("info", DATA.resolve("erforce-flat.log.gz").toString())).isZero();

    assertThat(out.toString())
        .contains("SSL_VISION_2014 22998")
        .contains("12.04 × 9.02 m")
        .contains("66.7 Hz")
        .containsPattern(
            "flat model +sliding deceleration −\\d\\.\\d{3} m/s², rolling deceleration −0\\.\\d{3}"
                + " m/s², switch to rolling 0\\.\\d{3}")
        .contains("only the published position is used")
        .contains("referee     silent")
        .contains("origin      counts as a real field: nothing marks it as simulated");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void aLogWithoutMessagesIsAProblem() throws IOException {
    Path log = folder.resolve("empty.log");
    GameLogWriter.create(log).close();
    assertThat(run("info", log.toString())).isZero();
    assertThat(out.toString())
        .contains("recorded    no messages")
        .contains(
            "problems    1 × the log has a header and no message: nothing was recorded; first at"
                + " byte 16 (empty.log)");
  }

  @Test
  void speaksJson() throws IOException {
    assertThat(run("info", "--json", DATA.resolve("world-null-chip.log.gz").toString())).isZero();

    JsonNode info = new ObjectMapper().readTree(out.toString());
    assertThat(info.get("schema").asText()).isEqualTo("fieldcal.info/1");
    assertThat(info.get("messages").get("ssl_vision_2014").asInt()).isEqualTo(37466);
    assertThat(info.get("cameras")).hasSize(4);
    assertThat(info.get("cameras").get(2).get("noise_mm").asDouble()).isCloseTo(2, within(0.5));
    assertThat(info.get("geometry").get("length_m").asDouble()).isEqualTo(12);
    assertThat(info.get("geometry").get("models").get("chip").get("damping_z").asDouble())
        .isEqualTo(0.47);
    assertThat(info.get("referee").isNull()).isTrue();
    assertThat(info.get("simulated").asBoolean()).isTrue();
  }

  /** The verdict depends on it, whichever of the two marks there is. */
  @Test
  void whereARecordingIsFromIsSaidWithTheMark() throws IOException {
    Path log = folder.resolve("field.log");
    try (GameLogWriter writer = GameLogWriter.create(log)) {
      writer.write(1_763_712_345_000_000_000L, MessageType.BLANK, RecordingOrigin.simulationMark());
    }
    assertThat(run("info", log.toString())).isZero();
    assertThat(out.toString())
        .contains("origin      simulated field: the recording is marked as such");

    Path beside = folder.resolve("other.log");
    GameLogWriter.create(beside).close();
    Files.writeString(folder.resolve("other.truth.json"), "{}");
    assertThat(run("info", beside.toString())).isZero();
    assertThat(out.toString())
        .contains("origin      simulated field: other.truth.json is beside it");
  }

  @Test
  void trackersAreNamed() throws IOException {
    Path log = folder.resolve("trackers.log");
    try (GameLogWriter writer = GameLogWriter.create(log)) {
      for (int i = 0; i < 50; i++) {
        long nanos = 1_763_712_345_000_000_000L + 10_000_000L * i;
        TrackerWrapperPacket packet =
            TrackerWrapperPacket.newBuilder()
                .setUuid("1-2-3")
                .setSourceName("ER-Force AutoRef")
                .setTrackedFrame(
                    TrackedFrame.newBuilder()
                        .setFrameNumber(i)
                        .setTimestamp(1e-9 * (nanos - 20_000_000L)))
                .build();
        writer.write(nanos, MessageType.SSL_VISION_TRACKER_2020, packet.toByteArray());
      }
    }
    assertThat(run("info", log.toString())).as(err.toString()).isZero();
    assertThat(out.toString())
        .contains("ER-Force AutoRef: 50 frames, 100.0 Hz, 20 ms behind, a ball in 0 %, 0 kicks");
    assertThat(run("info", "--json", log.toString())).isZero();
    JsonNode tracker =
        new ObjectMapper()
            .readTree(out.toString().substring(out.toString().indexOf('{')))
            .at("/trackers/0");
    assertThat(tracker.get("source").asText()).isEqualTo("ER-Force AutoRef");
    assertThat(tracker.get("delay_ms").asDouble()).isCloseTo(20, within(1.0));
  }

  @Test
  void damageIsTold() throws IOException {
    byte[] packed = Files.readAllBytes(DATA.resolve("world-null-flat.log.gz"));
    Path cut = Files.write(folder.resolve("cut.log.gz"), Arrays.copyOf(packed, packed.length / 3));

    assertThat(run("info", cut.toString())).isZero();
    assertThat(out.toString()).contains("1 × the gzip file ends early; what comes before is read");
  }

  @Test
  void badInputIsOneLineAndOne() throws IOException {
    Path text = Files.writeString(folder.resolve("notes.txt"), "no log");

    assertThat(run("info", text.toString())).isEqualTo(1);
    assertThat(err.toString().lines())
        .containsExactly(
            "fieldcal: "
                + text
                + " (byte 0): is not an SSL game log (it does not start with SSL_LOG_FILE); choose"
                + " a .log or .log.gz file");
    assertThat(run("info", folder.resolve("none.log").toString())).isEqualTo(1);
  }

  @Test
  void badUsageIsTwo() {
    assertThat(run("info")).isEqualTo(2);
    assertThat(run("info", "--colour", "x.log")).isEqualTo(2);
    assertThat(run("nonsense")).isEqualTo(2);
    assertThat(run()).isEqualTo(2);
    assertThat(run("info", "--help")).isZero();
  }
}
