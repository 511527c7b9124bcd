package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** Robots told what they did, but for a scatter of one per cent and, of one of them, a bias. */
class KickerBiasTest {
  private static final RobotId SOUND = new RobotId(Team.YELLOW, 3);
  private static final RobotId BIASED = new RobotId(Team.BLUE, 7);
  private static final SimulationSettings FIELD =
      HiddenCase.of(41000019, ScenarioKind.CHIP).settings();

  private final FittedField field = FittedField.of(FIELD);

  /** The causes when every second kick is that share faster, and that much aside (rad), than told. */
  private List<Cause> causes(double speed, double yaw, double scale, boolean two) {
    Random random = new Random(5);
    Map<Integer, KickCommand> commands = new HashMap<>();
    for (int k = 0; k < field.simple().kickCount(); k++) {
      double[] own = field.simple().solution().own(k);
      boolean biased = k % 2 == 0;
      double seen = Math.sqrt(own[2] * own[2] + own[3] * own[3] + own[4] * own[4]);
      double told = seen / (scale * (1 + (biased ? speed : 0) + 0.01 * random.nextGaussian()));
      double direction =
          Math.atan2(own[3], own[2]) - (biased ? yaw : 0) - 0.004 * random.nextGaussian();
      commands.put(
          field.simple().kick(k).record().kick().id(),
          new KickCommand(biased && two ? BIASED : SOUND, told, direction, 0.7));
    }
    return causes(commands);
  }

  /** Fourteen kicks of three sound robots, so that four or five must tell of each. */
  private boolean isSomebodyNamed(long seed) {
    Random random = new Random(seed);
    Map<Integer, KickCommand> commands = new HashMap<>();
    for (int k = 0; k < field.simple().kickCount(); k++) {
      double[] own = field.simple().solution().own(k);
      double seen = Math.sqrt(own[2] * own[2] + own[3] * own[3] + own[4] * own[4]);
      double told = seen / (1 + 0.01 * random.nextGaussian());
      double direction = Math.atan2(own[3], own[2]) - 0.005 * random.nextGaussian();
      RobotId robot = new RobotId(Team.YELLOW, k % 3);
      commands.put(
          field.simple().kick(k).record().kick().id(),
          new KickCommand(robot, told, direction, 0.7));
    }
    return !causes(commands).isEmpty();
  }

  private List<Cause> causes(Map<Integer, KickCommand> commands) {
    Arena arena = field.arena(KickerBias.robots(commands));
    return new KickerBias(field.simple(), commands, 1).causes(EffectCatalogue.all(), arena);
  }

  private static double value(Cause cause, String name) {
    Effect effect = cause.effect();
    return effect.parameters().stream()
        .filter(p -> p.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }

  @Test
  void theRobotThatKicksHarderIsNamedAndSized() {
    List<Cause> causes = causes(0.05, 0, 1, true);
    assertThat(causes).hasSize(1);
    Cause cause = causes.get(0);
    assertThat(cause.effect().toString()).contains("7");
    assertThat(value(cause, "robot")).isEqualTo(7);
    assertThat(value(cause, "percent"))
        .isCloseTo(5, within(3 * cause.standardErrors().get("percent")));
    assertThat(cause.gain().lowMm()).isPositive();
  }

  @Test
  void theRobotThatKicksAsideIsNamed() {
    List<Cause> causes = causes(0, -0.03, 1, true);
    assertThat(causes).hasSize(1);
    assertThat(value(causes.get(0), "yaw"))
        .isCloseTo(-0.03, within(3 * causes.get(0).standardErrors().get("yaw")));
  }

  @Test
  void soundRobotsAreNotNamed() {
    assertThat(causes(0, 0, 1, true)).isEmpty();
  }

  @Test
  void fewKicksOfSoundRobotsAgreeByChanceAndAreNotNamed() {
    long named = LongStream.range(0, 3000).filter(this::isSomebodyNamed).count();
    // The promise is one in a thousand; ten of 3000 happen by chance once in a thousand tests.
    assertThat(named).isLessThan(10);
  }

  @Test
  void whatAllRobotsHaveInCommonIsNoKickers() {
    assertThat(causes(0, 0, 1.08, true)).isEmpty();
  }

  @Test
  void oneRobotAloneIsMeasuredAgainstItsCommands() {
    assertThat(causes(0, 0, 1.08, false)).hasSize(1);
  }

  @Test
  void withoutCommandsNobodyIsBlamed() {
    assertThat(causes(Map.of())).isEmpty();
  }
}
