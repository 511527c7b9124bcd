package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.diagnosis.Unexplained;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The sentence that says when a difference may be none. */
class CompareWordsTest {
  private static final List<Named> ONE =
      List.of(new Named("accRoll", "rolling", "m/s²", -0.3, 0.01, -0.2, 0.01, 1, 1));

  private static Unexplained left(double millimetres) {
    return new Unexplained(millimetres > 0, millimetres, 9, List.of());
  }

  @Test
  void aSideThatIsNotExplainedIsNamedWithItsSize() {
    assertThat(CompareWords.doubt(ONE, left(0.7), left(0)))
        .isEqualTo(
            " In the residuals of the field, 0.70 mm have no known cause: a difference may come"
                + " from that.");
    assertThat(CompareWords.doubt(ONE, left(0.7), left(1.25)))
        .contains("both sides")
        .contains("1.3");
    assertThat(CompareWords.doubt(ONE, left(0), left(0))).isEmpty();
    assertThat(CompareWords.doubt(List.of(), left(1), left(1))).isEmpty();
  }
}
