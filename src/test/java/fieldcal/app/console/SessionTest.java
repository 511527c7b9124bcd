package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.EditedLog;
import fieldcal.app.cli.Main;
import fieldcal.app.console.RunningConsole.Answer;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.proto.SSL_GeometryModels;
import fieldcal.proto.SSL_WrapperPacket;
import fieldcal.vision.BallModels;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** A session as a page works with it, without a browser. */
class SessionTest {
  /** A quarter of a second of four cameras: the geometry is among the first packets. */
  private static final long BEGUN_BYTES = 20_000;

  private static final ObjectMapper MAPPER = new ObjectMapper();

  @TempDir private static Path folder;
  private static Path log;

  private Path session;

  @BeforeAll
  static void record() {
    log = SampleSession.small();
  }

  @BeforeEach
  void copy(TestInfo test) throws IOException {
    session = folder.resolve(test.getTestMethod().orElseThrow().getName());
    SampleSession.copy(log, session);
  }

  private RunningConsole ready() throws IOException {
    RunningConsole console = RunningConsole.start(session);
    JsonNode state = console.settled();
    assertThat(kicks(state)).hasSizeGreaterThanOrEqualTo(5);
    return console;
  }

  private static JsonNode kicks(JsonNode state) {
    return state.path("calibration").path("report").path("kicks");
  }

  private static JsonNode kick(JsonNode state, int id) {
    return kicks(state).path(id - 1);
  }

  private static JsonNode parameter(JsonNode state, String name) {
    for (JsonNode p : state.path("calibration").path("report").at("/models/0/parameters")) {
      if (p.path("name").asText().equals(name)) {
        return p;
      }
    }
    throw new AssertionError("no parameter " + name);
  }

  @Test
  void theNumbersAreThoseOfCalibrateForTheSameDecisions() throws IOException {
    try (RunningConsole console = ready()) {
      console.decide("{\"action\":\"drop\",\"kicks\":[3,5],\"reason\":\"a foot\"}");
      console.decide("{\"action\":\"no_two_sigma\"}");
      console.decide("{\"action\":\"two_sigma\"}");
      console.decide("{\"action\":\"keep\",\"kicks\":[1]}");
      console.settled();
      assertThat(console.post("/api/results", "{}").status()).isEqualTo(200);
    }
    Path out = folder.resolve("calibrated");
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(new StringWriter()));
    commands.setErr(new PrintWriter(err));
    String selection = "--selection=" + session.resolve("selection.json");
    int exit =
        commands.execute(
            "calibrate", session.resolve("practice.log.gz").toString(), selection, "--out=" + out);
    assertThat(exit).as(err.toString()).isZero();
    for (String file : new String[] {"calibration.json", "report.html", "geometry_models.pb"}) {
      assertThat(session.resolve(file)).hasSameBinaryContentAs(out.resolve(file));
    }
    assertThat(Files.readString(session.resolve("report.html"))).contains("by hand: a foot");
  }

  @Test
  void aDecisionChangesTheModelAtOnceAndIsTakenBack() throws IOException {
    try (RunningConsole console = ready()) {
      JsonNode before = console.decide("{\"action\":\"no_two_sigma\"}");
      JsonNode dropped = console.decide("{\"action\":\"drop\",\"kicks\":[2]}");
      assertThat(kick(dropped, 2).path("selected").asBoolean()).isFalse();
      assertThat(kick(dropped, 2).path("rejectedBecause").asText()).startsWith("by hand: ");
      JsonNode roll = parameter(dropped, "accRoll");
      assertThat(roll.path("n").asInt())
          .isEqualTo(parameter(before, "accRoll").path("n").asInt() - 1);
      // The mean may be a median, which one kick need not move.
      assertThat(roll.path("standardError"))
          .isNotEqualTo(parameter(before, "accRoll").path("standardError"));
      assertThat(roll.path("differencePercent").isNumber()).isTrue();
      JsonNode undone = console.decide("{\"action\":\"undo\"}");
      assertThat(parameter(undone, "accRoll")).isEqualTo(parameter(before, "accRoll"));
      JsonNode redone = console.decide("{\"action\":\"redo\"}");
      assertThat(parameter(redone, "accRoll")).isEqualTo(roll);
      // The detail of a kick says the same.
      JsonNode detail = console.get("/api/kicks/2").json();
      assertThat(detail.path("selected").asBoolean()).isFalse();
      assertThat(detail.path("seen").path(0).path("t").size()).isGreaterThan(20);
    }
  }

  @Test
  void twoSigmaCanBePressedAgainUntilNothingLeaves() throws IOException {
    Files.copy(
        SampleSession.full(),
        session.resolve(log.getFileName()),
        StandardCopyOption.REPLACE_EXISTING);
    try (RunningConsole console = ready()) {
      JsonNode all = console.state().path("selection");
      JsonNode state = console.decide("{\"action\":\"no_two_sigma\"}");
      int left = 0;
      int presses = 0;
      while (state.at("/selection/wouldLeave").asInt() > 0) {
        int expected = left + state.at("/selection/wouldLeave").asInt();
        state = console.decide("{\"action\":\"two_sigma\"}");
        left = state.at("/selection/leftOut").asInt();
        presses++;
        assertThat(left).isEqualTo(expected);
        assertThat(state.at("/selection/rounds").asInt()).isEqualTo(presses);
      }
      assertThat(presses).isGreaterThanOrEqualTo(2);
      assertThat(left).isEqualTo(all.path("leftOut").asInt());
      Answer more = console.post("/api/decisions", "{\"action\":\"two_sigma\"}");
      assertThat(more.status()).isEqualTo(409);
      assertThat(more.error()).contains("2σ");
    }
  }

  @Test
  void decisionsSurviveARestart() throws IOException {
    try (RunningConsole console = ready()) {
      console.decide("{\"action\":\"drop\",\"kicks\":[4],\"reason\":\"two balls\"}");
      console.decide("{\"action\":\"no_two_sigma\"}");
    }
    try (RunningConsole console = ready()) {
      JsonNode state = console.state();
      assertThat(kick(state, 4).path("rejectedBecause").asText()).isEqualTo("by hand: two balls");
      assertThat(state.at("/selection/rounds").asInt(-1)).isZero();
      assertThat(state.at("/selection/byHand/4").asText()).isEqualTo("drop");
    }
  }

  @Test
  void whatAnotherWindowDecidedIsNotUndoneUnseen() throws IOException {
    try (RunningConsole console = ready()) {
      long seen = console.decide("{\"action\":\"drop\",\"kicks\":[1]}").path("decisions").asLong();
      console.decide("{\"action\":\"drop\",\"kicks\":[2]}");
      String undo = "{\"action\":\"undo\",\"seen\":" + seen + "}";
      Answer refused = console.post("/api/decisions", undo);
      assertThat(refused.status()).isEqualTo(409);
      assertThat(refused.error()).contains("A decision was made in another window");
      assertThat(console.state().at("/selection/byHand")).hasSize(2);
      assertThat(console.post("/api/decisions", "{\"action\":\"drop\",\"kicks\":[99]}").status())
          .isEqualTo(404);
    }
  }

  @Test
  void allWindowsAreTold() throws IOException {
    try (RunningConsole console = ready();
        Socket one = listening(console);
        Socket two = listening(console)) {
      console.decide("{\"action\":\"drop\",\"kicks\":[1]}");
      for (Socket window : new Socket[] {one, two}) {
        BufferedReader lines =
            new BufferedReader(
                new InputStreamReader(window.getInputStream(), StandardCharsets.UTF_8));
        String line = lines.readLine();
        while (line != null && !line.equals("event: state")) {
          line = lines.readLine();
        }
        assertThat(line).isEqualTo("event: state");
        assertThat(lines.readLine()).matches("data: \\d+");
      }
    }
  }

  @Test
  void aWindowThatGoesAwayLeavesNothingBehind() throws IOException, InterruptedException {
    try (RunningConsole console = RunningConsole.start(session)) {
      for (int i = 0; i < 5; i++) {
        try (Socket window = listening(console)) {
          window.getInputStream().read();
          window.setSoLinger(i % 2 == 0, 0);
        }
      }
      while (Thread.getAllStackTraces().values().stream().anyMatch(SessionTest::servesWindow)) {
        // The next word to a window finds that it has gone; the build's time limit ends this
        // otherwise.
        console.post("/api/cancel", "{}");
        Thread.sleep(50);
      }
      assertThat(console.get("/api/state").status()).isEqualTo(200);
    }
  }

  private static boolean servesWindow(StackTraceElement[] stack) {
    return Arrays.stream(stack).anyMatch(e -> e.getClassName().equals(EventHub.class.getName()));
  }

  private static Socket listening(RunningConsole console) throws IOException {
    Socket socket = new Socket("127.0.0.1", console.port());
    socket.setSoTimeout(30_000);
    String request = console.request("GET", "/api/events", "", "Accept: text/event-stream");
    socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
    return socket;
  }

  @Test
  void aFullDiskLosesNothing() throws IOException {
    try (RunningConsole console = ready()) {
      console.decide("{\"action\":\"drop\",\"kicks\":[1]}");
      Path file = session.resolve("selection.json");
      String before = Files.readString(file);
      // What is written first cannot be: as on a disk without room.
      Path blocked = Files.createDirectory(unfinished("selection.json"));
      Files.writeString(blocked.resolve("full"), "");
      JsonNode state = console.decide("{\"action\":\"drop\",\"kicks\":[2]}");
      assertThat(state.at("/unsaved/0").asText()).contains("not saved").contains("selection.json");
      assertThat(state.at("/selection/byHand")).hasSize(2);
      assertThat(file).hasContent(before);
      Files.delete(blocked.resolve("full"));
      Files.delete(blocked);
      JsonNode saved = console.post("/api/save", "{}").json();
      assertThat(saved.path("unsaved")).isEmpty();
      assertThat(Files.readString(file)).isNotEqualTo(before);
    }
    try (RunningConsole console = ready()) {
      assertThat(console.state().at("/selection/byHand")).hasSize(2);
    }
  }

  /** What a file is while this process writes it. */
  private Path unfinished(String name) {
    return session.resolve(name + "." + ProcessHandle.current().pid() + ".part");
  }

  @Test
  void resultsThatCannotBeWrittenAreTold() throws IOException {
    try (RunningConsole console = ready()) {
      Path blocked = Files.createDirectory(unfinished("report.html"));
      Files.writeString(blocked.resolve("full"), "");
      Answer answer = console.post("/api/results", "{}");
      assertThat(answer.status()).isEqualTo(507);
      assertThat(answer.error()).contains("report.html");
      assertThat(session.resolve("report.html")).doesNotExist();
    }
  }

  @Test
  void aRecordingThatComesLaterIsOfferedAndRead() throws IOException {
    try (RunningConsole console = ready()) {
      int before = kicks(console.decide("{\"action\":\"drop\",\"kicks\":[1]}")).size();
      // The same bytes would be a copy, which is left out.
      EditedLog.copy(log, session.resolve("second.log.gz"), p -> EditedLog.later(p, 0.001));
      JsonNode state = console.state();
      assertThat(state.path("unread")).hasSize(1);
      assertThat(state.at("/unread/0").asText()).isEqualTo("second.log.gz");
      assertThat(console.post("/api/read", "{}").status()).isEqualTo(200);
      JsonNode read = console.settled();
      assertThat(read.path("recordings")).hasSize(2);
      assertThat(read.path("unread")).isEmpty();
      assertThat(kicks(read).size()).isGreaterThan(before);
      assertThat(kick(read, 1).path("selected").asBoolean()).isFalse();
    }
  }

  @Test
  void aRecordingThatIsBeingWrittenIsNotOffered() throws IOException {
    Path empty = Files.createDirectory(folder.resolve("playing"));
    try (RunningConsole console = RunningConsole.start(empty)) {
      console.settled();
      String order =
          "{\"field\":\"simulated\",\"kind\":\"flat\",\"half\":\"whole\",\"first\":\"yellow0\","
              + "\"second\":\"yellow1\",\"kicks\":2,\"pace\":1}";
      assertThat(console.post("/api/play", order).status()).isEqualTo(200);
      // A play that is aborted before vision has sent its geometry leaves nothing.
      console.await(
          "it is written", s -> empty.resolve("session-flat.log").toFile().length() > BEGUN_BYTES);
      assertThat(console.state().path("unread")).isEmpty();
      assertThat(console.state().path("watchable")).isEmpty();
      assertThat(console.post("/api/read", "{}").status()).isEqualTo(200);
      assertThat(console.settled().path("recordings")).isEmpty();
      assertThat(console.post("/api/play/word", "{\"word\":\"abort\"}").status()).isEqualTo(200);
      // The list of recordings is read again when the play has closed its file.
      console.await(
          "over and offered",
          s ->
              !s.at("/play/running").asBoolean()
                  && s.at("/unread/0").asText().equals("session-flat.log"));
    }
  }

  @Test
  void filesThatCannotBeUsedAreNamed() throws IOException {
    Files.writeString(session.resolve("notes.log"), "these are notes, no recording");
    Path bomb = session.resolve("zeros.log.gz");
    try (GameLogWriter zeros = GameLogWriter.create(bomb)) {
      for (int i = 0; i < 20; i++) {
        zeros.write(i, MessageType.BLANK, new byte[1_000_000]);
      }
    }
    Files.createFile(session.resolve("session-flat.commands.csv"));
    try (RunningConsole console = RunningConsole.start(session)) {
      JsonNode state = console.settled();
      assertThat(state.at("/leftOut/0").asText()).contains("notes.log");
      assertThat(state.at("/leftOut/1").asText()).contains("zeros.log.gz").contains("unpacks to");
      assertThat(state.path("unread")).isEmpty();
      assertThat(kicks(state)).hasSizeGreaterThanOrEqualTo(5);
      assertThat(console.get("/files/report.html").body())
          .contains("notes.log")
          .contains("cannot be read");
    }
    Files.delete(bomb);
    Files.delete(session.resolve("practice.log.gz"));
    try (RunningConsole console = RunningConsole.start(session)) {
      assertThat(console.settled().path("failure").asText()).contains("notes.log");
      Files.delete(session.resolve("notes.log"));
      Files.writeString(session.resolve("selection.json"), "{\"schema\":");
      SampleSession.copy(log, session);
      console.post("/api/read", "{}");
      JsonNode state = console.settled();
      assertThat(state.path("failure").asText()).contains("selection.json, line");
      // Whatever it is, it is not replaced.
      assertThat(session.resolve("selection.json")).hasContent("{\"schema\":");
    }
  }

  @Test
  void theModelIsSentAsItWasConfirmed() throws IOException {
    try (RunningConsole console = ready();
        DatagramSocket vision = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      vision.setSoTimeout(20_000);
      String text = console.state().at("/model/text").asText();
      assertThat(console.post("/api/publish", send(vision, "models", "another")).status())
          .isEqualTo(409);
      Answer sent = console.post("/api/publish", send(vision, "models", text));
      assertThat(sent.status()).as(sent.body()).isEqualTo(200);
      assertThat(sent.json().at("/published/0/text").asText()).isEqualTo(text);
      BallModels models = BallModels.fromMessage(SSL_GeometryModels.parseFrom(received(vision)));
      assertThat(models.toText()).isEqualTo(text);
      // Who begins to listen later hears it, too.
      assertThat(received(vision)).isEqualTo(models.toBytes());
      assertThat(console.state().at("/sending/running").asBoolean()).isTrue();
      assertThat(console.post("/api/publish/end", "{}").status()).isEqualTo(200);
      console.await("stopped", s -> !s.at("/sending/running").asBoolean());
      assertThat(console.post("/api/publish", send(vision, "wrapper", text)).status())
          .isEqualTo(200);
      byte[] bytes = received(vision);
      while (Arrays.equals(bytes, models.toBytes())) {
        bytes = received(vision); // the last ones of the first sending
      }
      SSL_WrapperPacket packet = SSL_WrapperPacket.parseFrom(bytes);
      assertThat(packet.getGeometry().getModels().getStraightTwoPhase().getAccSlide())
          .isEqualTo(models.flat().orElseThrow().accSlide());
      assertThat(packet.getGeometry().getField().getFieldLength()).isPositive();
      assertThat(packet.hasDetection()).isFalse();
    }
    try (RunningConsole console = ready()) {
      assertThat(console.state().path("published")).hasSize(2);
    }
  }

  @Test
  void addressesThatAreNoneAreRefused() throws IOException {
    try (RunningConsole console = ready()) {
      String text = MAPPER.writeValueAsString(console.state().at("/model/text").asText());
      String[] wrong = {
        "\"address\":\"\",\"port\":10006",
        "\"address\":\"127.0.0.1\"",
        "\"address\":\"127.0.0.1\",\"port\":0",
        "\"address\":\"127.0.0.1\",\"port\":65536",
        "\"address\":\"127.0.0.1\",\"port\":\"10006\"",
        "\"address\":\"not an address!\",\"port\":10006"
      };
      for (String where : wrong) {
        String body = "{\"format\":\"models\",\"confirmed\":" + text + "," + where + "}";
        assertThat(console.post("/api/publish", body).status()).as(where).isEqualTo(400);
      }
      assertThat(console.state().path("published")).isEmpty();
    }
  }

  private static String send(DatagramSocket to, String format, String confirmed)
      throws IOException {
    return MAPPER.writeValueAsString(
        MAPPER
            .createObjectNode()
            .put("address", "127.0.0.1")
            .put("port", to.getLocalPort())
            .put("format", format)
            .put("confirmed", confirmed));
  }

  private static byte[] received(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[65536], 65536);
    socket.receive(packet);
    return Arrays.copyOf(packet.getData(), packet.getLength());
  }

  @Test
  void aDiagnosisCanBeCancelled() throws IOException {
    try (RunningConsole console = ready()) {
      assertThat(console.post("/api/diagnosis", "{}").status()).isEqualTo(200);
      Answer twice = console.post("/api/diagnosis", "{}");
      assertThat(twice.status()).isEqualTo(409);
      assertThat(twice.error()).contains("Diagnosing");
      console.await("running", s -> s.path("work").path("title").asText().equals("Diagnosing"));
      assertThat(console.post("/api/cancel", "{}").status()).isEqualTo(200);
      JsonNode state = console.await("ended", s -> !s.path("work").has("title"));
      assertThat(state.at("/diagnosis/failure").asText()).contains("cancelled");
      assertThat(state.at("/diagnosis/note").isNull()).isTrue();
      assertThat(session.resolve("diagnosis.json")).doesNotExist();
    }
  }
}
