package fieldcal.app.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.InstanceOfAssertFactories.LONG;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.cli.Main;
import fieldcal.app.net.LoopbackSender;
import fieldcal.app.net.NetworkPlace;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingGap;
import fieldcal.proto.Referee;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** Vision and a referee on loopback sockets, recorded. */
@Timeout(120)
class NetworkRecorderTest {
  private static final Epoch EPOCH = Epoch.atSecondOf(1_800_000_000_000_000_000L);
  private static final int FRAMES = 40;

  @TempDir private Path folder;

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      return socket.getLocalPort();
    }
  }

  private static NetworkPlace place(int port) {
    return NetworkPlace.parse(LoopbackSender.GROUP + ":" + port, null);
  }

  private static byte[] frame(int number) {
    return frame(number, 0.01 * number);
  }

  private static byte[] frame(int number, double time) {
    VisionFrame frame =
        new VisionFrame(number % 2, number, time, time, Double.NaN, List.of(), List.of());
    return new VisionEncoder(EPOCH).encode(VisionPacket.of(frame));
  }

  private static byte[] geometry() {
    return new VisionEncoder(EPOCH)
        .encode(VisionPacket.of(FieldGeometry.of(12, 9, 1.8, 0.18, 0.3, List.of())));
  }

  private static byte[] halt() {
    return Referee.newBuilder()
        .setPacketTimestamp(1)
        .setStage(Referee.Stage.NORMAL_FIRST_HALF_PRE)
        .setCommand(Referee.Command.HALT)
        .setCommandCounter(1)
        .setCommandTimestamp(1)
        .setYellow(team())
        .setBlue(team())
        .build()
        .toByteArray();
  }

  private static Referee.TeamInfo team() {
    return Referee.TeamInfo.newBuilder()
        .setName("a")
        .setScore(0)
        .setRedCards(0)
        .setYellowCards(0)
        .setTimeouts(4)
        .setTimeoutTime(0)
        .setGoalkeeper(0)
        .build();
  }

  @ParameterizedTest
  @ValueSource(strings = {"kicks.log", "kicks.log.gz"})
  void whatIsSentIsInTheFileAsItWas(String name) throws Exception {
    int port = freePort();
    int refereePort = freePort();
    Path file = folder.resolve(name);
    List<byte[]> sent = new ArrayList<>();
    try (NetworkRecorder recorder =
            new NetworkRecorder(
                file, false, place(port), Optional.of(place(refereePort)), Clock.systemUTC());
        LoopbackSender vision = new LoopbackSender(port);
        LoopbackSender whistle = new LoopbackSender(refereePort)) {
      CompletableFuture<RecordStatus> running =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  return recorder.run(Double.POSITIVE_INFINITY, s -> {});
                } catch (IOException e) {
                  throw new IllegalStateException(e);
                }
              });
      vision.send(new byte[] {1, 2, 3}); // another protocol
      for (int i = 0; i < FRAMES; i++) {
        sent.add(i == 5 ? geometry() : frame(i));
        vision.send(sent.get(i));
        whistle.send(halt());
        Thread.sleep(2);
      }
      Thread.sleep(200);
      recorder.stop();
      RecordStatus last = running.get(60, TimeUnit.SECONDS);
      assertThat(last.frames()).isEqualTo(FRAMES - 1);
      assertThat(last.cameras()).containsExactlyInAnyOrder(0, 1);
      assertThat(last.geometry()).isTrue();
      assertThat(last.referee()).isEqualTo("HALT");
    }
    List<byte[]> written = new ArrayList<>();
    int referee = 0;
    try (GameLogReader log = GameLogReader.open(file)) {
      while (log.next()) {
        if (log.type() == MessageType.SSL_VISION_2014) {
          int from = log.payloadOffset();
          written.add(Arrays.copyOfRange(log.buffer(), from, from + log.payloadLength()));
        } else {
          assertThat(log.type()).isEqualTo(MessageType.SSL_REFBOX_2013);
          referee++;
        }
      }
      assertThat(log.problems().kinds()).isEmpty();
    }
    assertThat(written).usingElementComparator(Arrays::compare).isEqualTo(sent);
    assertThat(referee).isGreaterThan(FRAMES / 2);
  }

  /** The listener holds the recorder up for longer than its queue lasts. */
  @Test
  void framesThatWereLostAreMarked() throws Exception {
    int port = freePort();
    Path file = folder.resolve("busy.log");
    CompletableFuture<Void> sent = new CompletableFuture<>();
    try (NetworkRecorder recorder =
            new NetworkRecorder(file, false, place(port), Optional.empty(), Clock.systemUTC());
        LoopbackSender vision = new LoopbackSender(port)) {
      CompletableFuture<RecordStatus> running =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  return recorder.run(
                      60,
                      s -> {
                        if (s.frames() > 0) {
                          sent.join();
                        }
                      });
                } catch (IOException e) {
                  throw new IllegalStateException(e);
                }
              });
      long begin = System.nanoTime();
      for (int i = 0; i < 1000; i++) {
        vision.send(frame(i, 1e-9 * (System.nanoTime() - begin)));
        Thread.sleep(1);
      }
      sent.complete(null);
      for (int i = 1000; i < 1010; i++) {
        vision.send(frame(i, 1e-9 * (System.nanoTime() - begin)));
        Thread.sleep(2);
      }
      Thread.sleep(200);
      recorder.stop();
      running.get(60, TimeUnit.SECONDS);
    }
    int gaps = 0;
    try (GameLogReader log = GameLogReader.open(file)) {
      while (log.next()) {
        int from = log.payloadOffset();
        byte[] payload = Arrays.copyOfRange(log.buffer(), from, from + log.payloadLength());
        boolean mark = Arrays.equals(payload, RecordingGap.mark());
        gaps += mark ? 1 : 0;
        assertThat(log.type()).isEqualTo(mark ? MessageType.BLANK : MessageType.SSL_VISION_2014);
      }
    }
    assertThat(gaps).isEqualTo(1);
  }

  /** The listener holds the recorder up. */
  @Test
  void whatTheRefereeSaysHasTheTimeWhenItCame() throws Exception {
    int port = freePort();
    int refereePort = freePort();
    Path file = folder.resolve("busy.log");
    CompletableFuture<Void> held = new CompletableFuture<>();
    CompletableFuture<Void> released = new CompletableFuture<>();
    long said;
    try (NetworkRecorder recorder =
            new NetworkRecorder(
                file, false, place(port), Optional.of(place(refereePort)), Clock.systemUTC());
        LoopbackSender vision = new LoopbackSender(port);
        LoopbackSender whistle = new LoopbackSender(refereePort)) {
      CompletableFuture<RecordStatus> running =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  return recorder.run(
                      60,
                      s -> {
                        if (s.frames() > 0) {
                          held.complete(null);
                          released.join();
                        }
                      });
                } catch (IOException e) {
                  throw new IllegalStateException(e);
                }
              });
      while (!held.isDone()) {
        vision.send(frame(1));
        Thread.sleep(20);
      }
      said = System.currentTimeMillis();
      whistle.send(halt());
      Thread.sleep(2000);
      released.complete(null);
      Thread.sleep(200);
      recorder.stop();
      running.get(60, TimeUnit.SECONDS);
    }
    List<Long> times = new ArrayList<>();
    try (GameLogReader log = GameLogReader.open(file)) {
      while (log.next()) {
        if (log.type() == MessageType.SSL_REFBOX_2013) {
          times.add(log.receivedNanos() / 1_000_000);
        }
      }
    }
    assertThat(times).singleElement().asInstanceOf(LONG).isBetween(said - 1000, said + 1000);
  }

  @Test
  void silenceIsToldAndLeavesNoFile() throws IOException {
    int port = freePort();
    Path file = folder.resolve("silence.log.gz");
    Answer answer =
        run("--out=" + file, "--multicast=" + LoopbackSender.GROUP + ":" + port, "--seconds=0.3");
    assertThat(answer.exit).isEqualTo(1);
    assertThat(answer.err.strip().lines()).hasSize(1);
    assertThat(answer.err)
        .contains("no frame of vision was heard")
        .contains(LoopbackSender.GROUP + ":" + port)
        .contains("No file was written");
    assertThat(file).doesNotExist();
  }

  @Test
  void nothingIsOverwrittenUnasked() throws IOException {
    Path file = Files.writeString(folder.resolve("old.log"), "precious");
    String place = "--multicast=" + LoopbackSender.GROUP + ":" + freePort();
    Answer refused = run("--out=" + file, place, "--seconds=0.2");
    assertThat(refused.exit).isEqualTo(1);
    assertThat(refused.err).contains("exists already");
    // Silence is no reason to lose it, either.
    Answer silent = run("--out=" + file, place, "--seconds=0.2", "--overwrite");
    assertThat(silent.exit).isEqualTo(1);
    assertThat(file).hasContent("precious");
  }

  /** Records in place of a file while one packet is sent again and again. */
  private Answer overwriting(Path file, double seconds, byte[] packet) throws Exception {
    int port = freePort();
    try (LoopbackSender vision = new LoopbackSender(port)) {
      CompletableFuture<Answer> answer =
          CompletableFuture.supplyAsync(
              () ->
                  run(
                      "--out=" + file,
                      "--multicast=" + LoopbackSender.GROUP + ":" + port,
                      "--seconds=" + seconds,
                      "--overwrite"));
      while (!answer.isDone()) {
        vision.send(packet);
        Thread.sleep(10);
      }
      return answer.get();
    }
  }

  /** Some software publishes its geometry also where no camera runs. */
  @Test
  void geometryAloneOverwritesNothing() throws Exception {
    Path file = Files.writeString(folder.resolve("old.log"), "precious");
    assertThat(overwriting(file, 0.5, geometry()).err).contains("old.log is as it was");
    assertThat(file).hasContent("precious");
  }

  @Test
  void anOverwrittenFileIsARecordingAfterwards() throws Exception {
    Path file = Files.writeString(folder.resolve("old.log"), "worthless");
    Answer answer = overwriting(file, 1.5, frame(1));
    assertThat(answer.exit).as(answer.err).isZero();
    assertThat(answer.out).contains("frames of camera 1");
    try (GameLogReader log = GameLogReader.open(file)) {
      assertThat(log.next()).isTrue();
    }
  }

  @Test
  void aFullDiskIsOneError() throws Exception {
    int port = freePort();
    Path full = Path.of("/dev/full");
    org.junit.jupiter.api.Assumptions.assumeTrue(Files.exists(full));
    Path link = Files.createSymbolicLink(folder.resolve("full.log"), full);
    try (NetworkRecorder recorder =
            new NetworkRecorder(link, true, place(port), Optional.empty(), Clock.systemUTC());
        LoopbackSender vision = new LoopbackSender(port)) {
      CompletableFuture<Void> sending =
          CompletableFuture.runAsync(
              () -> {
                try {
                  for (int i = 0; i < 400; i++) {
                    vision.send(frame(i));
                    Thread.sleep(10);
                  }
                } catch (IOException | InterruptedException e) {
                  throw new IllegalStateException(e);
                }
              });
      assertThatThrownBy(() -> recorder.run(30, s -> {}))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("full.log")
          .hasMessageContaining("No space left");
      sending.cancel(true);
    }
  }

  @Test
  void aFolderThatIsNotThereIsToldBeforeAnythingIsHeard() {
    Path file = folder.resolve("missing").resolve("kicks.log");
    assertThatThrownBy(
            () ->
                new NetworkRecorder(file, false, place(10006), Optional.empty(), Clock.systemUTC()))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("there is no folder");
  }

  @ParameterizedTest
  @ValueSource(strings = {"kicks.txt", "kicks", "kicks.gz"})
  void otherNamesAreBadUsage(String name) {
    Answer answer = run("--out=" + folder.resolve(name), "--seconds=0.1");
    assertThat(answer.exit).isEqualTo(2);
    assertThat(answer.err).contains("must end with .log or .log.gz");
  }

  private record Answer(int exit, String out, String err) {}

  private static Answer run(String... options) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    List<String> args = new ArrayList<>(List.of("record"));
    args.addAll(List.of(options));
    int exit = commands.execute(args.toArray(String[]::new));
    return new Answer(exit, out.toString(), err.toString());
  }
}
