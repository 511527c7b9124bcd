package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import org.junit.jupiter.api.Test;

/** Kicks of a field with strong drag that the simple model does not have. */
class WeighingTest {
  private final FittedModel wrong = FittedField.flats("air_drag:cd=0.45").simple();

  @Test
  void unexplainedKicksWeighLessTheMoreSo() {
    double[] first = Weighing.EXPLAINED_FIRST.of(wrong);
    double[] between = Weighing.BETWEEN.of(wrong);
    double[] alike = Weighing.ALIKE.of(wrong);
    int unexplained = 0;
    for (int k = 0; k < wrong.kickCount(); k++) {
      double left = Math.max(1, wrong.reduced(k));
      unexplained += left > 2 ? 1 : 0;
      assertThat(first[k] * left).isCloseTo(1, within(1e-12));
      assertThat(between[k] * between[k] * left).isCloseTo(1, within(1e-12));
      assertThat(alike[k]).isEqualTo(1);
    }
    assertThat(unexplained).isPositive();
  }
}
