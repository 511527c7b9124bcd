package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallPhysics;
import org.junit.jupiter.api.Test;

/** A ball that goes on hopping below the league's 10 mm has no cause of anything: it follows the same dampings. */
class LowHopsTest {
  private static Diagnosis diagnosed(double lowestHop) {
    BallPhysics ball = FittedField.SOUND.physics();
    SimulationSettings world =
        FittedField.SOUND
            .withScenario(ScenarioKind.MIXED, 16)
            .withPhysics(ball.withImpact(ball.impact().withMinHopHeight(lowestHop)));
    return new Diagnoser().diagnose(FittedField.of(world).problem(), said -> {});
  }

  private static void assertSound(Diagnosis diagnosis, double lowestHop) {
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.MODEL_ADEQUATE);
    assertThat(diagnosis.model().effects()).isEmpty();
    assertThat(diagnosis.model().chip().orElseThrow().lowestHop()).isEqualTo(lowestHop);
  }

  @Test
  void areNoCause() {
    assertSound(diagnosed(5e-4), 5e-4);
  }

  @Test
  void areNotFoundWhereThereAreNone() {
    assertSound(diagnosed(0.01), 0.01);
  }
}
