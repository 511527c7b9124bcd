package fieldcal.app.sslsim;

import fieldcal.app.hardening.ParserFuzz;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.RobotId;
import fieldcal.proto.SimulatorCommand;
import fieldcal.proto.SimulatorControl;
import fieldcal.proto.SimulatorError;
import fieldcal.proto.SimulatorResponse;
import fieldcal.proto.TeleportBall;
import fieldcal.proto.TeleportRobot;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.Team;
import java.util.List;

/** Both sides of the simulation protocol, for {@link ParserFuzz}. */
public final class SimulatorFuzz {
  /** The field goes on after so many messages, so that what they did to it is seen. */
  private static final int BETWEEN_STEPS = 50;

  private SimulatorFuzz() {}

  /**
   * The field that is served: what comes is carried out.
   *
   * @return takes messages to its control port
   */
  public static ParserFuzz.Parser control() {
    Served served = new Served();
    return message -> {
      served.protocol.control(message);
      served.goOn();
    };
  }

  /**
   * The field that is served.
   *
   * @return takes messages to its robots' port
   */
  public static ParserFuzz.Parser robots() {
    Served served = new Served();
    return message -> {
      served.protocol.robots(Team.YELLOW, message);
      served.goOn();
    };
  }

  private static final class Served {
    private final InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT,
            new fieldcal.vision.RobotId(Team.YELLOW, 0),
            new fieldcal.vision.RobotId(Team.YELLOW, 1),
            List.of());
    private final SimulatorProtocol protocol = new SimulatorProtocol(field);
    private int messages;

    void goOn() {
      if (++messages % BETWEEN_STEPS == 0) {
        protocol.beforeStep();
        field.step(packet -> {});
      }
    }
  }

  /**
   * What a simulator answers.
   *
   * @return takes answers of both kinds
   */
  public static ParserFuzz.Parser answers() {
    return answer -> {
      for (boolean ofControl : new boolean[] {true, false}) {
        for (SimulatorError error : SimulatorClient.errors(answer, ofControl)) {
          Complaints.text(error);
        }
      }
    };
  }

  /**
   * Good messages to the control port.
   *
   * @return their bytes
   */
  public static List<byte[]> controlMessages() {
    TeleportBall ball = TeleportBall.newBuilder().setX(1).setY(-2).setVx(0).setVy(0).build();
    TeleportRobot robot =
        TeleportRobot.newBuilder()
            .setId(RobotId.newBuilder().setId(0).setTeam(fieldcal.proto.Team.YELLOW))
            .setX(0.5f)
            .setY(1)
            .setOrientation(2)
            .setPresent(true)
            .build();
    SimulatorControl control =
        SimulatorControl.newBuilder()
            .setTeleportBall(ball)
            .addTeleportRobot(robot)
            .setSimulationSpeed(1)
            .build();
    return List.of(SimulatorCommand.newBuilder().setControl(control).build().toByteArray());
  }

  /**
   * Good messages to the robots' port.
   *
   * @return their bytes
   */
  public static List<byte[]> robotMessages() {
    return List.of(
        RobotControl.newBuilder()
            .addRobotCommands(SimulatorClient.command(0, 1, 0.5, -1, 4, 0.7, true))
            .addRobotCommands(SimulatorClient.command(1, 0, 0, 0, 0, 0, false))
            .build()
            .toByteArray());
  }

  /**
   * Good answers.
   *
   * @return their bytes
   */
  public static List<byte[]> answerMessages() {
    SimulatorError error =
        SimulatorError.newBuilder().setCode("NO_ROBOT").setMessage("there is no robot 7").build();
    return List.of(
        SimulatorResponse.newBuilder().addErrors(error).build().toByteArray(),
        RobotControlResponse.newBuilder().addErrors(error).build().toByteArray());
  }
}
