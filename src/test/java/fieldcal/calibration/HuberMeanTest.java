package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Huber's Proposal 2 with errors of the samples' own. */
class HuberMeanTest {
  private static final double SETTLED = 1e-6;

  private static double[] alike(int n, double value) {
    double[] all = new double[n];
    Arrays.fill(all, value);
    return all;
  }

  /** Nothing is cut: weights 1 and 4, and as much scatter as the errors explain. */
  @Test
  void withoutScatterItIsTheInverseVarianceMean() {
    HuberMean mean = HuberMean.of(new double[] {1, 1.5}, new double[] {1, 0.5});
    assertThat(mean.scatter()).isZero();
    assertThat(mean.mean()).isEqualTo(1.4, within(SETTLED));
    assertThat(mean.standardError()).isEqualTo(1 / Math.sqrt(5), within(SETTLED));
  }

  /** By hand: −1, 0 and 1 are squares of 2, which have to be 2 · 0.9205 of the variance; none lies beyond two standard deviations. */
  @Test
  void theScatterIsThatAtWhichTheSquaresAreAsExpected() {
    HuberMean mean = HuberMean.of(new double[] {-1, 0, 1}, alike(3, 0.1));
    assertThat(mean.mean()).isEqualTo(0, within(SETTLED));
    double variance = 2 / (2 * 0.920_538);
    assertThat(mean.scatter()).isEqualTo(Math.sqrt(variance - 0.01), within(1e-4));
    assertThat(mean.standardError()).isEqualTo(Math.sqrt(variance / 3), within(1e-4));
  }

  @Test
  void aSampleFarOffCountsAsOneAtTwoStandardDeviations() {
    double[] values = {-1.2, -0.7, -0.3, 0, 0.2, 0.5, 0.8, 1.1, -0.5, 0.1, 0.4, 50};
    double[] farther = values.clone();
    farther[11] = 5000;
    HuberMean mean = HuberMean.of(values, alike(12, 0.1));
    HuberMean same = HuberMean.of(farther, alike(12, 0.1));
    assertThat(same.mean()).isEqualTo(mean.mean(), within(1e-4));
    assertThat(same.scatter()).isEqualTo(mean.scatter(), within(1e-4));
    assertThat(mean.mean()).isBetween(0.0, 0.3);
    assertThat(mean.scatter()).isBetween(0.6, 1.2);
  }

  /** Of normal samples neither mean nor scatter is off, and the error of the mean is what it is said to be. */
  @Test
  void normalSamplesHaveTheirScatterAndTheErrorThatIsGiven() {
    SplittableRandom random = new SplittableRandom(3);
    int runs = 1500;
    double squares = 0;
    double said = 0;
    double variance = 0;
    for (int run = 0; run < runs; run++) {
      double[] values = new double[12];
      double[] errors = new double[12];
      for (int i = 0; i < 12; i++) {
        errors[i] = random.nextDouble(0.1, 1);
        values[i] = Math.hypot(errors[i], 1) * random.nextGaussian();
      }
      HuberMean mean = HuberMean.of(values, errors);
      squares += mean.mean() * mean.mean() / runs;
      said += mean.standardError() * mean.standardError() / runs;
      variance += mean.scatter() * mean.scatter() / runs;
    }
    // A variance of 1500 runs is known to √(2/1500) = 3.7 %.
    assertThat(squares / said).isEqualTo(1, within(0.12));
    assertThat(variance).isEqualTo(1, within(0.12));
  }
}
