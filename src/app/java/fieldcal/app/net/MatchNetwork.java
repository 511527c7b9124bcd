package fieldcal.app.net;

import fieldcal.gamelog.RefereeState;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** A running match on the network: vision, and a referee if there is one. One thread receives from it. */
public final class MatchNetwork implements AutoCloseable {
  /** How many packets may wait: four cameras send so many in a second; who pauses longer misses some, and never lags. */
  private static final int CAPACITY = 300;

  /** After a silence of that many seconds the group is joined again; vision sends 70 times a second, the referee 10 times. */
  private static final double PATIENCE = 2;

  /** A sender that was silent for longer than the others is no longer named, s. */
  private static final double REMEMBERED = 60;

  /** Receives what came. */
  public interface Sink extends VisionSource.Sink {
    /**
     * The referee's message.
     *
     * @param state what it says
     */
    void referee(RefereeState state);

    /**
     * The bytes of the message that {@link #referee} receives next, for whoever records it.
     *
     * @param message not to be changed
     */
    default void refereeMessage(byte[] message) {}

    /**
     * The same for whoever needs to know when it came.
     *
     * @param message not to be changed
     * @param arrivedNanos on the clock of {@link System#nanoTime}, ns
     */
    default void refereeMessage(byte[] message, long arrivedNanos) {
      refereeMessage(message);
    }
  }

  private final NetworkPlace visionPlace;
  private final Optional<NetworkPlace> refereePlace;
  private final PacketReceiver vision;
  private final VisionSource visionSource;
  private final Optional<PacketReceiver> referee;
  private final RefereeSource refereeSource;
  private final Sink sink;
  private final long begin = System.nanoTime();

  /**
   * Begins to receive.
   *
   * @param vision where vision sends to
   * @param referee where the referee sends to, if there is one
   * @param epoch that times count from
   * @param sink receives what came, from the thread that calls {@link #receive}
   * @throws IOException when a port cannot be opened; one line for the operator
   */
  public MatchNetwork(NetworkPlace vision, Optional<NetworkPlace> referee, Epoch epoch, Sink sink)
      throws IOException {
    visionPlace = vision;
    refereePlace = referee;
    this.sink = sink;
    visionSource = new VisionSource(epoch, sink);
    refereeSource = new RefereeSource(epoch);
    this.vision = new PacketReceiver(vision, CAPACITY, PATIENCE);
    try {
      this.referee =
          referee.isPresent()
              ? Optional.of(new PacketReceiver(referee.get(), CAPACITY, PATIENCE))
              : Optional.empty();
    } catch (IOException e) {
      this.vision.close();
      throw e;
    }
  }

  /**
   * Gives the sink what has come.
   *
   * @param millis how long to wait for vision at most, ms
   * @return how many packets there were
   * @throws InterruptedException when the thread is interrupted
   */
  public int receive(long millis) throws InterruptedException {
    int packets = 0;
    if (referee.isPresent()) {
      Optional<Packet> said = referee.get().take(0);
      while (said.isPresent()) {
        packets++;
        hear(said.get());
        said = referee.get().take(0);
      }
    }
    Optional<Packet> seen = vision.take(millis);
    if (seen.isPresent()) {
      packets++;
      visionSource.accept(seen.get());
    }
    return packets;
  }

  private void hear(Packet packet) {
    Optional<RefereeState> state = refereeSource.accept(packet);
    if (state.isPresent()) {
      sink.refereeMessage(packet.data(), packet.received());
      sink.referee(state.get());
    }
  }

  /**
   * How vision's packets come in.
   *
   * @return counts
   */
  public ReceiverCounts vision() {
    return vision.counts();
  }

  /**
   * Who sends to vision's group.
   *
   * @return one entry per sender
   */
  public List<SourceCounts> visionSources() {
    return visionSource.counts();
  }

  /**
   * When the frame came that the sink is receiving.
   *
   * @return on the clock of {@link System#nanoTime}
   */
  public Arrival arrival() {
    return visionSource.arrival();
  }

  /**
   * For how long no frame came that counts, whatever else may have come.
   *
   * @return time since the last one, or since the beginning when there was none, s
   */
  public double withoutFrames() {
    long last = visionSource.frames() == 0 ? begin : visionSource.lastFrame();
    return 1e-9 * (System.nanoTime() - last);
  }

  /**
   * Whether one sender of vision mixes two fields now; for the thread that calls {@link #receive}.
   *
   * @return a clause for the operator; empty when all is well
   */
  public Optional<String> mixed() {
    return visionSource.mixed().mixed();
  }

  /**
   * What the operator should hear of at once; for the thread that calls {@link #receive}.
   *
   * @return a sentence each; none ever changes or goes away
   */
  public List<String> complaints() {
    return visionSource.mixed().told();
  }

  /**
   * How it does, for the operator.
   *
   * @return one line for each thing worth knowing
   */
  public List<String> notes() {
    List<String> lines = new ArrayList<>();
    ReceiverCounts seen = vision.counts();
    String line = line("vision", visionPlace, seen);
    if (seen.received() > 0 && seen.silentFor() <= PATIENCE && withoutFrames() > PATIENCE) {
      line += String.format(Locale.ROOT, ", NO FRAME among them for %.0f s", withoutFrames());
    }
    lines.add(line);
    senders(lines, visionSource.counts(), visionSource.tooMany());
    if (referee.isPresent()) {
      lines.add(line("referee", refereePlace.orElseThrow(), referee.get().counts()));
      senders(lines, refereeSource.counts(), refereeSource.tooMany());
    }
    return lines;
  }

  private static String line(String name, NetworkPlace place, ReceiverCounts counts) {
    StringBuilder line = new StringBuilder();
    line.append(name).append(": ");
    if (counts.received() == 0) {
      line.append("no packet yet from ").append(place);
      if (!counts.joined().isEmpty()) {
        line.append(" (joined on ").append(String.join(", ", counts.joined())).append(")");
      }
    } else {
      line.append(counts.received()).append(" packets, ").append(counts.dropped());
      line.append(" dropped");
    }
    boolean silent = counts.silentFor() > PATIENCE;
    if (silent) {
      line.append(
          String.format(Locale.ROOT, ". Nothing was received for %.0f s", counts.silentFor()));
      if (counts.rejoined() > 0) {
        line.append(". fieldcal joined the group again ")
            .append(counts.rejoined() == 1 ? "once" : counts.rejoined() + " times");
      }
    }
    counts.problem().ifPresent(p -> line.append(" (").append(p).append(")"));
    if (silent && counts.received() == 0) {
      line.append(". ").append(advice(place));
    }
    return line.toString();
  }

  /** What to try where nothing came at all. */
  private static String advice(NetworkPlace place) {
    if (place.isBroadcast()) {
      return "Check the port, and whether the sender broadcasts";
    }
    if (place.isGroup()) {
      return "Check address, port and --interface; where switches drop multicast, let the sender"
          + " broadcast and listen to 255.255.255.255:"
          + place.address().getPort();
    }
    return "Check address and port";
  }

  /** Those who send, when there are several or something is wrong with one; who left long ago is of no interest any more. */
  private static void senders(List<String> lines, List<SourceCounts> all, long tooMany) {
    List<SourceCounts> here = all.stream().filter(s -> s.silentFor() < REMEMBERED).toList();
    for (SourceCounts s : here) {
      if (here.size() > 1 || s.wrong() > 0) {
        lines.add(source(s));
      }
    }
    if (tooMany > 0) {
      lines.add("  too many senders: " + tooMany + " packets of others ignored");
    }
  }

  private static String source(SourceCounts s) {
    StringBuilder line = new StringBuilder("  from ");
    line.append(s.address().getAddress().getHostAddress())
        .append(':')
        .append(s.address().getPort());
    line.append(": ").append(s.packets()).append(" packets");
    if (!s.cameras().isEmpty()) {
      line.append(", cameras ").append(s.cameras().toString().replaceAll("[\\[\\]]", ""));
    }
    if (s.ignored() > 0) {
      line.append(", ").append(s.ignored()).append(" ignored: another sender has the same cameras");
    }
    if (s.wrong() > 0) {
      line.append(", ").append(s.wrong()).append(" of another protocol");
    }
    if (s.silentFor() > PATIENCE) {
      line.append(String.format(Locale.ROOT, ", silent for %.0f s", s.silentFor()));
    }
    return line.toString();
  }

  @Override
  public String toString() {
    return visionPlace.toString();
  }

  @Override
  public void close() {
    vision.close();
    referee.ifPresent(PacketReceiver::close);
  }
}
