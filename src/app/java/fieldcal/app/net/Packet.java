package fieldcal.app.net;

import java.net.InetSocketAddress;

/**
 * A received packet.
 *
 * @param data its bytes; not to be changed
 * @param source who sent it
 * @param received when it was found, on the clock of {@link System#nanoTime}, ns
 * @param earliest when nothing was waiting last before, on the same clock, ns
 * @param seamless false when packets that came just before it were dropped
 */
record Packet(
    byte[] data, InetSocketAddress source, long received, long earliest, boolean seamless) {
  /** One that was found as soon as it came. */
  Packet(byte[] data, InetSocketAddress source, long received) {
    this(data, source, received, received, true);
  }

  Packet afterDropped() {
    return new Packet(data, source, received, earliest, false);
  }
}
