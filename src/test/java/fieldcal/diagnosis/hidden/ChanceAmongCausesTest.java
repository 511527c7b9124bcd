package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallMoment;
import fieldcal.simulation.physics.ExtraLaw;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Balls roll a hundredth farther or less far in each kick: too little to be seen in one of them, and enough to be followed by a drift, a step, a patch and a direction of the carpet together. */
class ChanceAmongCausesTest {
  private static final double SCATTER = 0.015;

  private record Whims(long seed) implements ExtraLaw {
    @Override
    public double rollingFactor(BallMoment m) {
      long kick = Math.round(m.sessionTime() - m.sinceKick());
      return 1 + SCATTER * new SplittableRandom(1000 * seed + kick).nextGaussian();
    }
  }

  private static Diagnosis diagnosed(long seed, String... effects) {
    SimulationSettings world =
        FittedField.SOUND
            .withScenario(ScenarioKind.FLAT, 28)
            .withPhysics(FittedField.SOUND.physics().withExtra(new Whims(seed)))
            .withEffects(effects)
            .withSeed(seed);
    return new Diagnoser().diagnose(FittedField.of(world).problem(), said -> {});
  }

  @Tag("study")
  @Test
  void isNotTakenForOtherCauses() {
    requireOwnScatter(11);
  }

  @Tag("study")
  @Test
  void isNotTakenForOtherCausesInAnotherField() {
    requireOwnScatter(12);
  }

  private static void requireOwnScatter(long seed) {
    Diagnosis diagnosis =
        diagnosed(seed, "slip_dependent_friction:slope=0.13", "camera_offset:camera=1,y_mm=9");
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .containsExactlyInAnyOrder("slip_dependent_friction", "camera_offset");
    LearnedFinding chance = diagnosis.learned().get(0);
    assertThat(chance.kind()).isEqualTo(LearnedFinding.Kind.SCATTER);
    assertThat(chance.scatter()).isCloseTo(SCATTER, within(3 * SCATTER / Math.sqrt(2 * 28)));
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }

  /** What changes from kick to kick in a way of its own has its name beside chance. */
  @Test
  void leavesADriftItsName() {
    requireDrift(21);
  }

  @Tag("study")
  @Test
  void leavesADriftItsNameInAnotherField() {
    requireDrift(22);
  }

  private static void requireDrift(long seed) {
    Diagnosis diagnosis = diagnosed(seed, "drift:percent_per_10min=25");
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .isEqualTo(List.of("drift"));
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }
}
