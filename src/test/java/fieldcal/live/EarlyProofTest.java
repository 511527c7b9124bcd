package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

class EarlyProofTest {
  private static final long SEED = 5;
  private static final int SERIES = 4000;
  private static final int LONGEST = 30;
  private static final double FALSE_ALARMS = 0.05;

  /** In how many series an alarm is raised, ever, when it may be raised after every sample. */
  private static int alarms(ToDoubleFunction<Random> sample) {
    Random random = new Random(SEED);
    EarlyProof proof = new EarlyProof(FALSE_ALARMS);
    int alarms = 0;
    for (int i = 0; i < SERIES; i++) {
      double[] series = new double[LONGEST];
      Arrays.setAll(series, k -> sample.applyAsDouble(random));
      alarms += samplesUntilAlarm(proof, series) <= LONGEST ? 1 : 0;
    }
    return alarms;
  }

  private static int samplesUntilAlarm(EarlyProof proof, double[] series) {
    for (int n = 1; n <= series.length; n++) {
      if (proof.isAboveZero(Arrays.copyOf(series, n), 1e-6)) {
        return n;
      }
    }
    return series.length + 1;
  }

  @Test
  void keepsItsBudgetWhenAskedAfterEverySample() {
    int most = (int) (FALSE_ALARMS * SERIES);
    assertThat(alarms(Random::nextGaussian)).isBetween(most / 50, most);
    // Other distributions of median and mean zero: of kicks of all speeds, with one in twenty
    // wrong.
    assertThat(alarms(r -> r.nextDouble() - 0.5)).isLessThan(most);
    assertThat(alarms(r -> (r.nextDouble() < 0.05 ? 5 : 1) * r.nextGaussian())).isLessThan(most);
    // A centre below zero.
    assertThat(alarms(r -> r.nextGaussian() - 0.5)).isLessThan(most / 10);
  }

  @Test
  void provesWhatIsClearWithinAFewSamples() {
    // 38 % off with 1 % of scatter: 18 times the scatter beyond a limit of 20 %.
    EarlyProof strict = new EarlyProof(0.001 / 12);
    Random random = new Random(SEED);
    int[] needed = new int[200];
    for (int i = 0; i < needed.length; i++) {
      double[] series = new double[LONGEST];
      Arrays.setAll(series, k -> 0.18 + 0.01 * random.nextGaussian());
      needed[i] = samplesUntilAlarm(strict, series);
    }
    Arrays.sort(needed);
    assertThat(needed[100]).as("seed %d", SEED).isLessThanOrEqualTo(6);
    assertThat(needed[199]).as("seed %d", SEED).isLessThanOrEqualTo(8);
  }

  @Test
  void aWrongSampleDelaysItButDoesNotHideIt() {
    EarlyProof strict = new EarlyProof(0.001 / 12);
    double[] series = new double[LONGEST];
    Arrays.fill(series, 0.18);
    series[1] = -3;
    assertThat(samplesUntilAlarm(strict, series)).isLessThan(25);
  }

  @Test
  void isTheClosedFormOfBothLikelihoodRatios() {
    // Two samples 1 ± 1: t² = 1·2/2 = 1, ν = 1.
    double student = 0;
    for (double g : new double[] {1, 10, 100}) {
      double spread = 1 + 2 * g;
      student += 2 / (1 + 1 / spread) / Math.sqrt(spread) / 3;
    }
    // k = 1 of 2: 8 ∫ q(1−q) from ½ to 1 = 8/12.
    double expected = Math.log(0.5 * student + 0.5 * 8 / 12);
    assertThat(EarlyProof.logEvidence(new double[] {1 + 1, 1 - 1 - 1e-12}, 0))
        .isCloseTo(expected, within(1e-9));
    assertThat(EarlyProof.logEvidence(new double[] {1, -2}, 0)).isNegative().isInfinite();
    assertThat(EarlyProof.logEvidence(new double[] {1}, 0)).isNegative().isInfinite();
  }

  @Test
  void neverBelievesASmallerScatterThanTheErrors() {
    double[] alike = {0.1, 0.1, 0.1, 0.1, 0.1};
    assertThat(EarlyProof.logEvidence(alike, 0.1))
        .isLessThan(EarlyProof.logEvidence(alike, 0.001))
        .isLessThan(3);
  }
}
