package fieldcal.app.net;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The senders of one group, and who of them is listened to for what: the first, until it has been silent for a while. For one thread but for the counts. */
final class Sources<D> {
  /** A sender that was silent for so long has gone; another one may take its place, ns. */
  static final long SILENCE = 2_000_000_000L;

  /**
   * So many senders are remembered. Vision that is started again sends from another port, so it is a sender of its own each time; whoever has been silent the longest makes room for it. More than that at once
   * are no network of the league's but an attack or a broken router: then whoever never sent a message that can be read makes room first, so that senders of junk do not keep vision out.
   */
  private static final int MOST = 16;

  private static final double SECOND = 1e9;

  /** One sender. */
  static final class Source<D> {
    private final InetSocketAddress address;
    private final D decoder;
    private long last;
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

    InetSocketAddress address() {
      return address;
    }

    /** Whether anything it sent could be read; asked between its packets. */
    private boolean wasUnderstood() {
      return packets > wrong;
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
  private long newest = Long.MIN_VALUE;
  private long tooMany;

  Sources(Function<InetSocketAddress, D> decoders) {
    this.decoders = decoders;
  }

  /** The sender of a packet, which is counted; null when there are too many. */
  synchronized Source<D> of(InetSocketAddress address, long now) {
    newest = Math.max(newest, now);
    Source<D> source = sources.get(address);
    if (source == null) {
      if (sources.size() == MOST && !forgotJunk() && !forgotSilent(now)) {
        tooMany++;
        return null;
      }
      source = new Source<>(address, decoders.apply(address));
      sources.put(address, source);
    }
    source.packets++;
    source.last = now;
    return source;
  }

  private boolean forgotJunk() {
    Optional<Source<D>> junk =
        sources.values().stream()
            .filter(source -> !source.wasUnderstood())
            .min(Comparator.comparingLong((Source<D> s) -> s.last));
    junk.ifPresent(
        source -> {
          tooMany += source.packets;
          sources.remove(source.address);
        });
    return junk.isPresent();
  }

  private boolean forgotSilent(long now) {
    Source<D> oldest =
        Collections.min(sources.values(), Comparator.comparingLong((Source<D> s) -> s.last));
    return now - oldest.last > SILENCE && sources.remove(oldest.address) != null;
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

  /** Who is listened to for something; somebody must have said it. */
  synchronized InetSocketAddress owner(Object what) {
    return owners.get(what).address;
  }

  /** For how long that one has not said it, ns. */
  synchronized long age(Object what, long now) {
    return now - owners.get(what).last;
  }

  /** Packets of senders that were too many, and of those that made room for others. */
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
      double silent = (newest - s.last) / SECOND;
      all.add(new SourceCounts(s.address, s.packets, s.wrong, s.ignored, silent, cameras));
    }
    return all;
  }
}
