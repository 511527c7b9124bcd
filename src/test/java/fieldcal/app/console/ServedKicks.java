package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.proto.MoveLocalVelocity;
import fieldcal.proto.RobotCommand;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotId;
import fieldcal.proto.RobotMoveCommand;
import fieldcal.proto.SimulatorCommand;
import fieldcal.proto.SimulatorControl;
import fieldcal.proto.Team;
import fieldcal.proto.TeleportBall;
import fieldcal.proto.TeleportRobot;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** A network with vision: {@code simulate --serve} as a program of its own, and somebody who has a robot kick there. */
final class ServedKicks implements AutoCloseable {
  /** From a robot's centre to that of a ball at its dribbler, m. */
  private static final double AT_DRIBBLER = 0.0965;

  /** A kick begins from rest, which vision has to see, ms. */
  private static final int REST = 350;

  private final Process process;
  private final DatagramSocket socket = new DatagramSocket();
  private final int port;
  private final String vision;

  /** Begins to serve; returns once it does. */
  ServedKicks() throws IOException {
    port = freePorts();
    vision = "127.0.0.1:" + freePort();
    process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m",
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty("java.class.path"),
                "fieldcal.app.cli.Main",
                "simulate",
                "--serve",
                "--seed=6",
                "--vision=" + vision,
                "--port=" + port)
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    BufferedReader said =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String line = said.readLine();
    if (line == null || !line.startsWith("serving yellow 0 and yellow 1")) {
      close();
      throw new IOException("simulate --serve says: " + line);
    }
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  /** Three free ports in a row. */
  private static int freePorts() throws IOException {
    for (int attempt = 0; attempt < 50; attempt++) {
      int first = freePort();
      try (DatagramSocket second = new DatagramSocket(first + 1);
          DatagramSocket third = new DatagramSocket(first + 2)) {
        assertThat(second.isBound() && third.isBound()).isTrue();
        return first;
      } catch (IOException | IllegalArgumentException taken) {
        continue;
      }
    }
    throw new IOException("no three free ports");
  }

  /** Where vision sends to. */
  String vision() {
    return vision;
  }

  /** Where its simulator is controlled. */
  int port() {
    return port;
  }

  /** Takes one of the two robots off the field, or puts it back. */
  void setPresent(int robot, boolean present) throws IOException {
    TeleportRobot whether =
        TeleportRobot.newBuilder()
            .setId(RobotId.newBuilder().setId(robot).setTeam(Team.YELLOW))
            .setPresent(present)
            .build();
    SimulatorControl control = SimulatorControl.newBuilder().addTeleportRobot(whether).build();
    send(port, SimulatorCommand.newBuilder().setControl(control).build().toByteArray());
  }

  /**
   * Lays the ball down before a robot, which kicks it.
   *
   * @param x of the ball, m
   * @param y of the ball, m
   * @param direction of the kick, rad
   * @param speed of the kick, m/s
   * @param elevation of the kick, degrees; 0 is flat
   * @param seconds that the ball is left alone afterwards
   */
  void kick(double x, double y, double direction, double speed, double elevation, double seconds)
      throws IOException, InterruptedException {
    TeleportBall ball =
        TeleportBall.newBuilder().setX((float) x).setY((float) y).setZ(0).setVx(0).setVy(0).build();
    TeleportRobot robot =
        TeleportRobot.newBuilder()
            .setId(RobotId.newBuilder().setId(0).setTeam(Team.YELLOW))
            .setX((float) (x - AT_DRIBBLER * Math.cos(direction)))
            .setY((float) (y - AT_DRIBBLER * Math.sin(direction)))
            .setOrientation((float) direction)
            .build();
    SimulatorControl control =
        SimulatorControl.newBuilder().setTeleportBall(ball).addTeleportRobot(robot).build();
    send(port, SimulatorCommand.newBuilder().setControl(control).build().toByteArray());
    Thread.sleep(REST);
    command(speed, elevation);
    Thread.sleep(100);
    command(0, 0);
    Thread.sleep(Math.round(1000 * seconds));
  }

  private void command(double speed, double elevation) throws IOException {
    MoveLocalVelocity stand =
        MoveLocalVelocity.newBuilder().setForward(0).setLeft(0).setAngular(0).build();
    RobotCommand command =
        RobotCommand.newBuilder()
            .setId(0)
            .setMoveCommand(RobotMoveCommand.newBuilder().setLocalVelocity(stand))
            .setKickSpeed((float) speed)
            .setKickAngle((float) elevation)
            .build();
    send(port + 2, RobotControl.newBuilder().addRobotCommands(command).build().toByteArray());
  }

  private void send(int to, byte[] message) throws IOException {
    InetAddress here = InetAddress.getLoopbackAddress();
    socket.send(new DatagramPacket(message, message.length, here, to));
  }

  @Override
  public void close() throws IOException {
    socket.close();
    process.destroy();
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }
}
