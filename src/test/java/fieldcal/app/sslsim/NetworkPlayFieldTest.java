package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.calibration.Average;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RefereeState;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayLimits;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.proto.Referee;
import fieldcal.proto.SSL_DetectionFrame;
import fieldcal.proto.SSL_DetectionRobot;
import fieldcal.proto.SSL_WrapperPacket;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.channels.DatagramChannel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The play over real sockets on loopback, against the served field. */
class NetworkPlayFieldTest {
  /** A thread for each: the common pool of a small machine has one, which on Java 25 runs one task after the other. */
  private static final Executor THREADS = task -> new Thread(task).start();

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

  /** What is done while a field is served. */
  private interface Guest {
    void visit(NetworkPlayField field) throws Exception;
  }

  /** Serves a field, with a referee beside it who says in turn what he is told to say. */
  private static InteractiveField serve(
      Impairment impairment, Supplier<Referee.Command> says, Guest guest) throws Exception {
    InteractiveField served =
        ServedField.now(
            SimulationSettings.DEFAULT.withSeed(6),
            new RobotId(Team.YELLOW, 0),
            new RobotId(Team.YELLOW, 1),
            List.of(),
            System.currentTimeMillis() * 1_000_000L);
    SimulatorPorts ports = freePorts();
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    NetworkPlace referee = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    AtomicBoolean stop = new AtomicBoolean();
    try (SimulatorServer server =
        new SimulatorServer(served, ports, vision.address(), impairment, 1)) {
      CompletableFuture<Void> serving =
          CompletableFuture.runAsync(
              () -> {
                try {
                  server.serve(stop::get);
                } catch (IOException e) {
                  throw new AssertionError(e);
                }
              },
              THREADS);
      CompletableFuture<Void> refereeing =
          CompletableFuture.runAsync(() -> send(referee, says, stop), THREADS);
      try {
        guest.visit(new NetworkPlayField("127.0.0.1", ports, vision, Optional.of(referee)));
      } finally {
        stop.set(true);
        serving.get(5, TimeUnit.SECONDS);
        refereeing.get(5, TimeUnit.SECONDS);
      }
    }
    return served;
  }

  @ParameterizedTest
  @CsvSource({"0,0", "0.05,0.05"})
  void theServedFieldIsPlayedOnLikeTheEmbeddedOne(double loss, double delay) throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, KICKS).withChoice(false, 6).into(directory);
    serve(
        new Impairment(loss, delay),
        () -> Referee.Command.NORMAL_START,
        field -> {
          PlaySession.Outcome outcome = new PlaySession(request, field, s -> {}).run();
          assertThat(outcome.last().state().waiting()).isEmpty();
          assertThat(outcome.complete()).isTrue();
          assertSame(outcome.last().model(), inProcess().last().model());
          assertThat(recordedCommands(outcome.log().orElseThrow()))
              .contains(Referee.Command.NORMAL_START);
          // Silences and jumps of vision's clock are those of a machine that has other things to
          // do.
          assertThat(field.complaints())
              .filteredOn(complaint -> !complaint.startsWith("vision"))
              .isEmpty();
        });
  }

  @Test
  void aHaltIsObeyedAndAnAbortLeavesStandingRobotsAndAWholeRecording() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 12).into(directory);
    AtomicReference<Referee.Command> said = new AtomicReference<>(Referee.Command.HALT);
    List<Double> speedsInHalt = new ArrayList<>();
    PlaySession[] session = new PlaySession[1];
    InteractiveField served =
        serve(
            Impairment.NONE,
            said::get,
            field -> {
              session[0] =
                  new PlaySession(
                      request,
                      field,
                      s -> {
                        double fastest =
                            s.world().robots().stream().mapToDouble(Robot::speed).max().orElse(0);
                        if (s.state().waiting().equals(Optional.of("referee: HALT"))) {
                          speedsInHalt.add(fastest);
                        }
                        if (s.time() > 1) {
                          said.set(Referee.Command.NORMAL_START);
                        }
                        if (fastest > 1) {
                          session[0].abort("enough");
                        }
                      });
              PlaySession.Outcome outcome = session[0].run();
              assertThat(outcome.last().state().waiting()).contains("enough");
              assertThat(recordedCommands(outcome.log().orElseThrow()))
                  .contains(Referee.Command.HALT, Referee.Command.NORMAL_START);
            });
    assertThat(session[0].awaitEnd(0)).isTrue();
    assertThat(speedsInHalt).isNotEmpty().allMatch(speed -> speed < 0.2);
    // It is served no longer than they took to brake: nobody else has stopped them.
    assertThat(served.world().robots()).allMatch(robot -> robot.speed() < 0.3);
  }

  @Test
  void whatTheSimulatorComplainsOfIsToldAtOnce() throws Exception {
    RobotId missing = new RobotId(Team.BLUE, 9);
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 1)
            .withRobots(new RobotId(Team.YELLOW, 0), missing)
            .withLimits(PlayLimits.DEFAULT.withPatience(1, 1), Optional.empty());
    List<String> toldMeanwhile = new ArrayList<>();
    serve(
        Impairment.NONE,
        () -> Referee.Command.NORMAL_START,
        field -> {
          PlaySession.Outcome outcome =
              new PlaySession(request, field, s -> toldMeanwhile.addAll(field.complaints())).run();
          assertThat(outcome.complete()).isFalse();
          assertThat(outcome.last().state().waiting().orElseThrow()).contains(missing + " is not");
        });
    // A busy machine may let vision fall silent, too.
    assertThat(toldMeanwhile.stream().filter(told -> !told.startsWith("vision")))
        .containsOnly("simulator: there is no robot blue 9 (NO_ROBOT)");
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

  /** A referee, ten times a second. */
  private static void send(NetworkPlace to, Supplier<Referee.Command> says, AtomicBoolean stop) {
    try (DatagramSocket socket = new DatagramSocket()) {
      while (!stop.get()) {
        byte[] message = message(says.get());
        socket.send(new DatagramPacket(message, message.length, to.address()));
        Thread.sleep(100);
      }
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static byte[] message(Referee.Command command) {
    return Referee.newBuilder()
        .setPacketTimestamp(1)
        .setStage(Referee.Stage.NORMAL_FIRST_HALF)
        .setCommand(command)
        .setCommandCounter(1)
        .setCommandTimestamp(1)
        .setYellow(team())
        .setBlue(team())
        .build()
        .toByteArray();
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
  void aVisionWhoseClockGoesBackEndsTheSession() throws Exception {
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    List<Double> heard = new ArrayList<>();
    try (NetworkPlayField field =
            new NetworkPlayField("127.0.0.1", freePorts(), vision, Optional.empty());
        DatagramSocket socket = new DatagramSocket()) {
      PlayField.Receiver receiver =
          (time, packet, payload) -> packet.frame().ifPresent(f -> heard.add(f.captureTime()));
      VisionEncoder encoder = new VisionEncoder(field.epoch());
      // Two frames, a restart, and a frame of the new clock that looks like one of the old.
      for (double time : new double[] {100, 100.5, 3.5, 100.75}) {
        assertThat(field.over().isPresent()).isEqualTo(heard.size() == 2 && time > 100.6);
        VisionFrame frame = new VisionFrame(0, 1, time, time, Double.NaN, List.of(), List.of());
        byte[] packet = encoder.encode(VisionPacket.of(frame));
        socket.send(new DatagramPacket(packet, packet.length, vision.address()));
        for (int i = 0; i < 200 && heard.size() < 2 || i < 20; i++) {
          field.next(receiver);
          if (!heard.isEmpty() && heard.get(heard.size() - 1) == time) {
            break;
          }
        }
      }
      assertThat(field.over().orElseThrow()).contains("went back by 97 s");
    }
    assertThat(heard).containsExactly(100.0, 100.5);
  }

  /** Sends one frame, and waits until it is heard. */
  private static void hearOneFrame(NetworkPlayField field, NetworkPlace vision) throws IOException {
    VisionFrame frame = new VisionFrame(0, 1, 5, 5, Double.NaN, List.of(), List.of());
    hear(field, vision, new VisionEncoder(field.epoch()).encode(VisionPacket.of(frame)));
  }

  /** Sends one packet, and waits until it is heard; returns the bytes that are given to whoever records. */
  private static byte[] hear(NetworkPlayField field, NetworkPlace vision, byte[] packet)
      throws IOException {
    AtomicReference<byte[]> heard = new AtomicReference<>();
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.send(new DatagramPacket(packet, packet.length, vision.address()));
    }
    for (int i = 0; i < 200 && heard.get() == null; i++) {
      field.next((time, received, payload) -> heard.set(payload));
    }
    assertThat(heard).doesNotHaveNullValue();
    return heard.get();
  }

  /** Who gave a HALT relies on it, also when the game controller has crashed since. */
  @Test
  void aRefereeThatFallsSilentStopsTheRobotsAndItsHaltStays() throws Exception {
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    NetworkPlace referee = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    try (NetworkPlayField field =
            new NetworkPlayField("127.0.0.1", freePorts(), vision, Optional.of(referee));
        DatagramSocket socket = new DatagramSocket()) {
      assertThat(field.permission()).isEqualTo(Permission.RUN);
      assertThat(field.hold()).isEmpty();
      Map<Referee.Command, Permission> allowed = new LinkedHashMap<>();
      allowed.put(Referee.Command.HALT, Permission.HALT);
      allowed.put(Referee.Command.NORMAL_START, Permission.RUN);
      for (Map.Entry<Referee.Command, Permission> said : allowed.entrySet()) {
        byte[] message = message(said.getKey());
        socket.send(new DatagramPacket(message, message.length, referee.address()));
        for (int i = 0; i < 200 && field.permission() != said.getValue() || i < 20; i++) {
          field.next((time, packet, payload) -> {});
        }
        assertThat(field.permission()).isEqualTo(said.getValue());
        assertThat(field.hold()).isEmpty();
        Thread.sleep(2100);
        assertThat(field.permission()).isEqualTo(said.getValue());
        assertThat(field.hold().orElseThrow()).startsWith("no message from the referee");
      }
      assertThat(field.hold()).contains("no message from the referee");
    }
  }

  /** A simulator's clock may begin at 0, far behind this machine's. */
  @ParameterizedTest
  @ValueSource(doubles = {-1000, 1000})
  void timeGoesOnByVisionsClockWhateverItSays(double captured) throws Exception {
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    try (NetworkPlayField field =
        new NetworkPlayField("127.0.0.1", freePorts(), vision, Optional.empty())) {
      double before = field.next((time, packet, payload) -> {}) - field.clockJumps();
      VisionFrame frame =
          new VisionFrame(0, 1, captured, captured, Double.NaN, List.of(), List.of());
      hear(field, vision, new VisionEncoder(field.epoch()).encode(VisionPacket.of(frame)));
      double heard = field.next((time, packet, payload) -> {});
      assertThat(heard).isBetween(captured, captured + 10);
      assertThat(heard - field.clockJumps() - before).isBetween(0.0, 10.0);
      assertThat(field.next((time, packet, payload) -> {})).isGreaterThan(heard);
    }
  }

  /** What fieldcal does not know of is recorded, too, and nothing is added. */
  @Test
  void thePacketsAreGivenAsVisionSentThem() throws Exception {
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    byte[] sent =
        SSL_WrapperPacket.newBuilder()
            .setDetection(
                SSL_DetectionFrame.newBuilder()
                    .setFrameNumber(1)
                    .setTCapture(5)
                    .setTSent(5)
                    .setCameraId(0)
                    .addRobotsBlue(
                        SSL_DetectionRobot.newBuilder()
                            .setConfidence(1)
                            .setRobotId(3)
                            .setX(100)
                            .setY(200)
                            .setPixelX(300)
                            .setPixelY(400)))
            .build()
            .toByteArray();
    try (NetworkPlayField field =
        new NetworkPlayField("127.0.0.1", freePorts(), vision, Optional.empty())) {
      assertThat(hear(field, vision, sent)).containsExactly(sent);
    }
  }

  /** A calibration after the play takes seconds, in which nobody listens. */
  @Test
  void theTimeAfterThePlayIsNoSilenceOfVision() throws Exception {
    NetworkPlace one = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    NetworkPlace other = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    try (NetworkPlayField playing =
            new NetworkPlayField("127.0.0.1", freePorts(), one, Optional.empty());
        NetworkPlayField ended =
            new NetworkPlayField("127.0.0.1", freePorts(), other, Optional.empty())) {
      hearOneFrame(playing, one);
      hearOneFrame(ended, other);
      PlayField over = ended;
      over.close();
      Thread.sleep(2100);
      assertThat(String.join("\n", playing.notes())).contains("Nothing was received for 2 s");
      assertThat(String.join("\n", ended.notes()))
          .contains("vision: 1 packets, 0 dropped")
          .doesNotContain("Nothing was received");
    }
  }

  @Test
  void aReplyThatCannotBeSentIsCountedAndEndsNothing() throws Exception {
    SessionRequest r = SessionRequest.of(KickKind.FLAT, 1);
    InteractiveField field =
        InteractiveField.of(SimulationSettings.DEFAULT, r.first(), r.second(), List.of());
    NetworkPlace vision = NetworkPlace.parse("127.0.0.1:" + freePort(), null);
    try (SimulatorServer server =
            new SimulatorServer(field, freePorts(), vision.address(), Impairment.NONE, 1);
        DatagramChannel channel = DatagramChannel.open()) {
      byte[] longerThanAnyPacket = new byte[70_000];
      server.reply(channel, longerThanAnyPacket, vision.address());
      assertThat(server.lost()).isEqualTo(1);
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
