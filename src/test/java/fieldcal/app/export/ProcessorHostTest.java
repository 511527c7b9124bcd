package fieldcal.app.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.cli.Main;
import fieldcal.app.history.History;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code export --apply} against a stand-in of the league's vision host, with its revisions, conflicts and refusals. */
class ProcessorHostTest {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir private Path folder;

  private StandIn host;
  private Path model;

  /** What the address ends with. */
  private String slash = "";

  /** The rules of gui/cmd/ssl-vision-processor-gui/server.go: one working document with a revision, and a file. */
  private static final class StandIn {
    private final HttpServer server;
    private ObjectNode working;
    private ObjectNode disk;
    private int revision = 7;

    /** How often somebody else edits between a read and the write that follows. */
    private int interruptions;

    /** How often somebody else edits between a write and the saving that follows. */
    private int editsBeforeSaving;

    private boolean diskChanged;

    StandIn(JsonNode document) throws IOException {
      working = document.deepCopy();
      disk = document.deepCopy();
      server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
      server.createContext("/", this::handle);
      server.start();
    }

    String url() {
      return "http://127.0.0.1:" + server.getAddress().getPort();
    }

    private synchronized void handle(HttpExchange exchange) throws IOException {
      String what = exchange.getRequestMethod() + " " + exchange.getRequestURI();
      byte[] body = exchange.getRequestBody().readAllBytes();
      switch (what) {
        case "GET /api/config" -> {
          ObjectNode answer = JSON.createObjectNode();
          answer.set("document", working);
          answer.putObject("state").put("revision", revision).put("path", "vision.yml");
          answer(exchange, 200, answer.toString());
          if (interruptions > 0) {
            interruptions--;
            working.put("touched", revision++);
          }
        }
        case "PUT /api/config" -> put(exchange, JSON.readTree(body));
        case "POST /api/config/save" -> save(exchange, JSON.readTree(body));
        default -> answer(exchange, 404, "404 page not found");
      }
    }

    private void put(HttpExchange exchange, JsonNode request) throws IOException {
      if (request.path("revision").asInt() != revision) {
        answer(exchange, 409, "{\"error\":\"stale\",\"message\":\"stale revision\"}");
      } else if (request.path("document").path("version").asInt() != 1) {
        answer(exchange, 400, "version: want 1, got 0");
      } else {
        working = request.path("document").deepCopy();
        answer(exchange, 200, "{\"revision\":" + ++revision + "}");
        if (editsBeforeSaving > 0) {
          editsBeforeSaving--;
          working.put("touched", revision++);
        }
      }
    }

    private void save(HttpExchange exchange, JsonNode request) throws IOException {
      if (request.path("revision").asInt() != revision) {
        answer(exchange, 409, "{\"error\":\"stale\",\"message\":\"stale revision\"}");
      } else if (diskChanged && !request.path("force").asBoolean()) {
        answer(exchange, 409, "{\"error\":\"disk_changed\",\"message\":\"file changed\"}");
      } else {
        disk = working.deepCopy();
        answer(exchange, 204, "");
      }
    }

    private static void answer(HttpExchange exchange, int status, String text) throws IOException {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      exchange.sendResponseHeaders(status, bytes.length == 0 ? -1 : bytes.length);
      exchange.getResponseBody().write(bytes);
      exchange.close();
    }
  }

  @BeforeEach
  void start() throws IOException {
    host =
        new StandIn(
            JSON.readTree(
                """
                {"version": 1, "field": {"field_length": 9000}, "optionalFieldLines": {"halfway": true},
                 "models": {"straight_two_phase": {"acc_slide": -3.4, "acc_roll": -0.45, "k_switch": 0.64},
                            "chip_fixed_loss": {"damping_xy_first_hop": 0.55, "damping_xy_other_hops": 0.88, "damping_z": 0.54}},
                 "cameras": [{"cameraId": 0, "config": {"camera": {"width": 1920}}}]}
                """));
    model = folder.resolve("calibration.json");
    Files.copy(TargetsTest.file("calibration.json"), model);
  }

  @AfterEach
  void stop() {
    host.server.stop(0);
  }

  private record Answer(int exit, String out, String err) {}

  private Answer run(String... more) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    String[] args = new String[more.length + 4];
    args[0] = "export";
    args[1] = model.toString();
    args[2] = "--to=ssl-vision-processor";
    args[3] = "--apply=" + host.url() + slash;
    System.arraycopy(more, 0, args, 4, more.length);
    int exit = commands.execute(args);
    return new Answer(exit, out.toString(), err.toString());
  }

  @Test
  void showsTheDifferenceWritesItAndSaves() throws IOException {
    JsonNode before = host.working.deepCopy();
    Answer answer = run();
    assertThat(answer.err()).isEmpty();
    assertThat(answer.exit()).isZero();
    assertThat(answer.out())
        .contains("acc_slide  -3.4 → -3.12346 m/s²")
        .contains("damping_z  0.54 → 0.4875")
        .contains("saved");
    assertThat(host.disk).isEqualTo(host.working);
    assertThat(host.disk.at("/models/straight_two_phase/acc_slide").doubleValue())
        .isEqualTo(-3.12346);
    ObjectNode rest = host.disk.deepCopy();
    rest.set("models", before.get("models"));
    assertThat(rest).isEqualTo(before);
  }

  @Test
  void aStaleRevisionIsReadAgain() {
    host.interruptions = 2;
    assertThat(run().exit()).isZero();
    assertThat(host.disk.at("/models/straight_two_phase/k_switch").doubleValue()).isEqualTo(0.65);
    assertThat(host.disk.path("touched").asInt()).as("the other's edit stays").isEqualTo(8);
  }

  @Test
  void somebodyWhoNeverStopsEndsTheAttempt() {
    host.interruptions = 100;
    Answer answer = run();
    assertThat(answer.exit()).isEqualTo(1);
    assertThat(answer.err()).contains("keeps changing").hasLineCount(1);
  }

  @Test
  void aFileThatChangedOnDiskIsNotOverwritten() throws IOException {
    host.diskChanged = true;
    JsonNode disk = host.disk.deepCopy();
    Answer answer = run();
    assertThat(answer.exit()).isEqualTo(1);
    assertThat(answer.err()).contains("did not save").hasLineCount(1);
    assertThat(host.disk).isEqualTo(disk);
    // What is in use now can be taken back all the same.
    assertThat(new History(folder).entries())
        .singleElement()
        .satisfies(entry -> assertThat(entry.action()).isEqualTo(Action.APPLIED));
    host.diskChanged = false;
    assertThat(run("--rollback").exit()).isZero();
    assertThat(host.disk).isEqualTo(disk);
  }

  @Test
  void aSlashAtTheEndIsTheSameHost() throws IOException {
    JsonNode before = host.disk.deepCopy();
    slash = "/";
    assertThat(run().exit()).isZero();
    slash = "";
    assertThat(run("--rollback").exit()).isZero();
    assertThat(host.disk).isEqualTo(before);
  }

  @Test
  void rollbackPutsBackWhatWasThere() throws IOException {
    JsonNode before = host.disk.deepCopy();
    run();
    assertThat(host.disk).isNotEqualTo(before);
    Answer answer = run("--rollback");
    assertThat(answer.err()).isEmpty();
    assertThat(answer.exit()).isZero();
    assertThat(host.disk).isEqualTo(before);
    assertThat(new History(folder).entries())
        .extracting(HistoryEntry::action)
        .containsExactly(Action.APPLIED, Action.ROLLED_BACK);
    assertThat(run("--rollback").err()).contains("nothing to put back");
  }

  /** What is read again then are the new values, which are nothing to put back. */
  @Test
  void rollbackPutsBackWhatWasThereAlsoWhenSomebodyEditedBeforeItWasSaved() throws IOException {
    JsonNode before = host.disk.get("models").deepCopy();
    host.editsBeforeSaving = 1;
    assertThat(run().exit()).isZero();
    assertThat(host.disk.get("models")).isNotEqualTo(before);
    assertThat(run("--rollback").exit()).isZero();
    assertThat(host.disk.get("models")).isEqualTo(before);
    assertThat(host.disk.path("touched").asInt()).as("the other's edit stays").isEqualTo(8);
  }

  @Test
  void rollbackAlsoRemovesModelsThatWereNotThere() throws IOException {
    host.working.remove("models");
    JsonNode before = host.working.deepCopy();
    assertThat(run().out()).contains("acc_slide  -3.12346 m/s²");
    assertThat(run("--rollback").exit()).isZero();
    assertThat(host.working).isEqualTo(before);
  }

  @Test
  void aRefusalIsPassedOn() {
    host.working.put("version", 0);
    Answer answer = run();
    assertThat(answer.exit()).isEqualTo(1);
    assertThat(answer.err()).contains("status 400: version: want 1").hasLineCount(1);
  }

  @Test
  void anotherServerIsNotWrittenTo() {
    assertThatThrownBy(() -> new ProcessorHost(host.url() + "/elsewhere"))
        .isInstanceOf(InputException.class);
    host.working = JSON.createObjectNode();
    host.revision = 1;
    Answer answer = run();
    assertThat(answer.exit()).isEqualTo(1);
  }

  @Test
  void aHostThatIsNotThereIsOneLine() {
    String url = host.url();
    host.server.stop(0);
    Answer answer = run();
    assertThat(answer.exit()).isEqualTo(1);
    assertThat(answer.err()).startsWith("fieldcal: " + url + ": cannot be reached").hasLineCount(1);
  }
}
