package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.vision.Team;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A simulator that answers at first, and then no longer. */
class SilentSimulatorTest {
  @Test
  void aSimulatorThatStopsAnsweringIsNamed() throws IOException {
    try (DatagramSocket simulator = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        // The blue robots' port is the control port's successor.
        SimulatorClient client =
            new SimulatorClient("127.0.0.1", new SimulatorPorts(simulator.getLocalPort() - 1))) {
      simulator.setSoTimeout(5000);
      for (int silence = 0; silence < 2; silence++) {
        client.robots(Team.BLUE, List.of(SimulatorClient.command(0, 0, 0, 0, 0, 0, false)));
        DatagramPacket command = new DatagramPacket(new byte[4096], 4096);
        simulator.receive(command);
        simulator.send(
            new DatagramPacket(new byte[] {0x12, 2, 8, 0}, 4, command.getSocketAddress()));
        client.listen();
        assertThat(client.complaints()).hasSize(silence);
        for (int i = 0; i < 200; i++) {
          client.robots(Team.BLUE, List.of());
        }
      }
      assertThat(client.complaints()).hasSize(1);
      assertThat(client.complaints().get(0)).endsWith("stopped answering");
      assertThat(client.notes().get(0)).endsWith("stopped answering, 2 times");
    }
  }
}
