package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
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
    List<KickFit> fits = new ArrayList<>(field.problem().fits());
    Kick kick = fits.get(WHICH).kick();
    Kick touched = MovedBall.shifted(kick, t -> ACROSS * Math.max(0, t - TOUCH));
    fits.set(WHICH, field.fit(touched, KickKind.FLAT));
    Diagnosis diagnosis = new Diagnoser().diagnose(field.problem(fits), said -> {});
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .containsExactlyInAnyOrder("kick_spin", "worn_region");
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
  }

  /** Gusts push four of fourteen balls aside, each at another time, 1 m/s² for up to a second: more kicks than may be left out. */
  private static FittedField gusts(String... effects) {
    return FittedField.of(
            FittedField.SOUND.withScenario(ScenarioKind.FLAT, 14).withEffects(effects))
        .withGusts(2, 5, 8, 11);
  }

  @Tag("study")
  @Test
  void gustsHideNoCause() {
    FittedField field = gusts("speed_dependent_roll:slope=0.08");
    Diagnosis diagnosis = new Diagnoser().diagnose(field.problem(), said -> {});
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .containsExactly("speed_dependent_roll");
    assertThat(diagnosis.kicks()).hasSize(14);
    assertThat(diagnosis.extended().noiseMm()).isEqualTo(diagnosis.base().noiseMm(), within(1e-9));
    assertThat(diagnosis.unexplained().significant()).isTrue();
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.PARTLY_EXPLAINED);
  }

  @Test
  void gustsAloneHaveNoName() {
    Diagnosis diagnosis = new Diagnoser().diagnose(gusts().problem(), said -> {});
    assertThat(diagnosis.causes()).as("%s", diagnosis.trace()).isEmpty();
    assertThat(diagnosis.unexplained().significant()).isTrue();
    assertThat(diagnosis.extended().holdoutRmsMm())
        .isLessThanOrEqualTo(diagnosis.base().holdoutRmsMm());
  }
}
