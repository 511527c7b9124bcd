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
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Talks to a simulator: robot control for both teams, teleporting; its complaints are counted. Never waits for an answer. Not thread-safe. */
final class SimulatorClient implements RobotLink {
  /** Two seconds of commands. Simulators answer each. */
  private static final int ENOUGH_TO_ANSWER = 200;

  /** Turns per minute that hold a ball in all simulators. */
  private static final float DRIBBLER = 3000;

  private final CommandChannel control;
  private final CommandChannel blue;
  private final CommandChannel yellow;
  private final Complaints complaints = new Complaints("simulator");
  private final String silence;
  private final String name;
  private int sent;
  private int unreachable;
  private int answers;
  private int unanswered;
  private boolean silent;
  private int silences;

  SimulatorClient(String host, SimulatorPorts ports) throws IOException {
    InetAddress address = CommandChannel.resolved(host);
    name = host + ", ports " + ports.control() + " to " + ports.yellow();
    silence = "no simulator answers at " + name + ": check the host and --port";
    control = new CommandChannel(address, ports.control());
    blue = new CommandChannel(address, ports.blue());
    yellow = new CommandChannel(address, ports.yellow());
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

  private void send(CommandChannel channel, byte[] message) throws IOException {
    sent++;
    if (++unanswered == ENOUGH_TO_ANSWER && answers > 0) {
      silences++;
    }
    if (!channel.send(message)) {
      // It may be starting; vision tells when it is there.
      unreachable++;
    }
  }

  @Override
  public void listen() throws IOException {
    for (CommandChannel channel : List.of(control, blue, yellow)) {
      boolean reachable =
          channel.answers(
              answer -> {
                answers++;
                unanswered = 0;
                complaints.add(errors(answer, channel == control));
              });
      unreachable += reachable ? 0 : 1;
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

  /** A simulator's robots are nobody's harm. */
  @Override
  public Optional<String> hold() {
    return Optional.empty();
  }

  @Override
  public Optional<String> silent() {
    return answers > 0 && unanswered >= ENOUGH_TO_ANSWER
        ? Optional.of("the simulator at " + name + " does not answer")
        : Optional.empty();
  }

  @Override
  public List<String> notes() {
    List<String> notes = new ArrayList<>();
    if (answers == 0 && isSilent()) {
      notes.add(silence);
    }
    if (silences > 0) {
      notes.add(stopped() + (silences > 1 ? ", " + silences + " times" : ""));
    }
    notes.addAll(complaints.counted());
    return notes;
  }

  private String stopped() {
    return "the simulator at " + name + " stopped answering";
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
    if (silences > 0) {
      all.add(stopped());
    }
    all.addAll(complaints.all());
    return all;
  }

  @Override
  public void close() throws IOException {
    control.close();
    blue.close();
    yellow.close();
  }
}
