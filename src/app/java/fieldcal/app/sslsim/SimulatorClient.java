package fieldcal.app.sslsim;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.proto.MoveLocalVelocity;
import fieldcal.proto.RobotCommand;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.RobotMoveCommand;
import fieldcal.proto.SimulatorCommand;
import fieldcal.proto.SimulatorControl;
import fieldcal.proto.SimulatorError;
import fieldcal.proto.SimulatorResponse;
import fieldcal.proto.TeleportBall;
import fieldcal.vision.Team;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Talks to a simulator: robot control for both teams, teleporting; its complaints are counted. Never waits for an answer. Not thread-safe. */
final class SimulatorClient implements RobotLink {
  private static final int LARGEST = 65_536;
  private static final int MOST_COMPLAINTS = 20;

  /** Answers that are read at once: each command has one, and who sends more must not keep the play from going on. */
  private static final int MOST_ANSWERS = 1000;

  /** Two seconds of commands. Simulators answer each. */
  private static final int ENOUGH_TO_ANSWER = 200;

  /** Turns per minute that hold a ball in all simulators. */
  private static final float DRIBBLER = 3000;

  private final DatagramChannel control;
  private final DatagramChannel blue;
  private final DatagramChannel yellow;
  private final ByteBuffer buffer = ByteBuffer.allocate(LARGEST);
  private final Map<String, Integer> complaints = new LinkedHashMap<>();
  private final String silence;
  private int sent;
  private int unreachable;
  private int answers;
  private boolean silent;

  SimulatorClient(String host, SimulatorPorts ports) throws IOException {
    InetAddress address;
    try {
      address = InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new IOException("'" + host + "' is not a known host", e);
    }
    String name = host + ", ports " + ports.control() + " to " + ports.yellow();
    silence = "no simulator answers at " + name + ": check the host and --port";
    control = open(address, ports.control());
    blue = open(address, ports.blue());
    yellow = open(address, ports.yellow());
  }

  private static DatagramChannel open(InetAddress address, int port) throws IOException {
    DatagramChannel channel = DatagramChannel.open();
    channel.configureBlocking(false);
    channel.connect(new InetSocketAddress(address, port));
    return channel;
  }

  /** One robot's command: velocity in its own frame. */
  static RobotCommand command(
      int id,
      double forward,
      double left,
      double angular,
      double kickSpeed,
      double elevation,
      boolean dribbler) {
    MoveLocalVelocity velocity =
        MoveLocalVelocity.newBuilder()
            .setForward((float) forward)
            .setLeft((float) left)
            .setAngular((float) angular)
            .build();
    return RobotCommand.newBuilder()
        .setId(id)
        .setMoveCommand(RobotMoveCommand.newBuilder().setLocalVelocity(velocity))
        .setKickSpeed((float) kickSpeed)
        .setKickAngle((float) Math.toDegrees(elevation))
        .setDribblerSpeed(dribbler ? DRIBBLER : 0)
        .build();
  }

  @Override
  public void robots(Team team, List<RobotCommand> commands) throws IOException {
    RobotControl message = RobotControl.newBuilder().addAllRobotCommands(commands).build();
    send(team == Team.BLUE ? blue : yellow, message.toByteArray());
  }

  @Override
  public void layBall(double x, double y) throws IOException {
    TeleportBall ball =
        TeleportBall.newBuilder()
            .setX((float) x)
            .setY((float) y)
            .setVx(0)
            .setVy(0)
            .setVz(0)
            .build();
    SimulatorCommand message =
        SimulatorCommand.newBuilder()
            .setControl(SimulatorControl.newBuilder().setTeleportBall(ball))
            .build();
    send(control, message.toByteArray());
  }

  private void send(DatagramChannel channel, byte[] message) throws IOException {
    sent++;
    try {
      channel.write(ByteBuffer.wrap(message));
    } catch (PortUnreachableException e) {
      // It may be starting; vision tells when it is there.
      unreachable++;
    }
  }

  @Override
  public void listen() throws IOException {
    for (DatagramChannel channel : List.of(control, blue, yellow)) {
      byte[] answer = receive(channel);
      for (int i = 0; answer != null && i < MOST_ANSWERS; i++) {
        answers++;
        note(errors(answer, channel == control));
        answer = receive(channel);
      }
    }
  }

  private byte[] receive(DatagramChannel channel) throws IOException {
    buffer.clear();
    try {
      return channel.read(buffer) > 0 ? Arrays.copyOf(buffer.array(), buffer.position()) : null;
    } catch (PortUnreachableException e) {
      unreachable++;
      return null;
    }
  }

  static List<SimulatorError> errors(byte[] answer, boolean ofControl) {
    try {
      return ofControl
          ? SimulatorResponse.parseFrom(answer).getErrorsList()
          : RobotControlResponse.parseFrom(answer).getErrorsList();
    } catch (InvalidProtocolBufferException e) {
      return List.of(SimulatorError.newBuilder().setMessage("an answer cannot be read").build());
    }
  }

  private void note(List<SimulatorError> errors) {
    for (SimulatorError error : errors) {
      String code = error.getCode().isEmpty() ? "" : " (" + error.getCode() + ")";
      String text = Complaint.shortened(error.getMessage() + code);
      if (complaints.containsKey(text) || complaints.size() < MOST_COMPLAINTS) {
        complaints.merge(text, 1, Integer::sum);
      }
    }
  }

  /** A simulator's robots are nobody's harm. */
  @Override
  public Optional<String> hold() {
    return Optional.empty();
  }

  @Override
  public List<String> notes() {
    List<String> notes = new ArrayList<>();
    if (answers == 0 && isSilent()) {
      notes.add(silence);
    }
    complaints.forEach(
        (text, n) -> notes.add("simulator: " + text + (n > 1 ? ", " + n + " times" : "")));
    return notes;
  }

  private boolean isSilent() {
    silent |= answers == 0 && (unreachable > 0 || sent > ENOUGH_TO_ANSWER);
    return silent;
  }

  @Override
  public List<String> complaints() {
    List<String> all = new ArrayList<>();
    if (isSilent()) {
      all.add(silence);
    }
    complaints.keySet().forEach(text -> all.add("simulator: " + text));
    return all;
  }

  @Override
  public void close() throws IOException {
    control.close();
    blue.close();
    yellow.close();
  }
}
