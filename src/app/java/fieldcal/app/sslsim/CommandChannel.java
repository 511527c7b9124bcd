package fieldcal.app.sslsim;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Arrays;
import java.util.function.Consumer;

/** Sends commands to one port of a simulator or a bridge, and reads what that port answers. Never waits. Not thread-safe. */
final class CommandChannel implements Closeable {
  /** Answers that are read at once: each command has one, and who sends more must not keep the play from going on. */
  static final int MOST_ANSWERS = 1000;

  /** The largest packet of UDP, bytes. */
  private static final int LARGEST = 65_536;

  private final DatagramChannel channel;
  private final ByteBuffer buffer = ByteBuffer.allocate(LARGEST);

  CommandChannel(InetAddress host, int port) throws IOException {
    channel = DatagramChannel.open();
    channel.configureBlocking(false);
    channel.connect(new InetSocketAddress(host, port));
  }

  /** The address of a host; an error in words when there is none. */
  static InetAddress resolved(String host) throws IOException {
    try {
      return InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new IOException("'" + host + "' is not a known host", e);
    }
  }

  /** Sends a message; false when nobody listens there, who may be starting. */
  boolean send(byte[] message) throws IOException {
    try {
      channel.write(ByteBuffer.wrap(message));
      return true;
    } catch (PortUnreachableException e) {
      return false;
    }
  }

  /** Reads the answers that are there, up to {@link #MOST_ANSWERS}; false when nobody listens there. */
  boolean answers(Consumer<byte[]> to) throws IOException {
    try {
      for (int i = 0; i < MOST_ANSWERS; i++) {
        buffer.clear();
        if (channel.read(buffer) <= 0) {
          break;
        }
        to.accept(Arrays.copyOf(buffer.array(), buffer.position()));
      }
      return true;
    } catch (PortUnreachableException e) {
      return false;
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
