package fieldcal.app.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;

/** Sends packets to a group on the loopback interface, as a vision computer does on a field's network. */
public final class LoopbackSender implements AutoCloseable {
  /** A group that no program of the league uses. */
  public static final String GROUP = "224.5.23.177";

  private final DatagramChannel channel;
  private final InetSocketAddress group;

  /**
   * A sender with a port of its own.
   *
   * @param port of the group
   * @throws IOException when there is no loopback
   */
  public LoopbackSender(int port) throws IOException {
    InetAddress loopback = InetAddress.getLoopbackAddress();
    channel = DatagramChannel.open(StandardProtocolFamily.INET);
    channel.bind(new InetSocketAddress(loopback, 0));
    channel.setOption(
        StandardSocketOptions.IP_MULTICAST_IF, NetworkInterface.getByInetAddress(loopback));
    channel.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
    group = new InetSocketAddress(InetAddress.getByName(GROUP), port);
  }

  /**
   * Sends a packet.
   *
   * @param data its bytes
   * @throws IOException when the machine refuses
   */
  public void send(byte[] data) throws IOException {
    channel.send(ByteBuffer.wrap(data), group);
  }

  /**
   * The sender's own address.
   *
   * @return with its port
   * @throws IOException when it is closed
   */
  public InetSocketAddress address() throws IOException {
    return (InetSocketAddress) channel.getLocalAddress();
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
