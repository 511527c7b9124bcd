package fieldcal.app.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** How probabilities pay for their number. */
class HolmTest {
  @Test
  void theSmallestPaysForAllTheNextForOneLess() {
    // The example of Holm (1979) with three tests.
    assertThat(Holm.corrected(0.01, 0.02, 0.04)).containsExactly(0.03, 0.04, 0.04);
  }

  @Test
  void whatWasNotTestedDoesNotPay() {
    assertThat(Holm.corrected(Double.NaN, 0.01)).containsExactly(Double.NaN, 0.01);
  }

  @Test
  void familiesThatAreReadTogetherPayTogether() {
    double[] first = {0.02, Double.NaN};
    double[] second = {};
    double[] third = {0.01, 0.04};
    double[][] together = Holm.together(first, second, third);
    assertThat(together[0]).containsExactly(0.04, Double.NaN);
    assertThat(together[1]).isEmpty();
    assertThat(together[2]).containsExactly(0.03, 0.04);
  }
}
