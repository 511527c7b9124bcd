package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.ServedField;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.app.sslsim.SimulatorServer;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.SimulatorError;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.ToIntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** What the terminal says of a play on a simulator of the network. */
class PlayOverNetworkTest {
  /** The simulator stands still so long, s: its vision is silent, and then its clock is late. */
  private static final double STALL = 0.9;

  @TempDir Path directory;

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

  /** What the terminal says of a play beside a simulator that stops when it is told to. */
  private static int play(String options, StringWriter out, StringWriter err, BooleanSupplier ends)
      throws Exception {
    int port = freePorts();
    return play(
        options,
        port,
        port,
        line ->
            Main.commandLine()
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(line),
        ends);
  }

  /** The same of a play whose commands may go elsewhere, to the first of three ports. */
  private static int play(
      String options, int port, int commands, ToIntFunction<String[]> program, BooleanSupplier ends)
      throws Exception {
    InetSocketAddress vision = new InetSocketAddress(InetAddress.getLoopbackAddress(), freePort());
    AtomicBoolean stop = new AtomicBoolean();
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
      CompletableFuture<Void> serving =
          CompletableFuture.runAsync(
              () -> {
                try {
                  server.serve(() -> stop.get() || ends.getAsBoolean());
                } catch (IOException e) {
                  throw new AssertionError(e);
                }
              },
              task -> new Thread(task).start());
      try {
        String line =
            "play --ssl-sim 127.0.0.1 --kind flat --seed 6 --port "
                + commands
                + " --vision 127.0.0.1:"
                + vision.getPort()
                + " "
                + options;
        return program.applyAsInt(line.split(" "));
      } finally {
        stop.set(true);
        serving.get(5, TimeUnit.SECONDS);
      }
    }
  }

  /** It dies while the second ball rolls. */
  @Test
  void whoeverLosesTheSimulatorIsToldSoAndHowToCalibrateWhatIsThere() throws Exception {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    Path session = directory.resolve("session");
    Path commands = session.resolve("session-flat.commands.csv");
    AtomicBoolean dead = new AtomicBoolean();
    int status =
        play(
            "--kicks 4 --patience 3 --out " + session,
            out,
            err,
            () -> {
              dead.set(dead.get() || lines(commands) > 1);
              return dead.get();
            });
    assertThat(status).isEqualTo(1);
    List<String> said = err.toString().lines().toList();
    assertThat(said.get(said.size() - 1))
        .matches(
            "fieldcal: The play stopped after 1 of 4 good kicks: no vision for 3 s \\(the simulator"
                + " at 127.0.0.1, ports \\d+ to \\d+ does not answer\\)\\. To calibrate: fieldcal"
                + " calibrate .*/session-\\*.log --out .*");
    assertThat(out.toString()).contains("1 good kick of 1 made");
  }

  /** Answers every command with an error; its ports are those of a simulator. */
  private static final class Complaining implements AutoCloseable {
    private final List<DatagramSocket> sockets = new ArrayList<>();
    private final AtomicInteger answers = new AtomicInteger();

    Complaining(int port, String text) throws IOException {
      SimulatorError error = SimulatorError.newBuilder().setCode("NO").setMessage(text).build();
      byte[] answer = RobotControlResponse.newBuilder().addErrors(error).build().toByteArray();
      for (int i = 0; i < 3; i++) {
        DatagramSocket socket = new DatagramSocket(port + i, InetAddress.getLoopbackAddress());
        sockets.add(socket);
        new Thread(() -> serve(socket, answer)).start();
      }
    }

    private void serve(DatagramSocket socket, byte[] answer) {
      DatagramPacket command = new DatagramPacket(new byte[65536], 65536);
      try {
        while (!socket.isClosed()) {
          socket.receive(command);
          socket.send(new DatagramPacket(answer, answer.length, command.getSocketAddress()));
          answers.incrementAndGet();
        }
      } catch (IOException closed) {
        // The end.
      }
    }

    @Override
    public void close() {
      sockets.forEach(DatagramSocket::close);
    }
  }

  /** As the program is started: its output is the one that makes texts harmless. */
  private static int asTheProgram(ByteArrayOutputStream said, String... line) {
    PrintStream before = System.out;
    System.setOut(new PrintStream(said, true, StandardCharsets.UTF_8));
    try {
      CommandLine program = Main.commandLine().setErr(new PrintWriter(Writer.nullWriter()));
      int status = program.execute(line);
      program.getOut().flush();
      return status;
    } finally {
      System.setOut(before);
    }
  }

  @Test
  void anErrorOfTheSimulatorDoesNotSteerTheTerminal() throws Exception {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    int commands = freePorts();
    try (Complaining simulator = new Complaining(commands, "bad\u001b[2J\u0007robot")) {
      play(
          "--kicks 1 --patience 1",
          freePorts(),
          commands,
          line -> asTheProgram(said, line),
          () -> simulator.answers.get() > 20);
    }
    assertThat(said.toString(StandardCharsets.UTF_8))
        .contains("bad␛[2J␇robot")
        .doesNotContain("\u001b", "\u0007");
  }

  private static long lines(Path file) {
    try {
      return Files.exists(file) ? Files.readAllLines(file).size() : 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aStallOfTheSimulatorIsToldAsItHappens() throws Exception {
    StringWriter out = new StringWriter();
    AtomicBoolean stalled = new AtomicBoolean();
    long begin = System.nanoTime();
    assertThat(play("--kicks 2", out, new StringWriter(), () -> stall(begin, stalled))).isZero();
    String said = out.toString();
    assertThat(said)
        .containsPattern("vision was silent for (0\\.9|1\\.\\d) s, \\d s after its first frame")
        .containsPattern("vision's clock jumped by −(0\\.[5-9]|1\\.)\\d* s")
        .containsPattern("vision: \\d+ silences and jumps of its clock")
        .doesNotContain("Nothing was received");
    // Not only at the end: before the second kick is made.
    assertThat(said.indexOf("vision was silent")).isLessThan(said.indexOf("  2  yellow"));
  }
}
