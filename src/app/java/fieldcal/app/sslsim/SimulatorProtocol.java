package fieldcal.app.sslsim;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.proto.MoveGlobalVelocity;
import fieldcal.proto.MoveLocalVelocity;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.RobotFeedback;
import fieldcal.proto.RobotMoveCommand;
import fieldcal.proto.SimulatorCommand;
import fieldcal.proto.SimulatorError;
import fieldcal.proto.SimulatorResponse;
import fieldcal.proto.TeleportBall;
import fieldcal.proto.TeleportRobot;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotCommand.Velocity;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The protocol's messages applied to a simulated field; what it cannot do is answered with an error. */
final class SimulatorProtocol {
  /** Robots that hear nothing for that long stop, s. */
  private static final double SILENCE = 0.5;

  private static final double FARTHEST = 100;

  private final InteractiveField field;
  private final Map<RobotId, Double> heard = new HashMap<>();
  private double speed = 1;

  SimulatorProtocol(InteractiveField field) {
    this.field = field;
  }

  /** Field time over real time. */
  double speed() {
    return speed;
  }

  void beforeStep() {
    double now = field.world().time();
    heard
        .entrySet()
        .removeIf(
            entry -> {
              boolean silent = now - entry.getValue() > SILENCE;
              if (silent) {
                field.command(entry.getKey(), RobotCommand.HALT);
              }
              return silent;
            });
  }

  byte[] robots(Team team, byte[] message) throws InvalidProtocolBufferException {
    RobotControlResponse.Builder response = RobotControlResponse.newBuilder();
    for (fieldcal.proto.RobotCommand command :
        RobotControl.parseFrom(message).getRobotCommandsList()) {
      int id = command.getId();
      Optional<SimulatedRobot> robot =
          field.world().robots().stream()
              .filter(r -> r.id().team() == team && r.id().number() == id)
              .findFirst();
      if (robot.isEmpty()) {
        response.addErrors(error("NO_ROBOT", "there is no robot " + team.label() + " " + id));
        continue;
      }
      Optional<Velocity> velocity = velocity(command.getMoveCommand(), robot.get());
      if (command.hasMoveCommand() && velocity.isEmpty()) {
        response.addErrors(
            error("UNSUPPORTED", "only finite local and global velocities are understood"));
        continue;
      }
      double kick = Math.max(0, Math.min(10, command.getKickSpeed()));
      double angle = Math.toRadians(Math.max(0, Math.min(80, command.getKickAngle())));
      field.command(
          robot.get().id(),
          new RobotCommand(
              velocity.orElse(new Velocity(0, 0, 0)),
              new Kick(Double.isNaN(kick) ? 0 : kick, Double.isNaN(angle) ? 0 : angle),
              command.getDribblerSpeed() > 0));
      heard.put(robot.get().id(), field.world().time());
      response.addFeedback(
          RobotFeedback.newBuilder().setId(id).setDribblerBallContact(touches(robot.get())));
    }
    return response.build().toByteArray();
  }

  private static Optional<Velocity> velocity(RobotMoveCommand move, SimulatedRobot robot) {
    Velocity v = null;
    if (move.hasLocalVelocity()) {
      MoveLocalVelocity local = move.getLocalVelocity();
      double cos = Math.cos(robot.orientation());
      double sin = Math.sin(robot.orientation());
      v =
          new Velocity(
              local.getForward() * cos - local.getLeft() * sin,
              local.getForward() * sin + local.getLeft() * cos,
              local.getAngular());
    } else if (move.hasGlobalVelocity()) {
      MoveGlobalVelocity global = move.getGlobalVelocity();
      v = new Velocity(global.getX(), global.getY(), global.getAngular());
    }
    return Optional.ofNullable(v).filter(w -> Double.isFinite(w.vx() + w.vy() + w.angular()));
  }

  private boolean touches(SimulatedRobot robot) {
    SimulatedWorld world = field.world();
    double ahead = robot.ahead(world.ball().x(), world.ball().y());
    double aside = Math.abs(robot.aside(world.ball().x(), world.ball().y()));
    return ahead > 0 && ahead < SimulatedRobot.FRONT + 0.03 && aside < SimulatedRobot.MOUTH;
  }

  byte[] control(byte[] message) throws InvalidProtocolBufferException {
    SimulatorCommand command = SimulatorCommand.parseFrom(message);
    List<SimulatorError> errors = new ArrayList<>();
    if (command.hasConfig()) {
      errors.add(error("UNSUPPORTED", "this field is configured on its command line only"));
    }
    if (command.getControl().hasTeleportBall()) {
      teleport(command.getControl().getTeleportBall(), errors);
    }
    for (TeleportRobot robot : command.getControl().getTeleportRobotList()) {
      teleport(robot, errors);
    }
    if (command.getControl().hasSimulationSpeed()) {
      double wanted = command.getControl().getSimulationSpeed();
      if (wanted >= 0 && wanted <= 20) {
        speed = wanted;
      } else {
        errors.add(error("OUT_OF_RANGE", "simulation speed must lie in [0, 20]"));
      }
    }
    return SimulatorResponse.newBuilder().addAllErrors(errors).build().toByteArray();
  }

  private void teleport(TeleportBall ball, List<SimulatorError> errors) {
    double x = ball.hasX() ? ball.getX() : field.world().ball().x();
    double y = ball.hasY() ? ball.getY() : field.world().ball().y();
    boolean moves = Math.abs(ball.getVx()) + Math.abs(ball.getVy()) + Math.abs(ball.getVz()) > 0;
    if (moves || ball.getZ() > 0.1 || ball.getByForce()) {
      errors.add(error("UNSUPPORTED", "the ball can only be laid down at rest"));
    } else if (!(Math.abs(x) < FARTHEST && Math.abs(y) < FARTHEST)) {
      errors.add(error("OUT_OF_RANGE", "there is no place (" + x + ", " + y + ")"));
    } else {
      field.handBall(x, y, 0);
    }
  }

  private void teleport(TeleportRobot robot, List<SimulatorError> errors) {
    Team team = robot.getId().getTeam() == fieldcal.proto.Team.BLUE ? Team.BLUE : Team.YELLOW;
    RobotId id = new RobotId(team, Math.max(0, robot.getId().getId()));
    Optional<SimulatedRobot> found =
        field.world().robots().stream().filter(r -> r.id().equals(id)).findFirst();
    if (found.isEmpty()) {
      errors.add(error("NO_ROBOT", "there is no robot " + id));
      return;
    }
    if (robot.hasPresent()) {
      field.setPresent(id, robot.getPresent());
    }
    double x = robot.hasX() ? robot.getX() : found.get().x();
    double y = robot.hasY() ? robot.getY() : found.get().y();
    double turn = robot.hasOrientation() ? robot.getOrientation() : found.get().orientation();
    boolean moves = Math.abs(robot.getVX()) + Math.abs(robot.getVY()) > 0;
    if (moves || robot.getByForce()) {
      errors.add(error("UNSUPPORTED", "robots can only be put down at rest"));
    } else if (!(Math.abs(x) < FARTHEST && Math.abs(y) < FARTHEST && Double.isFinite(turn))) {
      errors.add(error("OUT_OF_RANGE", "there is no place (" + x + ", " + y + ")"));
    } else if (robot.hasX() || robot.hasY() || robot.hasOrientation()) {
      field.placeRobot(id, x, y, turn);
    }
  }

  static byte[] unreadable(boolean ofControl) {
    SimulatorError error = error("UNREADABLE", "this is not a message of the simulation protocol");
    return ofControl
        ? SimulatorResponse.newBuilder().addErrors(error).build().toByteArray()
        : RobotControlResponse.newBuilder().addErrors(error).build().toByteArray();
  }

  private static SimulatorError error(String code, String message) {
    return SimulatorError.newBuilder().setCode(code).setMessage(message).build();
  }
}
