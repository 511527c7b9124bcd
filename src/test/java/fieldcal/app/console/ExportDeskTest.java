package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.sun.net.httpserver.HttpServer;
import fieldcal.app.console.RunningConsole.Answer;
import fieldcal.proto.SSL_GeometryModels;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The console gives the model to other programs, remembers it, and puts back what was there. */
class ExportDeskTest {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir private Path directory;

  private RunningConsole ready() throws IOException {
    Path log = directory.resolve("practice.log.gz");
    if (!Files.exists(log)) {
      Files.copy(SampleSession.small(), log);
    }
    RunningConsole console = RunningConsole.start(directory);
    console.settled();
    return console;
  }

  private static String base64(String text) {
    return Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void aTargetsFileIsEditedAndTheHistoryKeepsIt() throws IOException {
    try (RunningConsole console = ready()) {
      // Of the nine one takes nothing but limits of robots, which the console does not measure.
      assertThat(console.state().path("targets"))
          .hasSize(8)
          .noneMatch(t -> t.path("name").asText().equals("robot-specs"))
          .anyMatch(t -> t.path("file").asText().contains("geom.xml"));
      ObjectNode body = JSON.createObjectNode().put("target", "erforce-tracker");
      body.put(
          "base",
          base64(
              "fast_deceleration: 2.7 # ours\nslow_deceleration: 1\n"
                  + "switch_ratio: 0.7\nother: 1\n"));
      body.put("baseName", "field.txt");
      Answer answer = console.post("/api/export", body.toString());
      assertThat(answer.status()).as(answer.body()).isEqualTo(200);
      byte[] bytes = Base64.getDecoder().decode(answer.json().path("bytes").asText());
      double slide = slide(console);
      assertThat(new String(bytes, StandardCharsets.UTF_8))
          .startsWith("fast_deceleration: " + Double.toString(slide).substring(0, 5))
          .contains(" # ours\n")
          .endsWith("other: 1\n");
      assertThat(answer.json().path("changes")).hasSize(3);
      JsonNode entry = console.state().at("/history/0");
      assertThat(entry.path("action").asText()).isEqualTo("EXPORTED");
      assertThat(entry.path("target").asText()).isEqualTo("erforce-tracker");
      assertThat(entry.path("kicks")).isNotEmpty();
      assertThat(entry.at("/model/acc_slide").asDouble()).isEqualTo(-slide);

      body.put("base", base64("nothing: 1\n"));
      Answer refused = console.post("/api/export", body.toString());
      assertThat(refused.status()).isEqualTo(400);
      assertThat(refused.body()).contains("field.txt").contains("fast_deceleration");
      assertThat(console.state().path("history")).hasSize(1);
    }
    try (RunningConsole again = ready()) {
      assertThat(again.state().path("history")).as("kept").hasSize(1);
      ObjectNode old = JSON.createObjectNode().put("target", "immortals").put("from", 1);
      assertThat(again.post("/api/export", old.toString()).status()).isEqualTo(200);
      assertThat(again.post("/api/export", old.put("from", 77).toString()).status()).isEqualTo(404);
    }
  }

  private double slide(RunningConsole console) throws IOException {
    BallModels models =
        BallModels.fromFile(
            console.state().at("/model/text").asText().getBytes(StandardCharsets.UTF_8));
    return -models.flat().orElseThrow().accSlide();
  }

  @Test
  void aPacketIsRememberedAndSentAgain() throws IOException {
    try (RunningConsole console = ready();
        DatagramSocket vision = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      vision.setSoTimeout(20_000);
      ObjectNode send = JSON.createObjectNode().put("format", "models");
      send.put("address", "127.0.0.1").put("port", vision.getLocalPort());
      send.put("confirmed", console.state().at("/model/text").asText());
      assertThat(console.post("/api/publish", send.toString()).status()).isEqualTo(200);
      byte[] first = received(vision);
      JsonNode entry = console.state().at("/history/0");
      assertThat(entry.path("action").asText()).isEqualTo("PUBLISHED");
      assertThat(entry.path("kicks")).isNotEmpty();
      assertThat(console.post("/api/history/rollback", "{\"id\": 1}").status()).isEqualTo(200);
      // The text form, from which it is sent again, has every digit.
      assertThat(SSL_GeometryModels.parseFrom(received(vision)))
          .isEqualTo(SSL_GeometryModels.parseFrom(first));
      assertThat(console.state().path("history")).hasSize(2);
    }
  }

  private static byte[] received(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[65_536], 65_536);
    socket.receive(packet);
    return Arrays.copyOf(packet.getData(), packet.getLength());
  }

  @Test
  void aRunningVisionIsWrittenAndPutBack() throws IOException {
    JsonNode[] document = {
      JSON.readTree("{\"version\": 1, \"models\": {\"straight_two_phase\": {\"acc_slide\": -9}}}")
    };
    JsonNode before = document[0].deepCopy();
    int[] revision = {1};
    HttpServer server =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext(
        "/",
        exchange -> {
          byte[] body = exchange.getRequestBody().readAllBytes();
          if (exchange.getRequestMethod().equals("PUT")) {
            document[0] = JSON.readTree(body).path("document");
            revision[0]++;
          }
          ObjectNode answer = JSON.createObjectNode().put("revision", revision[0]);
          answer.set("document", document[0]);
          answer.putObject("state").put("revision", revision[0]);
          byte[] bytes = answer.toString().getBytes(StandardCharsets.UTF_8);
          exchange.sendResponseHeaders(200, bytes.length);
          exchange.getResponseBody().write(bytes);
          exchange.close();
        });
    server.start();
    try (RunningConsole console = ready()) {
      ObjectNode body = JSON.createObjectNode().put("target", "ssl-vision-processor");
      body.put("url", "http://127.0.0.1:" + server.getAddress().getPort());
      Answer difference = console.post("/api/export/difference", body.toString());
      assertThat(difference.status()).as(difference.body()).isEqualTo(200);
      assertThat(difference.json().at("/changes/0").asText()).contains("-9 → -");
      assertThat(document[0]).as("only shown").isEqualTo(before);
      assertThat(console.post("/api/export/apply", body.toString()).status()).isEqualTo(200);
      assertThat(document[0].at("/models/straight_two_phase/acc_slide").asDouble())
          .isBetween(-4.0, -2.0);
      Answer back = console.post("/api/history/rollback", "{\"id\": 1}");
      assertThat(back.status()).as(back.body()).isEqualTo(200);
      assertThat(document[0]).isEqualTo(before);
      assertThat(back.json().at("/history/0/undoes").asInt()).isEqualTo(1);
      body.put("url", "http://127.0.0.1:1");
      Answer gone = console.post("/api/export/apply", body.toString());
      assertThat(gone.status()).isEqualTo(400);
      assertThat(gone.body()).contains("cannot be reached");
    } finally {
      server.stop(0);
    }
  }

  @Test
  void nonsenseIsRefused() throws IOException {
    try (RunningConsole console = ready()) {
      for (String body :
          new String[] {
            "{}",
            "{\"target\": \"nowhere\"}",
            "{\"target\": \"grsim\", \"base\": \"***\"}",
            "{\"target\": \"robot-specs\"}"
          }) {
        assertThat(console.post("/api/export", body).status()).as(body).isEqualTo(400);
      }
      assertThat(console.post("/api/history/rollback", "{\"id\": 3}").status()).isEqualTo(404);
      assertThat(console.state().path("history")).isEmpty();
    }
  }
}
