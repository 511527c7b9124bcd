package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.SimulatorError;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A simulator or a bridge that answers too often, too much or in endlessly new words. */
class EndlessAnswersTest {
  private static final int MORE_THAN_ARE_KEPT = 3 * Complaints.MOST;

  /** What commands can go to. */
  private enum Kind {
    SIMULATOR,
    BRIDGE
  }

  /** The other side: what it sends lies in the client's buffer when {@code send} returns, since both are on loopback. */
  private static final class Other implements AutoCloseable {
    private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    private SocketAddress client;

    Other() throws IOException {
      socket.setSoTimeout(5000);
    }

    int port() {
      return socket.getLocalPort();
    }

    void hear() throws IOException {
      DatagramPacket command = new DatagramPacket(new byte[4096], 4096);
      socket.receive(command);
      client = command.getSocketAddress();
    }

    void answer(byte[] bytes) {
      try {
        socket.send(new DatagramPacket(bytes, bytes.length, client));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    @Override
    public void close() {
      socket.close();
    }
  }

  private static byte[] complaint(String text) {
    SimulatorError error = SimulatorError.newBuilder().setCode("WRONG").setMessage(text).build();
    return RobotControlResponse.newBuilder().addErrors(error).build().toByteArray();
  }

  @Test
  void whoeverAnswersEachReadingWithAnotherAnswerIsReadOnlySoFar() throws IOException {
    AtomicInteger read = new AtomicInteger();
    try (Other other = new Other();
        CommandChannel channel =
            new CommandChannel(InetAddress.getLoopbackAddress(), other.port())) {
      channel.send(new byte[1]);
      other.hear();
      other.answer(new byte[1]);
      channel.answers(
          answer -> {
            assertThat(read.incrementAndGet()).isLessThanOrEqualTo(CommandChannel.MOST_ANSWERS);
            other.answer(answer);
          });
    }
    assertThat(read).hasValue(CommandChannel.MOST_ANSWERS);
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void complaintsAreKeptUpToANumberAndALength(Kind kind) throws IOException {
    RobotId robot = new RobotId(Team.BLUE, 0);
    try (Other other = new Other();
        RobotLink link =
            kind == Kind.SIMULATOR
                // The blue robots' port is the control port's successor.
                ? new SimulatorClient("127.0.0.1", new SimulatorPorts(other.port() - 1))
                : new BridgeClient("127.0.0.1", other.port(), robot, robot, System::nanoTime)) {
      link.robots(Team.BLUE, List.of());
      link.robots(Team.BLUE, List.of(SimulatorClient.command(0, 0, 0, 0, 0, 0, false)));
      other.hear();
      for (int i = 0; i < MORE_THAN_ARE_KEPT; i++) {
        other.answer(complaint("error " + i + " " + "x".repeat(10_000)));
        link.listen();
      }
      assertThat(link.complaints()).hasSize(Complaints.MOST);
      assertThat(link.notes()).hasSize(Complaints.MOST);
      assertThat(link.complaints())
          .allSatisfy(text -> assertThat(text).hasSizeLessThan(Complaints.LONGEST + 20));
    }
  }
}
