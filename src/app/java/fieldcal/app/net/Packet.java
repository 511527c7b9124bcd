package fieldcal.app.net;

import java.net.InetSocketAddress;

/**
 * A received packet.
 *
 * @param data its bytes; not to be changed
 * @param source who sent it
 * @param received when, on the clock of {@link System#nanoTime}, ns
 */
record Packet(byte[] data, InetSocketAddress source, long received) {}
