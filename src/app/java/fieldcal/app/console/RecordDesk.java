package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.record.NetworkRecorder;
import fieldcal.app.record.RecordStatus;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Optional;

/** Records vision from the network into the session. Thread-safe. */
final class RecordDesk {
  private static final int LONGEST_PLACE = 200;
  private static final long PATIENCE_MS = 3000;
  private static final DateTimeFormatter NAME =
      DateTimeFormatter.ofPattern("'recording'-yyyyMMdd-HHmmss").withZone(ZoneId.systemDefault());

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final Clock clock;
  private final EventHub events;
  private final LiveSession live;
  private volatile NetworkRecorder recorder;
  private volatile Optional<ObjectNode> last = Optional.empty();

  RecordDesk(
      SessionDirectory directory, KickDesk kicks, Clock clock, EventHub events, Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.clock = clock;
    this.events = events;
    live = new LiveSession("recording", changed);
  }

  /**
   * Begins to record. One visitor after the other: who comes second finds that it records already.
   *
   * @throws ApiException when a place is none, or it records already
   * @throws IOException when the network cannot be listened to or the file cannot be written; one line for the operator
   */
  synchronized void start(JsonNode body) throws IOException {
    NetworkPlace vision = place(Requests.text(body, "vision", LONGEST_PLACE).strip());
    String whistle = Requests.text(body, "referee", LONGEST_PLACE).strip();
    Optional<NetworkPlace> referee =
        whistle.isEmpty() ? Optional.empty() : Optional.of(place(whistle));
    live.requireNone();
    Path log = free();
    NetworkRecorder next = new NetworkRecorder(log, false, vision, referee, clock);
    recorder = next;
    last = Optional.empty();
    directory.recording(log);
    try {
      live.start(() -> run(next, log, vision));
    } catch (RuntimeException e) {
      next.close();
      directory.recorded(log);
      throw e;
    }
  }

  /** A name that is not taken yet. */
  private Path free() {
    String name = NAME.format(clock.instant());
    Path log = directory.resolve(name + ".log.gz");
    for (int i = 2; Files.exists(log); i++) {
      log = directory.resolve(name + "-" + i + ".log.gz");
    }
    return log;
  }

  private static NetworkPlace place(String text) {
    try {
      return NetworkPlace.parse(text, null);
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private void run(NetworkRecorder now, Path log, NetworkPlace vision) throws IOException {
    try {
      now.run(Double.POSITIVE_INFINITY, status -> tell(status, log, vision));
    } finally {
      directory.recorded(log);
      if (Files.exists(log)) {
        kicks.readAgain();
      }
    }
  }

  private void tell(RecordStatus status, Path log, NetworkPlace vision) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("file", log.getFileName().toString());
    node.put("line", status.line(vision.toString()));
    node.put("frames", status.frames());
    node.put("seconds", status.seconds());
    last = Optional.of(node);
    events.tell("record", node.toString());
  }

  /** Ends the recording, which becomes part of the session. */
  void stop() {
    NetworkRecorder now = recorder;
    if (now != null) {
      now.stop();
    }
  }

  void close() {
    stop();
    live.join(PATIENCE_MS);
  }

  /** What a page needs to show. */
  ObjectNode state() {
    return live.state(last);
  }
}
