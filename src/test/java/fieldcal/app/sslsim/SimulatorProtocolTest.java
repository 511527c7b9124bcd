package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.proto.MoveWheelVelocity;
import fieldcal.proto.RobotCommand;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.RobotMoveCommand;
import fieldcal.proto.SimulatorCommand;
import fieldcal.proto.SimulatorConfig;
import fieldcal.proto.SimulatorControl;
import fieldcal.proto.SimulatorResponse;
import fieldcal.proto.TeleportBall;
import fieldcal.proto.TeleportRobot;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The simulation protocol on a field, without sockets. */
class SimulatorProtocolTest {
  private static final RobotId FIRST = new RobotId(Team.YELLOW, 0);
  private static final RobotId SECOND = new RobotId(Team.BLUE, 1);

  private final InteractiveField field =
      InteractiveField.of(SimulationSettings.DEFAULT, FIRST, SECOND, List.of());
  private final SimulatorProtocol protocol = new SimulatorProtocol(field);

  private void run(double seconds) {
    double end = field.world().time() + seconds;
    while (field.world().time() < end) {
      protocol.beforeStep();
      field.step(packet -> {});
    }
  }

  private SimulatedRobot robot(RobotId id) {
    return field.world().robots().stream().filter(r -> r.id().equals(id)).findFirst().orElseThrow();
  }

  private RobotControlResponse tell(Team team, RobotCommand command) throws Exception {
    byte[] message = RobotControl.newBuilder().addRobotCommands(command).build().toByteArray();
    return RobotControlResponse.parseFrom(protocol.robots(team, message));
  }

  private SimulatorResponse control(SimulatorControl control) throws Exception {
    byte[] message = SimulatorCommand.newBuilder().setControl(control).build().toByteArray();
    return SimulatorResponse.parseFrom(protocol.control(message));
  }

  @Test
  void localVelocityIsInTheRobotsFrame() throws Exception {
    field.placeRobot(SECOND, 1, 1, Math.PI / 2);
    RobotControlResponse answer =
        tell(Team.BLUE, SimulatorClient.command(1, 0.5, 0, 0, 0, 0, false));
    assertThat(answer.getErrorsList()).isEmpty();
    assertThat(answer.getFeedbackList()).hasSize(1);
    run(0.4);
    assertThat(robot(SECOND).vy()).isCloseTo(0.5, within(1e-9));
    assertThat(robot(SECOND).vx()).isCloseTo(0, within(1e-9));
  }

  @Test
  void aRobotThatHearsNothingStops() throws Exception {
    tell(Team.YELLOW, SimulatorClient.command(0, 1, 0, 0, 0, 0, false));
    run(0.4);
    assertThat(robot(FIRST).speed()).isGreaterThan(0.5);
    run(1);
    assertThat(robot(FIRST).speed()).isZero();
  }

  @Test
  void whatCannotBeDoneIsAnsweredWithAnError() throws Exception {
    assertThat(tell(Team.BLUE, SimulatorClient.command(7, 0, 0, 0, 0, 0, false)).getErrorsList())
        .singleElement()
        .satisfies(e -> assertThat(e.getCode()).isEqualTo("NO_ROBOT"));
    MoveWheelVelocity wheels =
        MoveWheelVelocity.newBuilder()
            .setFrontRight(1)
            .setBackRight(1)
            .setBackLeft(1)
            .setFrontLeft(1)
            .build();
    RobotCommand byWheels =
        RobotCommand.newBuilder()
            .setId(0)
            .setMoveCommand(RobotMoveCommand.newBuilder().setWheelVelocity(wheels))
            .build();
    assertThat(tell(Team.YELLOW, byWheels).getErrors(0).getCode()).isEqualTo("UNSUPPORTED");
    assertThat(
            tell(Team.YELLOW, SimulatorClient.command(0, Double.NaN, 0, 0, 0, 0, false))
                .getErrorsCount())
        .isEqualTo(1);
    byte[] config =
        SimulatorCommand.newBuilder()
            .setConfig(SimulatorConfig.newBuilder().setVisionPort(1))
            .build()
            .toByteArray();
    assertThat(SimulatorResponse.parseFrom(protocol.control(config)).getErrorsCount()).isEqualTo(1);
    assertThat(control(SimulatorControl.newBuilder().setSimulationSpeed(-1).build()).getErrors(0))
        .satisfies(e -> assertThat(e.getCode()).isEqualTo("OUT_OF_RANGE"));
    TeleportBall flying = TeleportBall.newBuilder().setX(0).setVz(3).build();
    assertThat(
            control(SimulatorControl.newBuilder().setTeleportBall(flying).build()).getErrorsCount())
        .isEqualTo(1);
  }

  @Test
  void ballAndRobotsArePutWhereTheyAreWanted() throws Exception {
    TeleportBall ball = TeleportBall.newBuilder().setX(1.5f).setY(-2f).setVx(0).build();
    TeleportRobot robot =
        TeleportRobot.newBuilder()
            .setId(fieldcal.proto.RobotId.newBuilder().setId(1).setTeam(fieldcal.proto.Team.BLUE))
            .setX(-1)
            .setY(2)
            .setOrientation(1)
            .build();
    assertThat(
            control(
                    SimulatorControl.newBuilder()
                        .setTeleportBall(ball)
                        .addTeleportRobot(robot)
                        .build())
                .getErrorsList())
        .isEmpty();
    run(0.05);
    assertThat(field.world().ball().x()).isCloseTo(1.5, within(1e-6));
    assertThat(field.world().ball().y()).isCloseTo(-2, within(1e-6));
    assertThat(robot(SECOND).x()).isCloseTo(-1, within(1e-6));

    TeleportRobot gone =
        robot.toBuilder().setPresent(false).clearX().clearY().clearOrientation().build();
    control(SimulatorControl.newBuilder().addTeleportRobot(gone).build());
    assertThat(robot(SECOND).x()).isGreaterThan(100);
  }

  @Test
  void nonsenseIsAnsweredToo() throws Exception {
    Random random = new Random(3);
    for (int i = 0; i < 2000; i++) {
      byte[] bytes = new byte[random.nextInt(40)];
      random.nextBytes(bytes);
      try {
        RobotControlResponse.parseFrom(protocol.robots(Team.BLUE, bytes));
        SimulatorResponse.parseFrom(protocol.control(bytes));
      } catch (com.google.protobuf.InvalidProtocolBufferException e) {
        // The server answers this with an error.
        assertThat(RobotControlResponse.parseFrom(SimulatorProtocol.unreadable(false)).getErrors(0))
            .satisfies(x -> assertThat(x.getCode()).isEqualTo("UNREADABLE"));
      }
    }
    run(0.1);
  }
}
