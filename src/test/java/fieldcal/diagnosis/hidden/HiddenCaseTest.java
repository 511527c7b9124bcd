package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulatedEffect;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** What is drawn, and how visible it is. */
class HiddenCaseTest {
  private static final List<HiddenCase> MANY =
      LongStream.range(0, 2000).mapToObj(HiddenCase::draw).toList();

  @Test
  void theSeedSaysItAll() {
    for (long seed = 0; seed < 50; seed++) {
      assertThat(HiddenCase.draw(seed)).isEqualTo(HiddenCase.draw(seed));
    }
    assertThat(MANY.stream().map(HiddenCase::settings).distinct()).hasSize(MANY.size());
  }

  @Test
  void everyEffectOnBallAndCamerasIsHiddenSometimes() {
    Set<SimulatedEffect> alone = EnumSet.noneOf(SimulatedEffect.class);
    Map<Category, Integer> count = new HashMap<>();
    for (HiddenCase c : MANY) {
      count.merge(c.category(), 1, Integer::sum);
      if (c.category() == Category.SINGLE) {
        // A companion comes before what needs it.
        alone.add(c.hidden().get(c.hidden().size() - 1).effect());
      } else if (c.category() == Category.UNNAMED) {
        assertThat(c.hidesUnnamed()).isTrue();
        alone.add(c.hidden().get(0).effect());
      }
    }
    assertThat(alone)
        .isEqualTo(
            EnumSet.complementOf(
                EnumSet.of(SimulatedEffect.TORQUE_LIMITED, SimulatedEffect.DIRECTIONAL)));
    assertThat(count.get(Category.SINGLE)).isBetween(820, 1020);
    assertThat(count.get(Category.NULL)).isBetween(260, 380);
    assertThat(count.get(Category.PAIR)).isBetween(150, 250);
    assertThat(count.get(Category.MIXTURE)).isBetween(240, 360);
    assertThat(count.get(Category.UNNAMED)).isBetween(200, 320);
  }

  @Test
  void mixturesHaveThreeOrFourCausesThatAreNotAlike() {
    List<HiddenCase> mixtures =
        MANY.stream().filter(c -> c.category() == Category.MIXTURE).toList();
    assertThat(mixtures).allMatch(c -> c.hidden().size() >= 3 && !c.hidesUnnamed());
    assertThat(mixtures)
        .allMatch(
            c -> c.hidden().stream().map(e -> e.effect()).distinct().count() == c.hidden().size());
    assertThat(MANY).allMatch(c -> !c.hides("wind") || c.hides("air_drag"));
    assertThat(MANY.stream().filter(c -> c.category() == Category.UNNAMED && !c.named().isEmpty()))
        .hasSizeGreaterThan(40);
  }

  @Test
  void whatHappensDuringTheSessionHappensWithinIt() {
    HiddenCase c = MANY.stream().filter(k -> k.hides("ball_changed")).findFirst().orElseThrow();
    double at =
        c.hidden().stream()
            .filter(e -> e.effect() == SimulatedEffect.BALL_CHANGED)
            .findFirst()
            .orElseThrow()
            .number("at");
    double duration = SeenKicks.of(c.settings()).truth().duration();
    assertThat(at).isBetween(0.15 * duration, 0.85 * duration);
  }

  @Test
  void aFieldWithSomethingGivenIsTheFieldOfTheSeed() {
    HiddenCase drawn =
        MANY.stream().filter(c -> c.category() == Category.NULL).findFirst().orElseThrow();
    assertThat(HiddenCase.of(drawn.seed(), drawn.settings().scenario().kind())).isEqualTo(drawn);
  }

  @Test
  void effectsOfCamerasHaveSeveralCamerasAndBiasesCommands() {
    for (HiddenCase c : MANY) {
      for (EffectSetting e : c.hidden()) {
        if (EffectChoice.needsSeveralCameras(e.effect())) {
          assertThat(c.settings().cameras().count()).as("seed %d", c.seed()).isGreaterThan(1);
        }
        if (e.effect() == SimulatedEffect.ROBOT_KICK_BIAS) {
          assertThat(c.commands()).as("seed %d", c.seed()).isTrue();
        }
      }
    }
  }

  @Test
  void inAWorldWithoutEffectsTheSimpleModelIsExact() {
    for (HiddenCase c :
        MANY.stream().filter(c -> c.category() == Category.NULL).limit(3).toList()) {
      Visibility left = Visibility.of(c);
      assertThat(left.left()).as("%s", c).isLessThan(0.01);
      assertThat(left.level()).isEqualTo(Visibility.Class.INVISIBLE);
      assertThat(left.kicks()).isGreaterThan(c.settings().scenario().kicks() / 2);
    }
  }

  /** Half of the balls are seen by cameras that report them 10 mm to one side, half by others, 10 mm to the other. */
  @Test
  void anOffsetOfTwoCamerasLeavesLittleBesideOffsets() {
    HiddenCase two =
        MANY.stream()
            .filter(c -> c.category() == Category.NULL && c.settings().cameras().count() == 2)
            .findFirst()
            .orElseThrow();
    Visibility v =
        Visibility.of(two, List.of(EffectSetting.parse("camera_offset:y_mm=10,camera=0")));
    assertThat(v.left()).isGreaterThan(1);
    assertThat(v.leftWithOffsets()).isLessThan(0.05);
    assertThat(v.gain()).isEqualTo(Math.sqrt(1 + v.left() * v.left()) - 1, within(1e-12));
  }

  @Test
  void whatTheDiagnosisGetsIsNoTruth() {
    HiddenCase c =
        MANY.stream()
            .filter(k -> k.hides("robot_kick_bias") && k.category() == Category.SINGLE)
            .findFirst()
            .orElseThrow();
    SeenKicks seen = SeenKicks.of(c.settings());
    DiagnosisProblem problem = HiddenRun.problem(seen, true);
    assertThat(problem.fits()).hasSizeGreaterThan(c.settings().scenario().kicks() / 2);
    assertThat(problem.commands()).hasSizeGreaterThan(problem.fits().size() / 2);
    problem
        .commands()
        .forEach(
            (kick, command) ->
                assertThat(seen.truth().commandedKicks())
                    .anySatisfy(
                        t -> {
                          assertThat(command.speed()).isEqualTo(t.command().speed());
                          assertThat(command.robot()).isEqualTo(t.robot());
                        }));
    assertThat(HiddenRun.problem(seen, false).commands()).isEmpty();
  }
}
