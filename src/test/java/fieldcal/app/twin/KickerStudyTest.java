package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.app.calibrate.CommandedKick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.KickBehaviour;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** How a twin's kickers follow their commands. */
class KickerStudyTest {
  private static final double EXACT = 1e-12;

  private final List<CommandedKick> kicks = new ArrayList<>();

  private void add(int robot, String commanded, KickKind measured, double speed) {
    Command command = new Command(0, new RobotId(Team.YELLOW, robot), commanded, 4, 0, Math.PI / 4);
    double part = measured == KickKind.CHIP ? Math.sqrt(0.5) : 1;
    double vz = measured == KickKind.CHIP ? part * speed : 0;
    CommandedKick.of(Optional.of(command), measured, part * speed, 0, vz).ifPresent(kicks::add);
  }

  private KickBehaviour behaviour() {
    return new KickerStudy(kicks, new ArrayList<>()).behaviour(Map.of());
  }

  /** A chip that was fitted as a flat kick begins with the speed after its impact. */
  @Test
  void aKickOfAnotherKindThanCommandedDoesNotCount() {
    for (int i = 0; i < 4; i++) {
      add(1, "chip", KickKind.CHIP, 4);
      add(1, "chip", KickKind.FLAT, 2.8);
    }
    assertThat(kicks).hasSize(4);
    assertThat(behaviour().biases().get(0).speed()).isCloseTo(0, within(EXACT));
    assertThat(behaviour().speedScatter()).isCloseTo(0, within(EXACT));
  }

  /** Each robot's own mean takes one degree of freedom: 12 kicks of 4 robots have 8. */
  @Test
  void theScatterIsThatWithinRobots() {
    for (int robot = 0; robot < 4; robot++) {
      for (double gain : new double[] {0.98, 1, 1.02}) {
        add(robot, "flat", KickKind.FLAT, 4 * gain);
      }
    }
    assertThat(behaviour().speedScatter()).isCloseTo(0.02, within(EXACT));
  }
}
