package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.BallPhysics;
import org.junit.jupiter.api.Test;

/** A ball that goes on hopping below the league's 10 mm has no cause of anything: it follows the same dampings. */
class LowHopsTest {
  private static final double NOISE = 0.002;

  private static SimulationSettings hopping(double lowestHop, double noise) {
    BallPhysics ball = FittedField.SOUND.physics();
    return FittedField.SOUND
        .withScenario(ScenarioKind.MIXED, 16)
        .withCameras(CameraSettings.DEFAULT.withCount(2).withNoise(noise, 0.0035))
        .withPhysics(ball.withImpact(ball.impact().withMinHopHeight(lowestHop)));
  }

  private static Diagnosis diagnosed(SimulationSettings world) {
    return new Diagnoser().diagnose(FittedField.of(world).problem(), said -> {});
  }

  private static void assertSound(Diagnosis diagnosis, double lowestHop) {
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.MODEL_ADEQUATE);
    assertThat(diagnosis.model().effects()).isEmpty();
    assertThat(diagnosis.model().chip().orElseThrow().lowestHop()).isEqualTo(lowestHop);
  }

  @Test
  void areNoCause() {
    assertSound(diagnosed(hopping(5e-4, NOISE)), 5e-4);
  }

  @Test
  void areNotFoundWhereThereAreNone() {
    assertSound(diagnosed(hopping(0.01, NOISE)), 0.01);
  }

  /** Two causes were found here when the heights that were tried lay a whole bounce apart. */
  @Test
  void areNoCauseInBetweenWithLittleNoise() {
    Diagnosis diagnosis = diagnosed(hopping(1e-3, 0.0014).withSeed(3));
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.MODEL_ADEQUATE);
    assertThat(diagnosis.model().effects()).isEmpty();
    assertThat(diagnosis.model().chip().orElseThrow().lowestHop()).isBetween(7e-4, 1.5e-3);
  }

  /** Noise of 4 mm hides the lowest hops themselves, but not what they cost. */
  @Test
  void areNoCauseInBetween() {
    Diagnosis diagnosis = diagnosed(hopping(1e-3, 0.004));
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.MODEL_ADEQUATE);
    assertThat(diagnosis.model().effects()).isEmpty();
    assertThat(diagnosis.model().chip().orElseThrow().dampingXyOtherHops())
        .isCloseTo(0.95, within(0.005));
  }
}
