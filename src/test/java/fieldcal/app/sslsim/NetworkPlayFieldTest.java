package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.calibration.Average;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RefereeState;
import fieldcal.kick.KickKind;
import fieldcal.proto.Referee;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The play over real sockets on loopback, against the served field. */
class NetworkPlayFieldTest {
  private static final int KICKS = 2;

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
        SessionRequest.of(KickKind.FLAT, KICKS).withChoice(false, 6).into(directory);
    InteractiveField served =
        ServedField.now(
            SimulationSettings.DEFAULT.withSeed(6),
            request.first(),
            request.second(),
            List.of(),
            System.currentTimeMillis() * 1_000_000L);
    SimulatorPorts ports = freePorts();
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    NetworkPlace referee = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
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
      CompletableFuture<Void> refereeing = CompletableFuture.runAsync(() -> send(referee, stop));
      NetworkPlayField field =
          new NetworkPlayField("127.0.0.1", ports, vision, Optional.of(referee));
      PlaySession.Outcome outcome = new PlaySession(request, field, s -> {}).run();
      stop.set(true);
      serving.get(5, TimeUnit.SECONDS);
      refereeing.get(5, TimeUnit.SECONDS);

      assertThat(outcome.last().state().waiting()).isEmpty();
      assertThat(outcome.complete()).isTrue();
      assertSame(outcome.last().model(), inProcess().last().model());
      assertThat(recordedCommands(outcome.log().orElseThrow()))
          .contains(Referee.Command.NORMAL_START);
      assertThat(field.notes()).noneMatch(n -> n.startsWith("simulator:"));
    }
  }

  /** Every parameter is the same, as far as kicks can tell that do not roll in the same detections. */
  private static void assertSame(Map<String, Average> network, Map<String, Average> inProcess) {
    assertThat(network).hasSize(3).containsOnlyKeys(inProcess.keySet());
    inProcess.forEach(
        (name, here) -> {
          Average there = network.get(name);
          double error = Math.hypot(here.standardError(), there.standardError());
          System.out.printf(
              Locale.ROOT,
              "%-9s in process %9.5f, over UDP %9.5f: %+.1f combined standard errors%n",
              name,
              here.mean(),
              there.mean(),
              (there.mean() - here.mean()) / error);
          assertThat(there.mean()).as(name).isCloseTo(here.mean(), within(4 * error));
        });
  }

  private static PlaySession.Outcome inProcess() throws IOException {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, KICKS).withChoice(false, 6);
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(6), request.first(), request.second(), List.of());
    return new PlaySession(request, new EmbeddedPlayField(field, Double.POSITIVE_INFINITY), s -> {})
        .run();
  }

  /** A referee who lets everybody play, ten times a second. */
  private static void send(NetworkPlace to, AtomicBoolean stop) {
    byte[] message =
        Referee.newBuilder()
            .setPacketTimestamp(1)
            .setStage(Referee.Stage.NORMAL_FIRST_HALF)
            .setCommand(Referee.Command.NORMAL_START)
            .setCommandCounter(1)
            .setCommandTimestamp(1)
            .setYellow(team())
            .setBlue(team())
            .build()
            .toByteArray();
    try (DatagramSocket socket = new DatagramSocket()) {
      while (!stop.get()) {
        socket.send(new DatagramPacket(message, message.length, to.address()));
        Thread.sleep(100);
      }
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static Referee.TeamInfo team() {
    return Referee.TeamInfo.newBuilder()
        .setName("")
        .setScore(0)
        .setRedCards(0)
        .setYellowCards(0)
        .setTimeouts(0)
        .setTimeoutTime(0)
        .setGoalkeeper(0)
        .build();
  }

  private static Set<Referee.Command> recordedCommands(Path log) throws IOException {
    Set<Referee.Command> commands = EnumSet.noneOf(Referee.Command.class);
    try (RecordingReader reader = RecordingReader.open(log)) {
      reader.read(
          new RecordingListener() {
            @Override
            public void onReferee(RefereeState state, double receivedTime) {
              commands.add(state.command());
            }
          });
    }
    return commands;
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
