package fieldcal.app.net;

import fieldcal.gamelog.RefereeDecoder;
import fieldcal.gamelog.RefereeOrder;
import fieldcal.gamelog.RefereeState;
import fieldcal.vision.Epoch;
import java.util.List;
import java.util.Optional;

/** From packets of the referee to what it says. Of several referees on one group the first is listened to, until it falls silent. */
public final class RefereeSource {
  private static final String REFEREE = "referee";

  private final Sources<RefereeDecoder> sources;
  private final RefereeOrder order = new RefereeOrder();

  /**
   * A source.
   *
   * @param epoch that times count from
   */
  public RefereeSource(Epoch epoch) {
    RefereeDecoder decoder = new RefereeDecoder(epoch);
    sources = new Sources<>(address -> decoder);
  }

  /** What a packet says; nothing if it is no referee's message, another one's, or older than what was heard already. */
  Optional<RefereeState> accept(Packet packet) {
    Sources.Source<RefereeDecoder> source = sources.of(packet.source(), packet.received());
    if (source == null) {
      return Optional.empty();
    }
    Optional<RefereeState> state = source.decoder().decode(packet.data(), 0, packet.data().length);
    if (state.isEmpty()) {
      sources.wrong(source);
    }
    return state
        .filter(s -> sources.owns(source, REFEREE, packet.received()))
        .filter(order::accept);
  }

  /** Packets of senders that were too many; from any thread. */
  long tooMany() {
    return sources.tooMany();
  }

  /**
   * What came from whom; from any thread.
   *
   * @return one entry per sender that is remembered, in the order of their first packet
   */
  public List<SourceCounts> counts() {
    return sources.counts();
  }
}
