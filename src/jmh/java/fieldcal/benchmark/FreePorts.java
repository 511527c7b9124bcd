package fieldcal.benchmark;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.SocketException;

/** UDP ports of this machine that nobody uses right now. */
final class FreePorts {
  private static final int ATTEMPTS = 50;

  private FreePorts() {}

  static int one() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  /** The first of three in a row. */
  static int threeInARow() throws IOException {
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      int first = one();
      if (first + 2 < 65536 && isFree(first) && isFree(first + 1) && isFree(first + 2)) {
        return first;
      }
    }
    throw new IOException("found no three free ports in a row");
  }

  private static boolean isFree(int port) {
    try (DatagramSocket socket = new DatagramSocket(port)) {
      return socket.isBound();
    } catch (SocketException taken) {
      return false;
    }
  }
}
