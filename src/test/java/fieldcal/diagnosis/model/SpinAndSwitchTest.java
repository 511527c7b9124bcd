package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.motion.KickSpin;
import fieldcal.fit.joint.SharedSolution.StopReason;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Flat kicks show (1 − spin)·(1 − kSwitch) and nothing else of the two: what mechanics knows of kSwitch tells them apart, and the error says how well. */
class SpinAndSwitchTest {
  @Test
  void theMeanOfTheSpinHasAnErrorThatCoversWhatFlatKicksCannotTell() {
    FittedModel fitted = fit("kick_spin:fraction=-0.2,scatter=0.05");
    double spin = fitted.effects().get(0).value("fraction");
    double kSwitch = fitted.solution().values()[2];
    double error = fitted.errors(0).orElseThrow().get("fraction");
    // dspin = (1 − spin)/(1 − kSwitch)·dkSwitch; the mean of ten kicks errs beside it.
    double mechanics = (1 - spin) / (1 - kSwitch) * BallKnowledge.mechanicalSwitch().deviation();
    assertThat(error).isCloseTo(Math.hypot(mechanics, 0.05 / Math.sqrt(10)), within(0.01));
    assertThat(spin).isCloseTo(-0.2, within(2.5 * error));
    assertThat(fitted.solution().reducedChiSquare()).isLessThan(1.1);
  }

  @Test
  void theValleyBetweenTheTwoIsWalkedToItsEnd() {
    FittedModel fitted = fit("kick_spin:fraction=-0.5,scatter=0.12");
    assertThat(fitted.solution().stopReason()).isEqualTo(StopReason.CONVERGED);
    BallKnowledge known = BallKnowledge.mechanicalSwitch();
    // Nothing but what is known of kSwitch says where in the valley the ball is, and the scatter,
    // which grows with it.
    assertThat(fitted.solution().values()[2]).isCloseTo(known.mean(), within(known.deviation()));
    double error = fitted.errors(0).orElseThrow().get("fraction");
    assertThat(fitted.effects().get(0).value("fraction")).isCloseTo(-0.5, within(2.5 * error));
  }

  private static FittedModel fit(String effects) {
    FittedField field = FittedField.flats(effects);
    return field
        .fitter()
        .fit(
            field.simple().model().with(List.of(Component.perKick(new KickSpin(0)))),
            field.simple(),
            Weighing.ALIKE,
            FittedField.SOLVER);
  }
}
