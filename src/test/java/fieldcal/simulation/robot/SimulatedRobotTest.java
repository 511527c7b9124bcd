package fieldcal.simulation.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How a robot accelerates. */
class SimulatedRobotTest {
  private static final double STEP = 0.001;
  private static final double ACCELERATION = 3;
  private static final double VELOCITY = 2;

  private static SimulatedRobot robot(double settling) {
    SimulatedRobot robot =
        new SimulatedRobot(
            new RobotId(Team.YELLOW, 1),
            RobotLimits.uniform(VELOCITY, ACCELERATION, 4),
            0.14,
            0,
            0,
            0);
    robot.settles(settling);
    robot.command(RobotCommand.driveTo(100, 0, 0, VELOCITY));
    return robot;
  }

  @Test
  void accelerationChangesAtOnce() {
    SimulatedRobot robot = robot(0);
    robot.move(STEP);
    assertThat(robot.vx()).isEqualTo(ACCELERATION * STEP, within(1e-12));
  }

  /** The jerk is the acceleration over the settling time; all of the acceleration is used in between, and the highest speed is the same. */
  @ParameterizedTest
  @ValueSource(doubles = {0.02, 0.05, 0.08})
  void accelerationChangesEvenly(double settling) {
    SimulatedRobot robot = robot(settling);
    double largest = 0;
    double jerk = 0;
    double before = 0;
    for (int i = 0; i < 1000; i++) {
      double speed = robot.vx();
      robot.move(STEP);
      double acceleration = (robot.vx() - speed) / STEP;
      jerk = Math.max(jerk, Math.abs(acceleration - before) / STEP);
      largest = Math.max(largest, acceleration);
      before = acceleration;
    }
    assertThat(jerk).isEqualTo(ACCELERATION / settling, within(1e-6 * jerk));
    assertThat(largest).isEqualTo(ACCELERATION, within(1e-9));
    assertThat(robot.vx()).isEqualTo(VELOCITY, within(1e-9));
  }

  @Test
  void aRobotThatIsPlacedRests() {
    SimulatedRobot robot = robot(0.08);
    for (int i = 0; i < 300; i++) {
      robot.move(STEP);
    }
    robot.command(RobotCommand.HALT);
    robot.place(1, 2, 0);
    robot.move(STEP);
    assertThat(robot.speed()).isZero();
    assertThat(robot.x()).isEqualTo(1);
  }
}
