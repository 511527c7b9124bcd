package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.net.LoopbackSender;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Recording into a session, and which of its recordings are used. */
class RecordingsTest {
  @TempDir private Path folder;

  @Test
  void aSimulatedRecordingIsKeptApartUntilItIsTicked() throws IOException {
    Path real =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", "grsim-flat.log.gz");
    Files.copy(real, folder.resolve("real.log.gz"));
    Files.copy(SampleSession.small(), folder.resolve("rehearsal.log.gz"));
    try (RunningConsole console = RunningConsole.start(folder)) {
      JsonNode state = console.settled();
      assertThat(state.path("recordings")).hasSize(1);
      assertThat(recording(state, "rehearsal.log.gz").path("used").asBoolean()).isFalse();
      assertThat(recording(state, "rehearsal.log.gz").path("why").asText())
          .isEqualTo("from a simulated field");
      assertThat(recording(state, "real.log.gz").path("kicks").asInt()).isEqualTo(20);
      assertThat(state.path("unread")).as("left out is not unread").isEmpty();

      String body = "{\"name\":\"rehearsal.log.gz\",\"use\":true}";
      assertThat(console.post("/api/recordings", body).status()).isEqualTo(200);
      state = console.await("both used", s -> s.path("recordings").size() == 2);
      assertThat(state.at("/calibration/report/verdict/decision").asText())
          .isEqualTo("do_not_publish");
      String back = "{\"name\":\"rehearsal.log.gz\",\"use\":null}";
      assertThat(console.post("/api/recordings", back).status()).isEqualTo(200);
      console.await("one used", s -> s.path("recordings").size() == 1);
      assertThat(console.post("/api/recordings", "{\"name\":\"x\",\"use\":true}").status())
          .isEqualTo(404);
    }
  }

  /** A line that was read and closed does not come back when the page is loaded again. */
  @Test
  void aLineOnAFileThatIsLeftOutCanBeClosed() throws IOException {
    Files.copy(SampleSession.small(), folder.resolve("kicks.log.gz"));
    Files.writeString(folder.resolve("notes.log"), "no recording");
    try (RunningConsole console = RunningConsole.start(folder);
        Browser browser = new Browser(1280, 720)) {
      console.settled();
      browser.open(console.url() + "#kicks");
      browser.awaitText("#notices", "notes.log");
      browser.click("#notices button:last-child");
      browser.awaitGone("#notices .notice");
      browser.script("location.reload()");
      browser.awaitText("#session", "kicks.log.gz");
      assertThat(browser.text("#notices")).isEmpty();
    }
  }

  /** As an operator does it, on a phone: the list says why a recording is left out, and a tick takes it in. */
  @Test
  void theListIsTickedInTheBrowser() throws IOException {
    Path real =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", "grsim-flat.log.gz");
    Files.copy(real, folder.resolve("real.log.gz"));
    Files.copy(SampleSession.small(), folder.resolve("rehearsal.log.gz"));
    try (RunningConsole console = RunningConsole.start(folder);
        Browser browser = new Browser(390, 844)) {
      console.settled();
      browser.open(console.url() + "#recordings");
      browser.awaitText("#recordings-list", "20");
      assertThat(browser.text("tr[data-why='rehearsal.log.gz']"))
          .isEqualTo("Left out: from a simulated field");
      assertThat(
              browser.script(
                  "const box ="
                      + " document.querySelector(\"tr[data-why='rehearsal.log.gz'] td:last-child\")"
                      + ".getBoundingClientRect(); return box.right <= innerWidth && box.height <"
                      + " 60"))
          .as("the reason is in the window, in one line or two")
          .isEqualTo(true);
      String tick = "tr[data-recording='rehearsal.log.gz'] input";
      browser.click(tick);
      console.await("both used", s -> s.path("recordings").size() == 2);
      JsonNode both = console.settled();
      assertThat(both.at("/calibration/report/verdict/decision").asText())
          .isEqualTo("do_not_publish");
      browser.click("tr[data-why='rehearsal.log.gz'] button");
      console.await("one used", s -> s.path("recordings").size() == 1);
      browser.awaitGone("tr[data-why='rehearsal.log.gz'] button");
      assertThat(browser.script("return document.querySelector(arguments[0]).checked", tick))
          .isEqualTo(false);
      browser.assertNoComplaints();
    }
  }

  /** A file that is still written, or copied over another one, has other kicks than those that were read. */
  @Test
  void aRecordingThatChangedIsNoticedAndReadAgain() throws IOException {
    Path log = folder.resolve("a.log.gz");
    byte[] whole = Files.readAllBytes(SampleSession.small());
    Files.write(log, Arrays.copyOf(whole, whole.length / 2));
    try (RunningConsole console = RunningConsole.start(folder);
        Browser browser = new Browser(1280, 900)) {
      JsonNode state = console.settled();
      assertThat(state.path("changed")).isEmpty();
      assertThat(recording(state, "a.log.gz").path("why").asText()).contains("cut off");
      browser.open(console.url() + "#recordings");
      browser.awaitText("#recordings-list", "cut off");
      Files.write(log, whole);
      state = console.state();
      assertThat(state.at("/changed/0").asText()).isEqualTo("a.log.gz");
      assertThat(state.path("unread")).isEmpty();
      // Whoever looks at the page need not load it again.
      browser.awaitText("#notices", "Changed since they were read: a.log.gz");
      browser.click("#read-changed");
      state = console.await("read again", s -> s.path("changed").isEmpty());
      assertThat(recording(state, "a.log.gz").path("why").asText()).isEmpty();
      // Of the same size, as when a recording replaces another one.
      Files.setLastModifiedTime(log, FileTime.fromMillis(1_763_712_345_000L));
      assertThat(console.state().at("/changed/0").asText()).isEqualTo("a.log.gz");
    }
  }

  @Test
  void whatVisionSendsIsRecordedIntoAnEmptySession() throws Exception {
    int port;
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      port = socket.getLocalPort();
    }
    try (RunningConsole console = RunningConsole.start(folder);
        LoopbackSender vision = new LoopbackSender(port)) {
      console.await("read", s -> !s.path("work").has("title"));
      String place = LoopbackSender.GROUP + ":" + port;
      assertThat(
              console
                  .post("/api/record", "{\"vision\":\"" + place + "\",\"referee\":\"\"}")
                  .status())
          .isEqualTo(200);
      try (GameLogReader log = GameLogReader.open(SampleSession.small())) {
        for (int i = 0; i < 1500 && log.next(); i++) {
          if (log.type() == MessageType.SSL_VISION_2014) {
            int from = log.payloadOffset();
            vision.send(Arrays.copyOfRange(log.buffer(), from, from + log.payloadLength()));
            Thread.sleep(1);
          }
        }
      }
      JsonNode recording = console.state().path("record");
      assertThat(recording.path("running").asBoolean()).isTrue();
      assertThat(recording.at("/status/frames").asInt()).isPositive();
      assertThat(console.state().path("unread")).as("it is not complete yet").isEmpty();
      assertThat(console.post("/api/record/end", "{}").status()).isEqualTo(200);
      JsonNode state = console.await("read", s -> s.path("choice").size() == 1);
      assertThat(state.at("/choice/0/name").asText()).startsWith("recording-").endsWith(".log.gz");
      assertThat(state.at("/choice/0/used").asBoolean()).isTrue();
    }
  }

  private static JsonNode recording(JsonNode state, String name) {
    for (JsonNode one : state.path("choice")) {
      if (one.path("name").asText().equals(name)) {
        return one;
      }
    }
    throw new AssertionError("no recording " + name + " in " + state.path("choice"));
  }
}
