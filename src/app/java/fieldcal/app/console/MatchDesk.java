package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.monitor.MatchDisplay;
import fieldcal.app.monitor.MatchFeed;
import fieldcal.app.monitor.MatchStatus;
import fieldcal.app.monitor.MonitorRequest;
import fieldcal.app.monitor.MonitorSession;
import fieldcal.app.monitor.NetworkFeed;
import fieldcal.app.monitor.ReplayFeed;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.recording.LogOpener;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** A match that is watched, live or from a recording of the session. Thread-safe. */
final class MatchDesk {
  private static final int LONGEST_PLACE = 200;

  /** A page needs no more often, ns; the numbers change with each kick. */
  private static final long TELL_EVERY = 400_000_000L;

  private static final long PATIENCE_MS = 3000;

  private final SessionDirectory directory;
  private final LogOpener opener;
  private final KickDesk kicks;
  private final EventHub events;
  private final LiveSession live;
  private volatile MonitorSession session;
  private volatile Optional<ObjectNode> last = Optional.empty();

  MatchDesk(
      SessionDirectory directory,
      LogOpener opener,
      KickDesk kicks,
      EventHub events,
      Runnable changed) {
    this.directory = directory;
    this.opener = opener;
    this.kicks = kicks;
    this.events = events;
    live = new LiveSession("match", changed);
  }

  /** Where a match comes from. */
  enum Source {
    /** From the network. */
    NETWORK,
    /** From a recording of the session. */
    RECORDING
  }

  /**
   * Begins to watch. One visitor after the other: who comes second finds that a match is being watched.
   *
   * @throws ApiException when the request names nothing that can be watched, or another match is being watched
   */
  synchronized void start(JsonNode body) throws IOException {
    Source source = Requests.oneOf(body, "source", Source.values());
    Optional<BallModels> models =
        body.path("own_models").asBoolean()
            ? Optional.of(kicks.calibrated().models())
            : Optional.empty();
    MonitorRequest request =
        new MonitorRequest(models, Optional.empty(), Optional.empty(), RobotLimits.of(body));
    live.requireNone();
    MatchFeed feed = source == Source.NETWORK ? network(body) : recording(body);
    MonitorSession next;
    try {
      next = new MonitorSession(request, feed, new ToPages());
      session = next;
      live.start(() -> run(next, feed));
    } catch (IOException | RuntimeException e) {
      feed.close();
      throw e;
    }
  }

  private static void run(MonitorSession session, MatchFeed feed) throws IOException {
    try (feed) {
      session.run();
    }
  }

  private static MatchFeed network(JsonNode body) throws IOException {
    String vision = Requests.text(body, "vision", LONGEST_PLACE).strip();
    String referee = Requests.text(body, "referee", LONGEST_PLACE).strip();
    try {
      return new NetworkFeed(
          NetworkPlace.parse(vision, null),
          referee.isEmpty() ? Optional.empty() : Optional.of(NetworkPlace.parse(referee, null)));
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private MatchFeed recording(JsonNode body) throws IOException {
    String name = Requests.text(body, "recording", LONGEST_PLACE);
    double speed = body.path("speed").asDouble(ReplayFeed.UNLIMITED);
    if (!(speed >= 0 && speed <= 1000)) {
      throw ApiException.badRequest("speed must be 0 (as fast as possible) to 1000");
    }
    // Only what is in the list: a name leads nowhere else.
    Path log = directory.watchable().get(name);
    if (log == null) {
      throw ApiException.notFound("the session has no such recording");
    }
    return new ReplayFeed(log, speed, opener);
  }

  /** Ends the watching; the numbers stay. */
  void stop() {
    MonitorSession now = session;
    if (now != null) {
      now.stop();
    }
  }

  void close() {
    stop();
    live.join(PATIENCE_MS);
  }

  /** What a page needs to begin with. */
  ObjectNode state() {
    return live.state(last);
  }

  private final class ToPages implements MatchDisplay {
    private long told;

    @Override
    public void show(MatchStatus status) {
      long now = System.nanoTime();
      if (told == 0 || now - told > TELL_EVERY) {
        told = now;
        tell(status);
      }
    }

    @Override
    public void summary(MatchStatus status) {
      tell(status);
    }

    private void tell(MatchStatus status) {
      ObjectNode node = MatchJson.of(status);
      last = Optional.of(node);
      events.tell("match", node.toString());
    }
  }
}
