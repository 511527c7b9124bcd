package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** One kick among many is no free ball, and nobody noticed: it leaves more than all others together. */
class TouchedKickTest {
  private static final int WHICH = 5;

  /** After 0.8 s a robot turns the ball aside, 3 m/s across its way. */
  private static final double TOUCH = 0.8;

  private static final double ACROSS = 3;

  @Test
  void hidesNoCause() {
    FittedField field =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 14)
                .withEffects(
                    "kick_spin:fraction=-0.3,scatter=0.1",
                    "worn_region:change=0.3,region=[0.6,3.4,-3,1.2]"));
    DiagnosisProblem sound = field.problem();
    Kick kick = sound.fits().get(WHICH).kick();
    Kick touched = MovedBall.shifted(kick, t -> ACROSS * Math.max(0, t - TOUCH));
    List<KickFit> fits = new ArrayList<>(sound.fits());
    fits.set(
        WHICH,
        new KickFitter(FitSettings.defaults())
            .fit(
                FitProblem.of(
                    touched,
                    field.noise().cameras(),
                    field.simple().solution().state().flat(),
                    field.simple().solution().state().chip()),
                KickKind.FLAT));
    Diagnosis diagnosis = new Diagnoser().diagnose(with(sound, fits), said -> {});
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .containsExactlyInAnyOrder("kick_spin", "worn_region");
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
  }

  private static DiagnosisProblem with(DiagnosisProblem problem, List<KickFit> fits) {
    return new DiagnosisProblem(
        fits,
        problem.cameras(),
        problem.observers(),
        problem.sessionStart(),
        problem.commands(),
        problem.maxCauses(),
        problem.seed());
  }
}
