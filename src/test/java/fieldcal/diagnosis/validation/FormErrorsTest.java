package fieldcal.diagnosis.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.simulation.ScenarioKind;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Numbers of laws that are right and of laws that are not. */
class FormErrorsTest {
  private static final int KICKS = 20;

  private static FittedModel fitted(String effect, Component... components) {
    FittedField field =
        FittedField.of(
            FittedField.SOUND.withScenario(ScenarioKind.FLAT, KICKS).withEffects(effect));
    FittedModel simple = field.simple();
    return field
        .fitter()
        .fit(simple.resumedWith(List.of(components)), simple, Weighing.ALIKE, FittedField.SOLVER);
  }

  private static Component slope() {
    SpeedDependentRoll law = new SpeedDependentRoll(0.05);
    return Component.of(law, law.magnitudes());
  }

  @Test
  void aLawThatIsRightHasNone() {
    FittedModel right = fitted("speed_dependent_roll:slope=0.05", slope());
    double[] variances = FormErrors.variances(right);
    double error = right.errors(0).orElseThrow().get("slope");
    assertThat(variances).hasSize(right.model().globals().size());
    assertThat(variances[right.model().offset(0)]).isLessThan(9 * error * error);
    assertThat(Arrays.stream(variances).filter(v -> v > 0).count()).isLessThan(3);
  }

  /** A deceleration that grows with the square of the speed has another slope for fast and for slow balls. */
  @Test
  void aLawOfAnotherFormIsLessCertainThanItsNoise() {
    FittedModel wrong = fitted("unnamed_roll_square:slope=0.02", slope());
    double[] variances = FormErrors.variances(wrong);
    double error = wrong.errors(0).orElseThrow().get("slope");
    double more = wrong.errors(0, variances).orElseThrow().get("slope");
    assertThat(more).isGreaterThan(2 * error);
    assertThat(more)
        .isCloseTo(Math.sqrt(error * error + variances[wrong.model().offset(0)]), within(1e-9));
  }

  @Test
  void fewKicksShowNothing() {
    FittedField few = FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 6));
    assertThat(FormErrors.variances(few.simple())).containsOnly(0);
  }
}
