package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.truth.KickTruth;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Where balls roll as the model does not know, chips are still chips: what they do before they roll tells them from flat kicks. */
class KindOfKickTest {
  private static final int KICKS = 16;
  private static final double SAME_KICK = 0.2;

  @ParameterizedTest
  @ValueSource(
      strings = {"worn_region:change=0.6,region=[-3,1,-3,1]", "speed_dependent_roll:slope=0.05"})
  void isFoundWhateverTheBallRollsOn(String effect) {
    SimulationSettings world =
        SimulationSettings.DEFAULT
            .withScenario(ScenarioKind.MIXED, KICKS)
            .withSeed(28)
            .withEffects(effect);
    SeenKicks seen = SeenKicks.of(world);
    List<KickTruth> passes = seen.truth().commandedKicks();
    List<String> wrong = new ArrayList<>();
    int known = 0;
    double worst = 0;
    for (KickFit fit : HiddenRun.problem(seen, false).fits()) {
      for (KickTruth pass : passes) {
        if (Math.abs(pass.time() - fit.kick().time()) < SAME_KICK) {
          known++;
          worst = fit.kind() == KickKind.CHIP ? Math.max(worst, fit.rmsMm()) : worst;
          if (!pass.kind().name().equals(fit.kind().name())) {
            wrong.add(fit.toString());
          }
        }
      }
    }
    assertThat(known).isEqualTo(KICKS);
    assertThat(wrong).isEmpty();
    // Held at the rolling of the flat kicks some of them are 18 to 57 mm off.
    assertThat(worst).isLessThan(10);
  }
}
