package fieldcal.app.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The rank-sum test against countable cases and drawn ones. */
class RankSumTest {
  /** Of the 20 ways to choose three of six ranks, two lie as far apart as 1, 2, 3 against 4, 5, 6. */
  @Test
  void fewSamplesAreCountedOut() {
    assertThat(RankSum.p(new double[] {1, 2, 3}, new double[] {4, 5, 6}))
        .isCloseTo(2.0 / 20, within(1e-12));
    assertThat(RankSum.p(new double[] {1, 2, 4}, new double[] {3, 5, 6}))
        .isCloseTo(4.0 / 20, within(1e-12));
  }

  /** Of the 15 ways to choose two of six, six take one of the two ones that are not zero each; one takes both, one of 15. */
  @Test
  void equalSamplesAreCountedOut() {
    double[] zeros = {0, 0, 0, 0};
    assertThat(RankSum.p(new double[] {1, 1}, zeros)).isCloseTo(1.0 / 15, within(1e-12));
    assertThat(RankSum.p(zeros, zeros)).isEqualTo(1);
    assertThat(RankSum.p(new double[40], new double[40])).isEqualTo(1);
  }

  /** A camera that misses a ball in half of the stretches, against one that never does: equal zeros must not hide it. */
  @Test
  void zerosDoNotHideADifference() {
    double[] never = new double[20];
    double[] half = new double[20];
    Arrays.setAll(half, i -> i % 2);
    assertThat(RankSum.p(never, half)).isLessThan(1e-3);
  }

  /** Three binomial errors of 2000 draws. */
  @Test
  void manyEqualSamplesAreAsProbableAsSaid() {
    Random random = new Random(5);
    int below = 0;
    int draws = 2000;
    for (int i = 0; i < draws; i++) {
      double[] a = random.doubles(30).map(u -> u < 0.7 ? 0 : u).toArray();
      double[] b = random.doubles(25).map(u -> u < 0.7 ? 0 : u).toArray();
      below += RankSum.p(a, b) < 0.05 ? 1 : 0;
    }
    assertThat(below / (double) draws).isCloseTo(0.05, within(3 * Math.sqrt(0.05 * 0.95 / draws)));
  }

  @Test
  void holmCorrectsFromTheSmallestOn() {
    assertThat(Holm.corrected(0.04, 0.01, Double.NaN, 0.03))
        .containsExactly(0.06, 0.03, Double.NaN, 0.06);
  }
}
