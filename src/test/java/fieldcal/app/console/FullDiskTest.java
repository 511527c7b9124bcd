package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.console.RunningConsole.Answer;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A disk without room, for a console that runs as it does at the field: in a process of its own, which the operating system from some moment on lets write no more than 256 bytes into any file. Every write then
 * fails in the middle, as on a full disk.
 */
class FullDiskTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String FULL = "File too large";
  private static final String ORDER =
      "{\"field\":\"simulated\",\"kind\":\"flat\",\"half\":\"whole\",\"first\":\"yellow0\","
          + "\"second\":\"yellow1\",\"kicks\":2,\"pace\":0}";

  @TempDir private Path folder;
  private Process process;

  @Test
  void everythingThatCannotBeWrittenIsSaidAndNothingIsLost() throws Exception {
    assumeTrue(
        Files.isExecutable(Path.of("/usr/bin/prlimit")), "prlimit of util-linux limits a process");
    Path session = folder.resolve("session");
    SampleSession.copy(SampleSession.small(), session);
    try (RunningConsole console = start(session)) {
      console.settled();
      // So few kicks are all needed.
      console.decide("{\"action\":\"no_two_sigma\"}");
      drop(console, 1, "first");
      console.settled();
      assertThat(console.post("/api/results", "{}").status()).isEqualTo(200);
      List<String> before = contents(session);
      room("256");
      decisionsHold(console);
      resultsAreAsTheyWere(console);
      aPlayEndsWithTheReason(console);
      aDiagnosisEndsWithTheReason(console);
      sendingIsNoted(console);
      assertThat(contents(session)).containsAll(before);
      assertThat(unfinished(session)).isEmpty();
      room("unlimited");
      recovers(console);
    }
    // The process was killed; what it said is saved is there.
    try (RunningConsole console = RunningConsole.start(session)) {
      JsonNode state = console.settled();
      assertThat(state.path("failure").isNull()).as(state.path("failure").asText()).isTrue();
      assertThat(state.at("/selection/byHand/1").asText()).isEqualTo("drop");
      assertThat(state.at("/selection/byHand/2").asText()).isEqualTo("drop");
      assertThat(state.path("published")).hasSize(1);
    }
  }

  private RunningConsole start(Path session) throws IOException {
    process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx512m",
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty("java.class.path"),
                "fieldcal.app.cli.Main",
                "console",
                session.toString(),
                "--port=0")
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    BufferedReader said =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String line = said.readLine();
    while (line != null && !line.startsWith("Console of")) {
      line = said.readLine();
    }
    assertThat(line).isNotNull();
    return RunningConsole.at(line.replaceFirst(".*(http://)", "$1"), this::kill);
  }

  private void kill() {
    process.destroyForcibly();
    try {
      process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** How much may be written into a file from now on. */
  private void room(String bytes) throws IOException, InterruptedException {
    Process limit =
        new ProcessBuilder("prlimit", "--pid=" + process.pid(), "--fsize=" + bytes + ":")
            .redirectErrorStream(true)
            .start();
    String said = new String(limit.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(limit.waitFor()).as(said).isZero();
  }

  private static JsonNode drop(RunningConsole console, int kick, String why) throws IOException {
    return console.decide(
        "{\"action\":\"drop\",\"kicks\":[" + kick + "],\"reason\":\"" + why + "\"}");
  }

  private static void decisionsHold(RunningConsole console) throws IOException {
    JsonNode state = drop(console, 2, "while the disk is full");
    assertThat(state.at("/unsaved/0").asText())
        .contains("decisions are not saved")
        .contains("selection.json")
        .contains(FULL);
    assertThat(state.at("/selection/byHand")).hasSize(2);
    console.settled();
  }

  private static void resultsAreAsTheyWere(RunningConsole console) throws IOException {
    Answer results = console.post("/api/results", "{}");
    assertThat(results.status()).as(results.body()).isEqualTo(507);
    assertThat(results.error()).contains("calibration.json").contains(FULL);
    assertThat(console.get("/files/report.html").status()).isEqualTo(507);
  }

  private static void aPlayEndsWithTheReason(RunningConsole console) throws IOException {
    assertThat(console.post("/api/play", ORDER).status()).isEqualTo(200);
    JsonNode state = console.await("ended", s -> !s.at("/play/running").asBoolean());
    assertThat(state.at("/play/failure").asText()).contains("session-flat.log").contains(FULL);
  }

  private static void aDiagnosisEndsWithTheReason(RunningConsole console) throws IOException {
    assertThat(console.post("/api/diagnosis", "{}").status()).isEqualTo(200);
    JsonNode state = console.await("ended", s -> !s.path("work").has("title"));
    assertThat(state.at("/diagnosis/failure").asText()).contains("diagnosis.json").contains(FULL);
  }

  private static void sendingIsNoted(RunningConsole console) throws IOException {
    try (DatagramSocket vision = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      String text = console.settled().at("/model/text").asText();
      String body =
          MAPPER.writeValueAsString(
              MAPPER
                  .createObjectNode()
                  .put("format", "models")
                  .put("address", "127.0.0.1")
                  .put("port", vision.getLocalPort())
                  .put("confirmed", text));
      Answer sent = console.post("/api/publish", body);
      assertThat(sent.status()).as(sent.body()).isEqualTo(200);
      assertThat(sent.json().path("published")).hasSize(1);
    }
  }

  private static void recovers(RunningConsole console) throws IOException {
    JsonNode saved = console.post("/api/save", "{}").json();
    assertThat(saved.path("unsaved")).isEmpty();
    assertThat(console.post("/api/results", "{}").status()).isEqualTo(200);
    assertThat(console.get("/files/report.html").body()).contains("while the disk is full");
    assertThat(console.post("/api/play", ORDER).status()).isEqualTo(200);
    JsonNode state =
        console.await(
            "played",
            s ->
                !s.at("/play/running").asBoolean()
                    && s.path("recordings").toString().contains("-2"));
    assertThat(state.at("/play/failure").isNull()).as(state.at("/play").toString()).isTrue();
    assertThat(state.path("failure").isNull()).isTrue();
  }

  /** What is in the files that were complete before; recordings apart. */
  private static List<String> contents(Path session) throws IOException {
    try (Stream<Path> files = Files.list(session)) {
      return files
          .filter(file -> !file.toString().contains("session-"))
          .filter(file -> !file.toString().endsWith(".gz"))
          .sorted()
          .map(FullDiskTest::content)
          .toList();
    }
  }

  private static String content(Path file) {
    try {
      return file.getFileName() + new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static List<Path> unfinished(Path session) throws IOException {
    try (Stream<Path> files = Files.list(session)) {
      return files.filter(file -> file.toString().endsWith(".part")).toList();
    }
  }
}
