package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.hardening.ParserFuzz;
import fieldcal.app.play.PlayField;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneOffset;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What pages ask a console with a calibrated session to do, for {@link ParserFuzz}. An input is the path and the body. Plays, matches and recordings end as soon as they have begun; from the network nothing comes.
 */
public final class ActionsFuzz implements AutoCloseable {
  /** An address that nobody has (RFC 5737), so that it is read, and nothing is heard there. */
  private static final String NOWHERE = "203.0.113.7";

  private static final String HERE = "127.0.0.1";

  /** Where nobody listens: "discard". */
  private static final int NO_PORT = 9;

  /** The history begins again with one entry after so many actions: each reads all of it. */
  private static final int KEPT = 50;

  private static final String ROBOTS =
      "{\"kind\":\"flat\",\"half\":\"whole\",\"first\":\"yellow0\",\"second\":\"blue11\",\"kicks\":12,";
  private static final String NETWORK = "\"vision\":\"" + NOWHERE + ":10006\",\"referee\":\"\"";

  private final Map<String, Action> actions = new LinkedHashMap<>();
  private final Path directory;
  private final Desks desks;
  private final byte[] history;
  private int done;

  private interface Action {
    void run(JsonNode body) throws IOException;
  }

  /**
   * A console without its web server.
   *
   * @param scratch a folder
   * @throws IOException when it cannot be started
   */
  public ActionsFuzz(Path scratch) throws IOException {
    directory = Files.createDirectories(scratch.resolve("actions"));
    SampleSession.copy(SampleSession.small(), directory);
    Path matches = Files.createDirectories(directory.resolve("matches"));
    try (GameLogWriter log = GameLogWriter.create(matches.resolve("m.log"))) {
      log.write(1, MessageType.SSL_VISION_2014, new byte[0]);
    }
    desks =
        new Desks(
            ConsoleSettings.local(directory, 0), Clock.fixed(RunningConsole.NOW, ZoneOffset.UTC));
    desks.start();
    while (!desks.kicks().view().settled()) {
      pause();
    }
    actions.put("/api/play/plan", body -> desks.play().plan(PlayOrder.of(body)));
    actions.put("/api/play", ActionsFuzz::open);
    actions.put("/api/play/word", desks.play()::say);
    actions.put("/api/match", this::match);
    actions.put("/api/vision", this::vision);
    actions.put("/api/record", this::record);
    actions.put("/api/publish", this::publish);
    actions.put("/api/recordings", desks.kicks()::choose);
    actions.put("/api/history/rollback", this::rollBack);
    actions.put(
        "/api/diagnosis/acceptance",
        body ->
            desks
                .diagnosis()
                .decide(Requests.oneOf(body, "acceptance", SessionNotes.Acceptance.values())));
    actions.put("/api/export", desks.export()::export);
    actions.put("/api/export/difference", desks.export()::difference);
    actions.put("/api/export/apply", desks.export()::apply);
    read(text(published()));
    history = Files.readAllBytes(historyFile());
  }

  private Path historyFile() {
    return directory.resolve("history.jsonl");
  }

  /** As the page confirms it. */
  private String published() {
    ObjectNode body = JsonNodeFactory.instance.objectNode().put("format", "models");
    body.put("address", HERE).put("port", NO_PORT);
    body.put("confirmed", desks.kicks().calibrated().models().toText());
    return "/api/publish " + body;
  }

  private static byte[] text(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static void pause() throws IOException {
    try {
      Thread.sleep(20);
    } catch (InterruptedException e) {
      throw new IOException(e);
    }
  }

  /**
   * The groups of actions.
   *
   * @return by name
   */
  public Map<String, ParserFuzz.Target> targets() {
    String base =
        Base64.getEncoder()
            .encodeToString(
                text("fast_deceleration: 2.7 # ours\nslow_deceleration: 1\nswitch_ratio: 0.7\n"));
    String host = "{\"target\":\"ssl-vision-processor\",\"url\":\"http://" + HERE + ":" + NO_PORT;
    Map<String, ParserFuzz.Target> all = new LinkedHashMap<>();
    all.put(
        "console-play",
        target(
            "/api/play/plan "
                + ROBOTS
                + "\"across\":0.5,\"slowest\":2,\"fastest\":6.5,\"seed\":3,\"pace\":1,"
                + "\"driveSpeed\":1.5,\"choice\":\"adaptive\",\"field\":\"simulated\"}",
            "/api/play/plan {\"kind\":\"chip\",\"half\":\"positive_x\",\"first\":\"yellow0\","
                + "\"second\":\"blue11\",\"elevation\":45,\"field\":\"simulated\"}",
            "/api/play "
                + ROBOTS
                + NETWORK
                + ",\"field\":\"simulator\",\"host\":\""
                + HERE
                + "\",\"port\":10300}",
            "/api/play "
                + ROBOTS
                + NETWORK
                + ",\"field\":\"robots\",\"bridge\":\""
                + HERE
                + ":20011\"}",
            "/api/play/word {\"word\":\"pause\"}"));
    all.put(
        "console-network",
        target(
            "/api/match {\"source\":\"network\",\"own_models\":true,\"yellow_limits\":\"3, 3.5,"
                + " 5\","
                + NETWORK
                + "}",
            "/api/match {\"source\":\"recording\",\"recording\":\"matches/m.log\",\"speed\":2,"
                + "\"blue_limits\":\"3; 3.5; 5\"}",
            "/api/vision {" + NETWORK + ",\"seconds\":10}",
            "/api/record {" + NETWORK + "}",
            published()));
    all.put(
        "console-export",
        target(
            "/api/export {\"target\":\"erforce-tracker\",\"baseName\":\"f.txt\",\"base\":\""
                + base
                + "\"}",
            "/api/export {\"target\":\"sumatra\",\"team\":\"yellow\",\"entry\":\"v1\","
                + "\"force\":true,\"from\":1}",
            "/api/export {\"target\":\"grsim\"}",
            "/api/export/difference " + host + "\"}",
            "/api/export/apply " + host + "\",\"force\":true}"));
    all.put(
        "console-session",
        target(
            "/api/recordings {\"name\":\"other.log.gz\",\"use\":null}",
            "/api/history/rollback {\"id\":1}",
            "/api/diagnosis/acceptance {\"acceptance\":\"accepted\"}"));
    return all;
  }

  private ParserFuzz.Target target(String... good) {
    return new ParserFuzz.Target(this::read, Arrays.stream(good).map(ActionsFuzz::text).toList());
  }

  private void read(byte[] input) throws IOException {
    int end = 0;
    while (end < input.length && input[end] != ' ') {
      end++;
    }
    Action action = actions.get(new String(input, 0, end, StandardCharsets.UTF_8));
    if (action == null) {
      throw new IOException("no such action");
    }
    if (++done % KEPT == 0) {
      ParserFuzz.replace(historyFile(), history);
    }
    // The web server answers these with a sentence; anything else is a defect there.
    try {
      JsonNode body = Requests.body(Arrays.copyOfRange(input, end, input.length));
      leadsNowhere(body);
      action.run(body);
    } catch (ApiException e) {
      throw new IOException(e.getMessage(), e);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  /** Names are not looked up, and nothing is sent to other machines or programs. */
  private static void leadsNowhere(JsonNode body) throws IOException {
    String place = "[^:]*|" + NOWHERE + ":.*";
    for (String field : List.of("vision", "referee")) {
      only(body, field, place);
    }
    only(body, "bridge", "[^:]*|" + HERE + ":.*");
    only(body, "host", "|" + HERE);
    only(body, "address", "\\s*|" + HERE);
    only(body, "url", "(?!https?:).*|http://" + HERE + ":" + NO_PORT);
  }

  private static void only(JsonNode body, String field, String allowed) throws IOException {
    if (body.path(field).isTextual()
        && !body.path(field).asText().strip().matches("(?s)" + allowed)) {
      throw new IOException("this address is not tried");
    }
  }

  private static void open(JsonNode body) throws IOException {
    PlayOrder order = PlayOrder.of(body);
    if (order.network().isPresent()) {
      try (PlayField field = order.network().get().open()) {
        field.complaints();
      } catch (IllegalArgumentException e) {
        throw new IOException(e.getMessage(), e);
      }
    }
  }

  private void match(JsonNode body) throws IOException {
    desks.match().start(body);
    desks.match().close();
  }

  private void vision(JsonNode body) throws IOException {
    desks.vision().start(body);
    desks.vision().close();
  }

  private void record(JsonNode body) throws IOException {
    desks.record().start(body);
    desks.record().close();
  }

  private void publish(JsonNode body) {
    desks.publish().send(body);
    desks.publish().close();
  }

  private void rollBack(JsonNode body) throws IOException {
    desks.export().rollBack(body);
    desks.publish().close();
  }

  @Override
  public void close() {
    desks.stop();
  }
}
