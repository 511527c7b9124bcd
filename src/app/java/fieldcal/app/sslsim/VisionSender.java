package fieldcal.app.sslsim;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Collections;
import java.util.function.LongSupplier;

/**
 * Sends vision's packets to a multicast group, to all by broadcast, or to one address. A machine without a network sends multicast to itself, and tries the network again each second. A packet that cannot be
 * sent is lost, as on any network, and counted.
 */
final class VisionSender implements Closeable {
  /** A cable that was pulled is back after seconds, ns. */
  private static final long TRY_AGAIN = 1_000_000_000L;

  /** A way that packets can take. */
  interface Way {
    void send(byte[] packet) throws IOException;
  }

  private final Way network;
  private final Way loopback;
  private final LongSupplier nanos;
  private final Closeable channels;
  private boolean onLoopback;
  private long failedAt;
  private long lost;

  VisionSender(InetSocketAddress target) throws IOException {
    DatagramChannel network = DatagramChannel.open(StandardProtocolFamily.INET);
    DatagramChannel loopback = DatagramChannel.open(StandardProtocolFamily.INET);
    channels =
        () -> {
          network.close();
          loopback.close();
        };
    // Nothing where the address is none of a broadcast.
    network.setOption(StandardSocketOptions.SO_BROADCAST, true);
    boolean multicast = target.getAddress().isMulticastAddress();
    if (multicast) {
      toGroup(network);
      toGroup(loopback);
      for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
        if (one.isLoopback() && one.isUp()) {
          loopback.setOption(StandardSocketOptions.IP_MULTICAST_IF, one);
        }
      }
    }
    this.network = packet -> network.send(ByteBuffer.wrap(packet), target);
    this.loopback =
        multicast ? packet -> loopback.send(ByteBuffer.wrap(packet), target) : this.network;
    nanos = System::nanoTime;
  }

  VisionSender(Way network, Way loopback, LongSupplier nanos) {
    this.network = network;
    this.loopback = loopback;
    this.nanos = nanos;
    channels = () -> {};
  }

  private static void toGroup(DatagramChannel channel) throws IOException {
    channel.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
    channel.setOption(StandardSocketOptions.IP_MULTICAST_TTL, 1);
  }

  void send(byte[] packet) {
    if (!onLoopback || nanos.getAsLong() - failedAt >= TRY_AGAIN) {
      onLoopback = !isSent(network, packet);
      if (!onLoopback) {
        return;
      }
      failedAt = nanos.getAsLong();
    }
    if (!isSent(loopback, packet)) {
      lost++;
    }
  }

  private static boolean isSent(Way way, byte[] packet) {
    try {
      way.send(packet);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Packets that could not be sent. */
  long lost() {
    return lost;
  }

  @Override
  public void close() throws IOException {
    channels.close();
  }
}
