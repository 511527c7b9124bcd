package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.simulation.TruthJson;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.FieldGeometry;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** The calibration play: plan, run, and what is to be seen of it. Its recording becomes part of the session. Thread-safe. */
final class PlayDesk {
  /** Sessions of one simulated field begin that far apart, s. */
  private static final double BETWEEN_SESSIONS = 1800;

  /** A page cannot show more, ns. */
  private static final long TELL_EVERY = 90_000_000L;

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final EventHub events;
  private final LiveSession live;
  private volatile PlaySession session;
  private volatile Optional<ObjectNode> last = Optional.empty();
  private long told;
  private int toldKicks;
  private String toldPhase = "";

  PlayDesk(SessionDirectory directory, KickDesk kicks, EventHub events, Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.events = events;
    live = new LiveSession("play", changed);
  }

  /** The plan of an order as a drawing: on the simulated field, or on the one of the recordings, or one as large. */
  ObjectNode plan(PlayOrder order) {
    Optional<FieldGeometry> recorded =
        order.network().isEmpty()
            ? Optional.empty()
            : kicks.view().outcome().flatMap(outcome -> outcome.data().geometry());
    FieldGeometry geometry = recorded.orElseGet(() -> field(order.request(), 0).geometry());
    return PlayDrawing.plan(order.request(), geometry);
  }

  /**
   * Begins a play. One visitor after the other: who comes second finds that one is running.
   *
   * @throws ApiException when it cannot be played, or another play is running
   * @throws IOException when the simulator cannot be reached; one line for the operator
   */
  synchronized void start(PlayOrder order) throws IOException {
    // What does not fit on the field is told before anything begins.
    plan(order);
    live.requireNone();
    SessionRequest request = order.request().into(directory.path());
    // Its recording is new, and has the name that recordings of plays have.
    Set<Path> before = Set.copyOf(directory.logs());
    Predicate<Path> its =
        log -> log.getFileName().toString().startsWith("session-") && !before.contains(log);
    if (order.network().isPresent()) {
      PlayField open = open(order.network().get());
      begin(request, open, its, Optional.empty());
    } else {
      int earlier = PlayRun.logs(directory.path()).size();
      InteractiveField field = field(order.request(), earlier * BETWEEN_SESSIONS);
      PlayField open = new EmbeddedPlayField(field, order.pace());
      begin(request, open, its, Optional.of(field));
    }
  }

  private static PlayField open(PlayOrder.Network network) throws IOException {
    try {
      return network.open();
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private void begin(
      SessionRequest request,
      PlayField open,
      Predicate<Path> itsLog,
      Optional<InteractiveField> simulated)
      throws IOException {
    try {
      PlaySession next = new PlaySession(request, open, s -> tell(s, open));
      live.start(
          () -> {
            session = next;
            directory.growing(itsLog);
            try {
              run(next, simulated);
            } finally {
              directory.growing(log -> false);
            }
          });
    } catch (RuntimeException e) {
      open.close();
      throw e;
    }
  }

  private static InteractiveField field(SessionRequest request, double later) {
    SimulationSettings settings = SimulationSettings.DEFAULT.withSeed(request.seed());
    try {
      return InteractiveField.later(settings, request.first(), request.second(), List.of(), later);
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private void run(PlaySession playing, Optional<InteractiveField> simulated) throws IOException {
    PlaySession.Outcome outcome = playing.run();
    directory.growing(log -> false);
    if (outcome.log().isPresent() && simulated.isPresent()) {
      Path log = outcome.log().get();
      String truth = log.getFileName().toString().replaceFirst("\\.log$", ".truth.json");
      JsonFiles.write(
          TruthJson.of(simulated.get().finish(packet -> {})), log.resolveSibling(truth));
    }
    if (!outcome.last().kicks().isEmpty()) {
      kicks.readAgain();
    }
  }

  private void tell(SessionSnapshot snapshot, PlayField field) {
    long now = System.nanoTime();
    String phase = snapshot.state().phase().name() + snapshot.paused();
    boolean news =
        snapshot.kicks().size() != toldKicks
            || !phase.equals(toldPhase)
            || snapshot.state().phase().over();
    if (news || now - told > TELL_EVERY) {
      told = now;
      toldKicks = snapshot.kicks().size();
      toldPhase = phase;
      ObjectNode node = PlayDrawing.snapshot(snapshot);
      ArrayNode complaints = node.putArray("complaints");
      field.complaints().forEach(complaints::add);
      snapshot.state().remarks().forEach(complaints::add);
      last = Optional.of(node);
      events.tell("play", node.toString());
    }
  }

  /** What can be said to a play that runs. */
  enum Word {
    /** Both robots stand. */
    PAUSE,
    /** They go on. */
    RESUME,
    /** It ends; what was recorded stays. */
    ABORT
  }

  /**
   * Says something to the play.
   *
   * @throws ApiException when none is running
   */
  void say(JsonNode body) {
    Word word = Requests.oneOf(body, "word", Word.values());
    PlaySession now = session;
    if (now == null || !live.running()) {
      throw ApiException.conflict("no play is running");
    }
    switch (word) {
      case PAUSE -> now.pause();
      case RESUME -> now.resume();
      case ABORT -> now.abort("the operator ended it");
    }
  }

  void close() {
    PlaySession now = session;
    if (now != null) {
      now.abort("the console was closed");
    }
    live.join(PlaySession.LONGEST_END);
  }

  /** What a page needs to begin with. */
  ObjectNode state() {
    return live.state(last);
  }
}
