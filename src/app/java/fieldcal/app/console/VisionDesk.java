package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.net.MatchNetwork;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.net.SourceCounts;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.gamelog.RefereeState;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Listens to what vision publishes at the moment, for some seconds. Thread-safe. */
final class VisionDesk {
  private static final int LONGEST_PLACE = 200;

  /** SSL-Vision sends its geometry every few seconds. */
  private static final int USUAL_SECONDS = 10;

  private static final int MOST_SECONDS = 120;
  private static final long WAIT_MS = 50;
  private static final long PATIENCE_MS = 1000;

  private final Clock clock;
  private final LiveSession live;
  private volatile Listening listening;
  private volatile Heard heard;

  VisionDesk(Clock clock, Runnable changed) {
    this.clock = clock;
    live = new LiveSession("listening to vision", changed);
  }

  /**
   * What was heard.
   *
   * @param place where was listened
   * @param unix when it was heard, Unix time in s
   * @param seconds how long was listened
   * @param geometry as vision publishes it; empty when none came
   * @param frames how many came
   * @param cameras which cameras they were of
   * @param senders addresses of those who sent something, the first one first
   * @param notes about the network
   * @param ended whether the operator ended it
   */
  record Heard(
      String place,
      double unix,
      double seconds,
      Optional<FieldGeometry> geometry,
      long frames,
      Set<Integer> cameras,
      List<String> senders,
      List<String> notes,
      boolean ended) {

    BallModels models() {
      return geometry.map(g -> new BallModels(g.flat(), g.chip())).orElse(BallModels.NONE);
    }

    /** Why there is nothing to compare with. */
    Optional<String> lacks() {
      String listened = place + " for " + Math.round(seconds) + " s";
      if (geometry.isPresent()) {
        return models().equals(BallModels.NONE)
            ? Optional.of("Vision publishes its geometry without ball models.")
            : Optional.empty();
      }
      if (ended) {
        return Optional.of("Nothing was received before listening was stopped.");
      }
      if (frames > 0) {
        return Optional.of(
            "Vision sends frames of "
                + (cameras.size() == 1 ? "camera " : "cameras ")
                + cameras.stream().map(String::valueOf).collect(Collectors.joining(", "))
                + ", but no geometry: listened to "
                + listened
                + ". Listen longer, or let vision publish its geometry.");
      }
      return Optional.of(
          senders.isEmpty()
              ? "Vision is silent: nothing was received, listened to "
                  + listened
                  + ". Is this its address, and is it running?"
              : "Packets arrive there, but not from vision: listened to " + listened + ".");
    }
  }

  /**
   * Begins to listen; ends by itself when the geometry with models is there, or the time is over. One visitor after the other: who comes second finds that it listens already.
   *
   * @throws ApiException when the place is none, or it listens already
   * @throws IOException when the place cannot be listened to
   */
  synchronized void start(JsonNode body) throws IOException {
    String vision = Requests.text(body, "vision", LONGEST_PLACE).strip();
    long seconds = Requests.number(body, "seconds").orElse(USUAL_SECONDS);
    if (seconds < 1 || seconds > MOST_SECONDS) {
      throw ApiException.badRequest("seconds must be from 1 to " + MOST_SECONDS);
    }
    NetworkPlace place;
    try {
      place = NetworkPlace.parse(vision, null);
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
    live.requireNone();
    Listening next = new Listening(place, seconds);
    try {
      listening = next;
      live.start(next::run);
    } catch (RuntimeException e) {
      next.network.close();
      throw e;
    }
  }

  /** Ends the listening. */
  void stop() {
    Listening now = listening;
    if (now != null) {
      now.ended = true;
    }
  }

  void close() {
    stop();
    live.join(PATIENCE_MS);
  }

  /** What was heard last; empty before the first time. */
  Optional<Heard> heard() {
    return Optional.ofNullable(heard);
  }

  /** One time of listening. */
  private final class Listening implements MatchNetwork.Sink {
    private final NetworkPlace place;
    private final long seconds;
    private final MatchNetwork network;
    private final Set<Integer> cameras = new TreeSet<>();
    private Optional<FieldGeometry> geometry = Optional.empty();
    private long frames;
    private volatile boolean ended;

    Listening(NetworkPlace place, long seconds) throws IOException {
      this.place = place;
      this.seconds = seconds;
      network =
          new MatchNetwork(
              place, Optional.empty(), Epoch.atSecondOf(clock.millis() / 1000.0), this);
    }

    void run() {
      long began = System.nanoTime();
      double passed = 0;
      try (network) {
        while (passed < seconds && !ended && !complete()) {
          network.receive(WAIT_MS);
          passed = (System.nanoTime() - began) / 1e9;
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      List<String> senders =
          network.visionSources().stream()
              .map(SourceCounts::address)
              .map(a -> a.getAddress().getHostAddress())
              .distinct()
              .toList();
      heard =
          new Heard(
              place.toString(),
              clock.millis() / 1000.0,
              passed,
              geometry,
              frames,
              Set.copyOf(cameras),
              senders,
              senders.size() > 1 ? network.notes() : problem(),
              ended);
    }

    private List<String> problem() {
      return network.vision().problem().map(List::of).orElse(List.of());
    }

    private boolean complete() {
      return geometry.filter(g -> g.flat().isPresent() || g.chip().isPresent()).isPresent();
    }

    @Override
    public void frame(VisionFrame frame) {
      frames++;
      cameras.add(frame.cameraId());
    }

    @Override
    public void geometry(FieldGeometry published) {
      geometry = Optional.of(published);
    }

    @Override
    public void referee(RefereeState state) {
      // Nobody listens to one.
    }
  }

  /**
   * What a page needs to show.
   *
   * @param recorded the geometry that the kicks were recorded under
   */
  ObjectNode state(Optional<FieldGeometry> recorded) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("running", live.running());
    node.put("failure", live.failure().orElse(null));
    Heard now = heard;
    if (now != null) {
      node.set("heard", json(now, recorded));
    }
    return node;
  }

  private ObjectNode json(Heard now, Optional<FieldGeometry> recorded) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("place", now.place);
    node.put("unix", now.unix);
    // The page's clock may be another machine's.
    node.put("age", Math.max(0, clock.millis() / 1000.0 - now.unix));
    node.put("lacks", now.lacks().orElse(null));
    node.put("geometry", now.geometry.isPresent());
    node.put("text", now.models().toText());
    strings(node.putArray("senders"), now.senders);
    strings(node.putArray("notes"), now.notes);
    ObjectNode values = node.putObject("values");
    BallModels models = now.models();
    models.flat().map(FlatModel::parameters).ifPresent(p -> put(values, p));
    models.chip().map(ChipModel::parameters).ifPresent(p -> put(values, p.subList(0, 3)));
    ArrayNode differences = node.putArray("differences");
    if (recorded.isPresent() && now.geometry.isPresent()) {
      strings(differences, GeometryDifference.between(recorded.get(), now.geometry.get()));
    }
    return node;
  }

  private static void put(ObjectNode values, List<Parameter> parameters) {
    parameters.forEach(p -> values.put(p.name(), p.value()));
  }

  private static void strings(ArrayNode to, List<String> all) {
    all.forEach(to::add);
  }
}
