package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.effect.motion.KickSpin;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Flat kicks show (1 − spin)·(1 − kSwitch) and nothing else of the two: what mechanics knows of kSwitch tells them apart, and the error says how well. */
class SpinAndSwitchTest {
  @Test
  void theMeanOfTheSpinHasAnErrorThatCoversWhatFlatKicksCannotTell() {
    FittedField field = FittedField.flats("kick_spin:fraction=-0.2,scatter=0.05");
    FittedModel fitted =
        field
            .fitter()
            .fit(
                field.simple().model().with(List.of(Component.perKick(new KickSpin(0)))),
                field.simple(),
                Weighing.ALIKE,
                FittedField.SOLVER);
    double spin = fitted.effects().get(0).value("fraction");
    double kSwitch = fitted.solution().values()[2];
    double error = fitted.errors(0).orElseThrow().get("fraction");
    // dspin = (1 − spin)/(1 − kSwitch)·dkSwitch, and kSwitch is known to 0.033.
    assertThat(error).isCloseTo((1 - spin) / (1 - kSwitch) * 0.033, within(0.03));
    assertThat(spin).isCloseTo(-0.2, within(2.5 * error));
    assertThat(fitted.solution().reducedChiSquare()).isLessThan(1.1);
  }
}
