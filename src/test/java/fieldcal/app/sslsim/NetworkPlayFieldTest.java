package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import java.io.IOException;
import java.net.DatagramSocket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The play over real sockets on loopback, against the served field. */
class NetworkPlayFieldTest {
  @TempDir Path directory;

  /** Three free ports in a row. */
  private static SimulatorPorts freePorts() throws IOException {
    for (int attempt = 0; attempt < 50; attempt++) {
      int port = freePort();
      try (DatagramSocket a = new DatagramSocket(port);
          DatagramSocket b = new DatagramSocket(port + 1);
          DatagramSocket c = new DatagramSocket(port + 2)) {
        assertThat(a.isBound() && b.isBound() && c.isBound()).isTrue();
        return new SimulatorPorts(port);
      } catch (IOException | IllegalArgumentException taken) {
        // Somebody else has one of them.
        continue;
      }
    }
    throw new IOException("no three free ports");
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  @ParameterizedTest
  @CsvSource({"0,0", "0.05,0.05"})
  void theServedFieldIsPlayedOnLikeTheEmbeddedOne(double loss, double delay) throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 1).withChoice(false, 6).into(directory);
    InteractiveField served =
        ServedField.now(
            SimulationSettings.DEFAULT.withSeed(6),
            request.first(),
            request.second(),
            List.of(),
            System.currentTimeMillis() * 1_000_000L);
    SimulatorPorts ports = freePorts();
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    AtomicBoolean stop = new AtomicBoolean();
    try (SimulatorServer server =
        new SimulatorServer(served, ports, vision.address(), new Impairment(loss, delay), 1)) {
      CompletableFuture<Void> serving =
          CompletableFuture.runAsync(
              () -> {
                try {
                  server.serve(stop::get);
                } catch (IOException e) {
                  throw new AssertionError(e);
                }
              });
      NetworkPlayField field = new NetworkPlayField("127.0.0.1", ports, vision, Optional.empty());
      PlaySession.Outcome outcome = new PlaySession(request, field, s -> {}).run();
      stop.set(true);
      serving.get(5, TimeUnit.SECONDS);

      assertThat(outcome.last().state().waiting()).isEmpty();
      assertThat(outcome.complete()).isTrue();
      assertThat(outcome.last().kicks().get(0).speed()).isCloseTo(4.25, within(0.4));
      assertThat(outcome.last().model().get("kSwitch").mean()).isCloseTo(0.65, within(0.02));
      assertThat(field.notes()).noneMatch(n -> n.startsWith("simulator:"));
    }
  }

  @Test
  void aTakenPortAndAnUnknownHostAreSaidInOneLine() throws Exception {
    SimulatorPorts ports = freePorts();
    try (DatagramSocket taken = new DatagramSocket(ports.blue())) {
      assertThat(taken.isBound()).isTrue();
      SessionRequest r = SessionRequest.of(KickKind.FLAT, 1);
      InteractiveField field =
          InteractiveField.of(SimulationSettings.DEFAULT, r.first(), r.second(), List.of());
      NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
      assertThatThrownBy(
              () -> new SimulatorServer(field, ports, vision.address(), Impairment.NONE, 1))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("port " + ports.blue());
    }
    assertThatThrownBy(() -> new SimulatorClient("no host", SimulatorPorts.LEAGUE))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("no host");
    assertThatThrownBy(() -> new SimulatorPorts(70000))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Impairment(2, 0)).isInstanceOf(IllegalArgumentException.class);
  }
}
