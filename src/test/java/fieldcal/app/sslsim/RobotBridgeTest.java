package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayLimits;
import fieldcal.proto.RobotCommand;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Real robots behind a bridge, on loopback: the bridge passes commands on to a served field, as a team's would to its radio. */
class RobotBridgeTest {
  private static final RobotId FIRST = new RobotId(Team.YELLOW, 0);
  private static final RobotId SECOND = new RobotId(Team.YELLOW, 1);

  /** A thread for each: the common pool of a small machine has one, which on Java 25 runs one task after the other. */
  private static final Executor THREADS = task -> new Thread(task).start();

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  /** A field of robots with a bridge before it; both can fall silent. */
  private static final class Robots implements AutoCloseable {
    final InteractiveField field =
        ServedField.now(
            SimulationSettings.DEFAULT.withSeed(6),
            FIRST,
            SECOND,
            List.of(),
            System.currentTimeMillis() * 1_000_000L);
    final NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    final AtomicBoolean stop = new AtomicBoolean();
    final AtomicBoolean bridgeSilent = new AtomicBoolean();
    final AtomicBoolean visionSilent = new AtomicBoolean();
    final AtomicInteger heard = new AtomicInteger();
    final DatagramSocket bridge = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    private final CompletableFuture<Void> serving;
    private final CompletableFuture<Void> bridging;

    Robots() throws IOException {
      SimulatorProtocol protocol = new SimulatorProtocol(field);
      serving = CompletableFuture.runAsync(() -> run(protocol), THREADS);
      bridging = CompletableFuture.runAsync(() -> pass(protocol), THREADS);
    }

    private void run(SimulatorProtocol protocol) {
      fieldcal.vision.VisionEncoder encoder = new fieldcal.vision.VisionEncoder(field.epoch());
      try (VisionSender sender = new VisionSender(vision.address())) {
        long begin = System.nanoTime();
        while (!stop.get()) {
          synchronized (field) {
            while (field.world().time() < (System.nanoTime() - begin) * 1e-9) {
              protocol.beforeStep();
              field.step(
                  p -> {
                    if (!visionSilent.get()) {
                      sender.send(encoder.encode(p.packet()));
                    }
                  });
            }
          }
          Thread.sleep(1);
        }
      } catch (IOException | InterruptedException e) {
        throw new AssertionError(e);
      }
    }

    private void pass(SimulatorProtocol protocol) {
      try {
        bridge.setSoTimeout(50);
        byte[] bytes = new byte[4096];
        while (!stop.get()) {
          DatagramPacket packet = new DatagramPacket(bytes, bytes.length);
          try {
            bridge.receive(packet);
          } catch (SocketTimeoutException e) {
            continue;
          }
          heard.incrementAndGet();
          byte[] answer;
          synchronized (field) {
            answer =
                protocol.robots(
                    Team.YELLOW, java.util.Arrays.copyOf(packet.getData(), packet.getLength()));
          }
          if (!bridgeSilent.get()) {
            bridge.send(new DatagramPacket(answer, answer.length, packet.getSocketAddress()));
          }
        }
      } catch (IOException e) {
        throw new AssertionError(e);
      }
    }

    NetworkPlayField play() throws IOException {
      return NetworkPlayField.ofRobots(
          "127.0.0.1:" + bridge.getLocalPort(), FIRST, SECOND, vision, Optional.empty());
    }

    /** The faster of the two, m/s. */
    double speed() {
      synchronized (field) {
        return field.world().robots().stream()
            .filter(r -> r.id().equals(FIRST) || r.id().equals(SECOND))
            .mapToDouble(SimulatedRobot::speed)
            .max()
            .orElseThrow();
      }
    }

    @Override
    public void close() {
      stop.set(true);
      assertThat(serving).succeedsWithin(5, TimeUnit.SECONDS);
      assertThat(bridging).succeedsWithin(5, TimeUnit.SECONDS);
      bridge.close();
    }
  }

  private static SessionRequest request(int kicks, double patience) {
    return SessionRequest.of(KickKind.FLAT, kicks)
        .withRobots(FIRST, SECOND)
        .withLimits(PlayLimits.DEFAULT.withPatience(patience, 120), Optional.empty());
  }

  @Test
  void aTeamsRobotsPlayByItsBridge() throws Exception {
    try (Robots robots = new Robots()) {
      PlaySession.Outcome outcome = new PlaySession(request(1, 60), robots.play(), s -> {}).run();
      assertThat(outcome.complete()).as(outcome.last().state().toString()).isTrue();
      assertThat(robots.heard.get()).isGreaterThan(300);
    }
  }

  /** Runs until the robots drive, silences something, and looks whether they stop although the commands still reach them. */
  private static void standWhenSilent(boolean bridge) throws Exception {
    try (Robots robots = new Robots()) {
      long[] silenced = new long[1];
      boolean[] drove = new boolean[1];
      boolean[] stood = new boolean[1];
      PlaySession session =
          new PlaySession(
              request(3, 1.5),
              robots.play(),
              s -> {
                double speed = robots.speed();
                long now = System.nanoTime();
                if (!drove[0] && speed > 0.8) {
                  drove[0] = true;
                  silenced[0] = now;
                  (bridge ? robots.bridgeSilent : robots.visionSilent).set(true);
                } else if (drove[0] && now - silenced[0] > 1_200_000_000L) {
                  stood[0] |= speed < 0.02;
                }
              });
      PlaySession.Outcome outcome = session.run();
      assertThat(drove[0]).isTrue();
      assertThat(stood[0]).isTrue();
      assertThat(outcome.complete()).isFalse();
      assertThat(outcome.last().state().waiting().orElseThrow())
          .contains(bridge ? "the bridge at 127.0.0.1" : "no vision");
      assertThat(robots.speed()).isLessThan(0.02);
    }
  }

  @Test
  void aBridgeThatFallsSilentStopsBothRobots() throws Exception {
    standWhenSilent(true);
  }

  @Test
  void aVisionThatFallsSilentStopsBothRobots() throws Exception {
    standWhenSilent(false);
  }

  @Test
  void whereABridgeIsMustBeSaid() {
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:10006", null);
    for (String wrong : List.of("localhost", ":10400", "localhost:many", "localhost:70000")) {
      assertThatThrownBy(
              () ->
                  NetworkPlayField.ofRobots(wrong, FIRST, SECOND, vision, Optional.empty()).close())
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("bridge");
    }
  }

  /** The documented bridge, run as it is, with a client that commands it. */
  private interface Visit {
    void of(Process example, int port, BridgeClient client, BufferedReader said) throws Exception;
  }

  private static Path example() {
    return Path.of(System.getProperty("fieldcal.projectDir", "."), "docs", "bridge.py");
  }

  private static void withTheExample(Visit visit) throws Exception {
    with(example(), visit);
  }

  private static void with(Path example, Visit visit) throws Exception {
    int port = freePort();
    Process process;
    try {
      process =
          new ProcessBuilder("python3", example.toString(), Integer.toString(port))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
    } catch (IOException e) {
      assumeTrue(false, "no python3 here");
      return;
    }
    try (BridgeClient client =
            new BridgeClient("127.0.0.1", port, FIRST, SECOND, System::nanoTime);
        BufferedReader said = new BufferedReader(new InputStreamReader(process.getInputStream()))) {
      assertThat(client.hold()).isPresent();
      visit.of(process, port, client, said);
    } finally {
      process.destroyForcibly();
    }
  }

  /** Commands robots until the example answers. */
  private static void command(BridgeClient client, int... robots) throws Exception {
    List<RobotCommand> commands =
        Arrays.stream(robots)
            .mapToObj(r -> SimulatorClient.command(r, 0.5, -0.25, 1.5, 4, Math.PI / 4, true))
            .toList();
    for (int i = 0; i < 500 && client.hold().isPresent(); i++) {
      client.robots(Team.YELLOW, commands);
      Thread.sleep(10);
      client.listen();
    }
    assertThat(client.hold()).isEmpty();
    assertThat(client.complaints()).isEmpty();
  }

  private static String stopOf(int robot, BufferedReader said) throws IOException {
    String line = said.readLine();
    while (line != null
        && !(line.startsWith("robot " + robot + ":") && line.contains("forward 0.000"))) {
      line = said.readLine();
    }
    return line;
  }

  @Test
  void theExampleUnderstandsWhatIsSentAndStopsByItself() throws Exception {
    withTheExample(
        (example, port, client, said) -> {
          command(client, 11);
          assertThat(said.readLine())
              .isEqualTo(
                  "robot 11: forward 0.500, left -0.250, angular 1.500, kick 4.000, angle 45.000,"
                      + " dribbler 3000.000");
          assertThat(stopOf(11, said)).contains("left 0.000", "angular 0.000", "kick 0.000");
          client.listen();
          Thread.sleep(350);
          assertThat(client.hold().orElseThrow()).contains("does not answer");
        });
  }

  /** Somebody else's packets, and commands for the other robot, keep no robot driving. */
  @Test
  void theExampleStopsARobotThatIsNotCommandedWhateverElseIsSent() throws Exception {
    withTheExample(
        (example, port, client, said) -> {
          command(client, 3, 11);
          CompletableFuture<String> stopped =
              CompletableFuture.supplyAsync(
                  () -> {
                    try {
                      return stopOf(11, said);
                    } catch (IOException e) {
                      throw new AssertionError(e);
                    }
                  },
                  THREADS);
          try (DatagramSocket stranger = new DatagramSocket()) {
            for (int i = 0; i < 200 && !stopped.isDone(); i++) {
              for (byte[] packet : new byte[][] {{}, {-1}, {10, 2, 8, 11}, {8, 1}, {13, 0, 0}}) {
                stranger.send(
                    new DatagramPacket(
                        packet, packet.length, InetAddress.getLoopbackAddress(), port));
              }
              client.robots(
                  Team.YELLOW, List.of(SimulatorClient.command(3, 0.5, 0, 0, 0, 0, false)));
              Thread.sleep(10);
              client.listen();
            }
          }
          assertThat(stopped).succeedsWithin(1, TimeUnit.SECONDS);
          // The other one is still commanded, and the bridge still answers.
          assertThat(client.hold()).isEmpty();
        });
  }

  /** A radio keeps the last command: whatever ends the bridge must stop the robots. */
  @ParameterizedTest
  @ValueSource(strings = {"-INT", "-TERM", "-HUP"})
  void theExampleStopsTheRobotsWhenItIsEnded(String signal) throws Exception {
    withTheExample(
        (example, port, client, said) -> {
          command(client, 3, 11);
          new ProcessBuilder("kill", signal, Long.toString(example.pid())).start().waitFor();
          assertThat(stopOf(3, said)).contains("kick 0.000");
          assertThat(stopOf(11, said)).contains("kick 0.000");
          assertThat(example.waitFor(5, TimeUnit.SECONDS)).isTrue();
        });
  }

  /** The example with a radio that fails as long as a file is there. */
  private static Path withBrokenRadio(Path directory, Path broken) throws IOException {
    String text = Files.readString(example());
    String radio = "    print(\"robot %d: \"";
    assertThat(text).contains(radio);
    String fails =
        "    import os\n    if os.path.exists('"
            + broken
            + "'):\n        raise OSError('radio: busy')\n";
    return Files.writeString(directory.resolve("bridge.py"), text.replace(radio, fails + radio));
  }

  /** A radio keeps the last command: robots that it could not stop are stopped as soon as it works again. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theExampleStopsTheRobotsWhenItsRadioWorksAgain(boolean ended, @TempDir Path directory)
      throws Exception {
    Path broken = directory.resolve("broken");
    with(
        withBrokenRadio(directory, broken),
        (example, port, client, said) -> {
          command(client, 3, 11);
          Files.createFile(broken);
          if (ended) {
            new ProcessBuilder("kill", Long.toString(example.pid())).start().waitFor();
          }
          Thread.sleep(600);
          assertThat(example.isAlive()).isTrue();
          Files.delete(broken);
          assertThat(stopOf(3, said)).contains("kick 0.000");
          assertThat(stopOf(11, said)).contains("kick 0.000");
          if (!ended) {
            // It goes on.
            Thread.sleep(350);
            command(client, 3);
          }
        });
  }
}
