package fieldcal.app.net;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** The senders of one group, and who of them is listened to for what: the first, until it has been silent for a while. For one thread but for the counts. */
final class Sources<D> {
  /** A sender that was silent for so long has gone; another one may take its place, ns. */
  static final long SILENCE = 2_000_000_000L;

  /** More senders than that are no network of the league's but an attack or a broken router. */
  private static final int MOST = 16;

  /** One sender. */
  static final class Source<D> {
    private final InetSocketAddress address;
    private final D decoder;
    private long packets;
    private long wrong;
    private long ignored;

    private Source(InetSocketAddress address, D decoder) {
      this.address = address;
      this.decoder = decoder;
    }

    D decoder() {
      return decoder;
    }
  }

  /** Who is listened to for something. */
  private static final class Owner {
    private InetSocketAddress address;
    private long last;
  }

  private final Function<InetSocketAddress, D> decoders;
  private final Map<InetSocketAddress, Source<D>> sources = new LinkedHashMap<>();
  private final Map<Object, Owner> owners = new LinkedHashMap<>();
  private long tooMany;

  Sources(Function<InetSocketAddress, D> decoders) {
    this.decoders = decoders;
  }

  /** The sender of a packet, which is counted; null when there are too many. */
  synchronized Source<D> of(InetSocketAddress address) {
    Source<D> source = sources.get(address);
    if (source == null) {
      if (sources.size() == MOST) {
        tooMany++;
        return null;
      }
      source = new Source<>(address, decoders.apply(address));
      sources.put(address, source);
    }
    source.packets++;
    return source;
  }

  synchronized void wrong(Source<D> source) {
    source.wrong++;
  }

  /** Whether a sender is the one that is listened to for something; if not, that is counted. */
  synchronized boolean owns(Source<D> source, Object what, long now) {
    Owner owner = owners.computeIfAbsent(what, key -> new Owner());
    if (owner.address == null || now - owner.last > SILENCE) {
      owner.address = source.address;
    }
    if (!owner.address.equals(source.address)) {
      source.ignored++;
      return false;
    }
    owner.last = now;
    return true;
  }

  synchronized long tooMany() {
    return tooMany;
  }

  synchronized List<SourceCounts> counts() {
    List<SourceCounts> all = new ArrayList<>();
    for (Source<D> s : sources.values()) {
      List<Integer> cameras =
          owners.entrySet().stream()
              .filter(e -> e.getKey() instanceof Integer && e.getValue().address.equals(s.address))
              .map(e -> (Integer) e.getKey())
              .sorted()
              .toList();
      all.add(new SourceCounts(s.address, s.packets, s.wrong, s.ignored, cameras));
    }
    return all;
  }
}
