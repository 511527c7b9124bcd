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

/** Sends vision's packets to a multicast group, to all by broadcast, or to one address. A machine without a network sends to itself. */
final class VisionSender implements Closeable {
  private final InetSocketAddress target;
  private final DatagramChannel channel;
  private boolean onLoopback;

  VisionSender(InetSocketAddress target) throws IOException {
    this.target = target;
    channel = DatagramChannel.open(StandardProtocolFamily.INET);
    // Nothing where the address is none of a broadcast.
    channel.setOption(StandardSocketOptions.SO_BROADCAST, true);
    if (target.getAddress().isMulticastAddress()) {
      channel.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
      channel.setOption(StandardSocketOptions.IP_MULTICAST_TTL, 1);
    }
  }

  void send(byte[] packet) throws IOException {
    try {
      channel.send(ByteBuffer.wrap(packet), target);
    } catch (IOException e) {
      if (onLoopback || !target.getAddress().isMulticastAddress()) {
        throw new IOException("vision cannot be sent to " + target + ": " + e.getMessage(), e);
      }
      useLoopback();
      channel.send(ByteBuffer.wrap(packet), target);
    }
  }

  private void useLoopback() throws IOException {
    onLoopback = true;
    for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      if (one.isLoopback() && one.isUp()) {
        channel.setOption(StandardSocketOptions.IP_MULTICAST_IF, one);
      }
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
