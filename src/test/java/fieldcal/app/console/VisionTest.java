package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.net.LoopbackSender;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import fieldcal.proto.SSL_WrapperPacket;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What vision publishes now, heard on real sockets, beside what was recorded. */
class VisionTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final FlatModel ELSEWHERE = new FlatModel(-3.5, -0.31, 0.66);

  @TempDir private static Path folder;
  private static RunningConsole console;
  private static FieldGeometry recorded;

  @BeforeAll
  static void start() throws IOException {
    Path log = SampleSession.small();
    Path session = folder.resolve("session");
    SampleSession.copy(log, session);
    recorded = new KickCollector((l, r, t) -> {}).collect(List.of(log)).geometry().orElseThrow();
    console = RunningConsole.start(session);
    console.settled();
  }

  @AfterAll
  static void stop() {
    console.close();
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      return socket.getLocalPort();
    }
  }

  private static void listen(String place, int seconds) throws IOException {
    String body = "{\"vision\":\"" + place + "\",\"seconds\":" + seconds + "}";
    RunningConsole.Answer answer = console.post("/api/vision", body);
    assertThat(answer.status()).as(answer.body()).isEqualTo(200);
    assertThat(answer.json().at("/vision/running").asBoolean()).isTrue();
  }

  /** Listens to a group, as at a venue, while vision sends these packets over and over. */
  private static JsonNode hear(int seconds, VisionPacket... packets) throws IOException {
    int port = freePort();
    try (LoopbackSender vision = new LoopbackSender(port)) {
      listen(LoopbackSender.GROUP + ":" + port, seconds);
      JsonNode state =
          console.await(
              "heard",
              s -> {
                for (VisionPacket packet : packets) {
                  send(vision, packet);
                }
                return !s.at("/vision/running").asBoolean();
              });
      return state.at("/vision/heard");
    }
  }

  private static void send(LoopbackSender vision, VisionPacket packet) {
    try {
      vision.send(new VisionEncoder(new Epoch(0)).encode(packet));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static VisionPacket published(FieldGeometry geometry) {
    return VisionPacket.of(geometry);
  }

  @Test
  void whatVisionPublishesNowIsToldWithItsAgeAndItsSender() throws IOException {
    FieldGeometry now = recorded.withModels(Optional.of(ELSEWHERE), recorded.chip());
    JsonNode heard = hear(60, published(now));
    assertThat(heard.path("lacks").isNull()).as(heard.toString()).isTrue();
    assertThat(heard.at("/values/accSlide").asDouble()).isEqualTo(-3.5);
    assertThat(heard.at("/values/kSwitch").asDouble()).isEqualTo(0.66);
    assertThat(heard.path("differences")).isEmpty();
    assertThat(heard.at("/senders/0").asText()).isEqualTo("127.0.0.1");
    assertThat(heard.path("age").asDouble()).isZero();
    assertThat(heard.path("place").asText()).startsWith(LoopbackSender.GROUP);
  }

  @Test
  void anotherFieldAndOtherCamerasAreWarnedAbout() throws IOException {
    CameraCalibration first = recorded.cameras().get(0);
    CameraCalibration moved =
        new CameraCalibration(
            first.id(),
            first.focalLength(),
            first.principalPointX(),
            first.principalPointY(),
            first.distortion(),
            first.q0(),
            first.q1(),
            first.q2(),
            first.q3(),
            first.tx() + 0.04,
            first.ty(),
            first.tz(),
            Double.NaN,
            Double.NaN,
            Double.NaN,
            first.imageWidth(),
            first.imageHeight());
    FieldGeometry other =
        FieldGeometry.of(
                recorded.length() + 3,
                recorded.width(),
                recorded.goalWidth(),
                recorded.goalDepth(),
                recorded.boundaryWidth(),
                List.of(moved))
            .withModels(Optional.of(ELSEWHERE), Optional.empty());
    JsonNode heard = hear(60, published(other));
    List<String> differences =
        MAPPER.convertValue(heard.path("differences"), MAPPER.constructType(List.class));
    assertThat(differences).hasSize(recorded.cameras().size() > 1 ? 3 : 2);
    assertThat(differences.get(0)).contains("another field");
    assertThat(differences.get(differences.size() - 1))
        .startsWith("Camera " + first.id() + " was calibrated again")
        .contains("40 mm");
    // What is sent as vision sends it carries the field that vision has now.
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      socket.setSoTimeout(20_000);
      String body =
          MAPPER.writeValueAsString(
              MAPPER
                  .createObjectNode()
                  .put("format", "wrapper")
                  .put("address", "127.0.0.1")
                  .put("port", socket.getLocalPort())
                  .put("confirmed", console.state().at("/model/text").asText()));
      assertThat(console.post("/api/publish", body).status()).isEqualTo(200);
      DatagramPacket packet = new DatagramPacket(new byte[65536], 65536);
      socket.receive(packet);
      SSL_WrapperPacket sent =
          SSL_WrapperPacket.parseFrom(Arrays.copyOf(packet.getData(), packet.getLength()));
      assertThat(sent.getGeometry().getField().getFieldLength())
          .isEqualTo((int) Math.round(1000 * other.length()));
      assertThat(sent.getGeometry().getModels().getStraightTwoPhase().getAccSlide())
          .isNotEqualTo(ELSEWHERE.accSlide());
    }
  }

  @Test
  void aVisionThatIsSilentIsSaidToBe() throws IOException {
    listen("127.0.0.1:" + freePort(), 1);
    JsonNode state = console.await("over", s -> !s.at("/vision/running").asBoolean());
    assertThat(state.at("/vision/heard/lacks").asText())
        .contains("Vision is silent")
        .contains("for 1 s");
    assertThat(state.at("/vision/heard/geometry").asBoolean()).isFalse();
  }

  @Test
  void framesWithoutGeometryAndGeometryWithoutModelsAreTold() throws IOException {
    VisionFrame frame = new VisionFrame(3, 7, 1, 1.01, Double.NaN, List.of(), List.of());
    assertThat(hear(1, VisionPacket.of(frame)).path("lacks").asText())
        .contains("frames of camera 3")
        .contains("no geometry");
    FieldGeometry bare = recorded.withModels(Optional.empty(), Optional.empty());
    assertThat(hear(1, published(bare)).path("lacks").asText()).contains("without ball models");
  }

  @Test
  void theListeningCanBeEndedAndIsNotBegunTwice() throws IOException {
    String place = "127.0.0.1:" + freePort();
    listen(place, 100);
    RunningConsole.Answer twice = console.post("/api/vision", "{\"vision\":\"" + place + "\"}");
    assertThat(twice.status()).isEqualTo(409);
    assertThat(console.post("/api/vision/end", "{}").status()).isEqualTo(200);
    JsonNode state = console.await("ended", s -> !s.at("/vision/running").asBoolean());
    assertThat(state.at("/vision/heard/lacks").asText()).contains("stopped");
  }

  @Test
  void placesThatAreNoneAreRefused() throws IOException {
    for (String body :
        List.of(
            "{}",
            "{\"vision\":\"nowhere\"}",
            "{\"vision\":\"224.5.23.2:99999\"}",
            "{\"vision\":\"224.5.23.2:10006\",\"seconds\":0}",
            "{\"vision\":\"224.5.23.2:10006\",\"seconds\":121}",
            "{\"vision\":7}")) {
      assertThat(console.post("/api/vision", body).status()).as(body).isEqualTo(400);
    }
    // An address of the documentation's range, which no machine has.
    RunningConsole.Answer foreign =
        console.post("/api/vision", "{\"vision\":\"203.0.113.7:10006\"}");
    assertThat(foreign.error()).contains("203.0.113.7:10006");
  }
}
