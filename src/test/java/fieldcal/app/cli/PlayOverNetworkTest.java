package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.ServedField;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.app.sslsim.SimulatorServer;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

/** What the terminal says of a play on a simulator of the network. */
class PlayOverNetworkTest {
  /** The simulator stands still so long, s: its vision is silent, and then its clock is late. */
  private static final double STALL = 0.9;

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  /** Three free ports in a row. */
  private static int freePorts() throws IOException {
    for (int attempt = 0; attempt < 50; attempt++) {
      int port = freePort();
      try (DatagramSocket second = new DatagramSocket(port + 1);
          DatagramSocket third = new DatagramSocket(port + 2)) {
        assertThat(second.isBound() && third.isBound()).isTrue();
        return port;
      } catch (IOException | IllegalArgumentException taken) {
        // Somebody else has one of them.
        continue;
      }
    }
    throw new IOException("no three free ports");
  }

  /** Asks to go on; stands still once, after some seconds. */
  private static boolean stall(long begin, AtomicBoolean stalled) {
    if (System.nanoTime() - begin > 3_000_000_000L && !stalled.getAndSet(true)) {
      try {
        Thread.sleep((long) (1000 * STALL));
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
    return false;
  }

  @Test
  void aStallOfTheSimulatorIsToldAsItHappens() throws Exception {
    InetSocketAddress vision = new InetSocketAddress(InetAddress.getLoopbackAddress(), freePort());
    int port = freePorts();
    StringWriter out = new StringWriter();
    AtomicBoolean stop = new AtomicBoolean();
    AtomicBoolean stalled = new AtomicBoolean();
    try (SimulatorServer server =
        new SimulatorServer(
            ServedField.now(
                SimulationSettings.DEFAULT.withSeed(6),
                new RobotId(Team.YELLOW, 0),
                new RobotId(Team.YELLOW, 1),
                List.of(),
                System.currentTimeMillis() * 1_000_000L),
            new SimulatorPorts(port),
            vision,
            Impairment.NONE,
            1)) {
      long begin = System.nanoTime();
      CompletableFuture<Void> serving =
          CompletableFuture.runAsync(
              () -> {
                try {
                  server.serve(() -> stop.get() || stall(begin, stalled));
                } catch (IOException e) {
                  throw new AssertionError(e);
                }
              },
              task -> new Thread(task).start());
      try {
        String line =
            "play --ssl-sim 127.0.0.1 --kind flat --kicks 2 --seed 6 --port "
                + port
                + " --vision 127.0.0.1:"
                + vision.getPort();
        assertThat(Main.commandLine().setOut(new PrintWriter(out)).execute(line.split(" ")))
            .isZero();
      } finally {
        stop.set(true);
        serving.get(5, TimeUnit.SECONDS);
      }
    }
    String said = out.toString();
    assertThat(said)
        .containsPattern("vision was silent for (0\\.9|1\\.\\d) s, \\d s after its first frame")
        .containsPattern("vision's clock jumped by -(0\\.[5-9]|1\\.)\\d* s")
        .containsPattern("vision: \\d+ silences and jumps of its clock")
        .doesNotContain("SILENT");
    // Not only at the end: before the second kick is made.
    assertThat(said.indexOf("vision was silent")).isLessThan(said.indexOf("  2  yellow"));
  }
}
