package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The random-effects mean of DerSimonian and Laird. */
class AverageTest {
  private static final double EXACT = 1e-12;

  @Test
  void ofNothingThereIsNoMean() {
    Average none = Average.of(new double[0], new double[0]);
    assertThat(none.n()).isZero();
    assertThat(none.mean()).isNaN();
    assertThat(none.standardError()).isNaN();
    assertThat(none.scatter()).isNaN();
    assertThat(Average.of(List.of())).isEqualTo(none);
  }

  @Test
  void ofOneSampleItIsTheSample() {
    Average one = Average.of(new double[] {-3.1}, new double[] {0.2});
    assertThat(one.n()).isEqualTo(1);
    assertThat(one.mean()).isEqualTo(-3.1, within(EXACT));
    assertThat(one.standardError()).isEqualTo(0.2, within(EXACT));
    assertThat(one.scatter()).isZero();
  }

  /**
   * By hand: values 1, 2, 6 with errors 1, 1, 2, so weights 1, 1, 1/4. Fixed mean (1 + 2 + 1.5)/2.25 = 2. Q = 1 + 0 + 16/4 = 5. w =
   * 2.25, w2 = 2.0625, τ² = (5 − 2)/(2.25 − 2.0625/2.25) = 3/(4/3) = 2.25. New weights 1/3.25, 1/3.25, 1/6.25; mean = (3/3.25 +
   * 6/6.25)/(2/3.25 + 1/6.25).
   */
  @Test
  void agreesWithACalculationByHand() {
    Average a = Average.of(new double[] {1, 2, 6}, new double[] {1, 1, 2});
    double sum = 2 / 3.25 + 1 / 6.25;
    assertThat(a.scatter()).isEqualTo(1.5, within(EXACT));
    assertThat(a.mean()).isEqualTo((3 / 3.25 + 6 / 6.25) / sum, within(EXACT));
    assertThat(a.standardError()).isEqualTo(1 / Math.sqrt(sum), within(EXACT));
    assertThat(a.n()).isEqualTo(3);
  }

  private static List<Sample> samples(double... values) {
    List<Sample> all = new java.util.ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      all.add(new Sample(i, "dampingXyFirstHop", values[i], 0.004, Optional.empty()));
    }
    return all;
  }

  /** First hops of a simulator that is not ours: without spin 0.71, with spin 0.64 to 0.68. */
  @Test
  void twoSidesGiveTheMedianAndAnErrorThatCoversBoth() {
    List<Sample> two =
        samples(0.71, 0.712, 0.708, 0.711, 0.709, 0.713, 0.707, 0.71, 0.711, 0.64, 0.655, 0.64);
    Average mean = Average.of(two);
    Average robust = mean.robust(two);
    assertThat(mean.mean()).isLessThan(0.697);
    assertThat(robust.mean()).isBetween(0.708, 0.711);
    assertThat(robust.standardError()).isGreaterThan(robust.mean() - mean.mean());
  }

  @Test
  void symmetricSamplesKeepTheirMean() {
    List<Sample> one = samples(0.70, 0.702, 0.698, 0.705, 0.695, 0.701, 0.699);
    Average mean = Average.of(one);
    assertThat(mean.robust(one)).isEqualTo(mean);
    assertThat(Average.of(samples(1, 2)).robust(samples(1, 2)).mean()).isEqualTo(1.5);
  }

  /** Less scatter than the errors explain: τ = 0 and inverse variances, weights 1 and 4. */
  @Test
  void withoutScatterItIsTheInverseVarianceMean() {
    Average a = Average.of(new double[] {1, 1.5}, new double[] {1, 0.5});
    assertThat(a.scatter()).isZero();
    assertThat(a.mean()).isEqualTo((1 + 4 * 1.5) / 5, within(EXACT));
    assertThat(a.standardError()).isEqualTo(1 / Math.sqrt(5), within(EXACT));
  }

  @Test
  void withMuchScatterItApproachesThePlainMean() {
    Average a = Average.of(new double[] {0, 10, 20, 30}, new double[] {0.01, 0.1, 0.01, 0.1});
    assertThat(a.mean()).isEqualTo(15, within(0.02));
    assertThat(a.standardError()).isEqualTo(a.scatter() / 2, within(0.001));
    // The values' own standard deviation is 12.9; the estimate weighs them by their errors.
    assertThat(a.scatter()).isBetween(10.0, 16.0);
  }

  @Test
  void samplesThatWereDroppedDoNotCount() {
    Sample good = new Sample(1, "kSwitch", 0.6, 0.01, Optional.empty());
    Sample bad = new Sample(2, "kSwitch", 9, 0.01, Optional.of("far off"));
    assertThat(Average.of(List.of(good, bad))).isEqualTo(Average.of(List.of(good)));
  }

  @Test
  void theErrorCoversTheTruth() {
    SplittableRandom random = new SplittableRandom(1);
    int inside = 0;
    for (int trial = 0; trial < 2000; trial++) {
      double[] values = new double[20];
      double[] errors = new double[20];
      for (int i = 0; i < 20; i++) {
        errors[i] = random.nextDouble(0.02, 0.3);
        // Kicks differ by 0.1 beyond their errors.
        values[i] = Math.hypot(errors[i], 0.1) * gaussian(random);
      }
      Average a = Average.of(values, errors);
      inside += Math.abs(a.mean()) < a.standardError() ? 1 : 0;
    }
    // τ is estimated from twenty samples, which costs a little coverage.
    assertThat(inside / 2000.0).isEqualTo(0.67, within(0.04));
  }

  @Test
  void sigmasCountTheSamplesErrorAndTheScatter() {
    Average a = new Average(1, 0.1, 0.3, 5);
    assertThat(a.sigmas(new Sample(1, "x", 2, 0.4, Optional.empty()))).isEqualTo(2, within(EXACT));
    assertThat(a.sigmas(new Sample(1, "x", 0, 0.4, Optional.empty()))).isEqualTo(2, within(EXACT));
  }

  static double gaussian(SplittableRandom r) {
    return Math.sqrt(-2 * Math.log(1 - r.nextDouble())) * Math.cos(2 * Math.PI * r.nextDouble());
  }

  /**
   * Kicks that differ by more than their errors: neither what the 2σ rule takes away nor a scatter that few kicks show must make the mean look better known. The truth lies within two errors as often as of a normal distribution. In brackets what it was with the scatter of
   * the samples that are left.
   */
  @ParameterizedTest
  @CsvSource({
    "6, 5", // [92.4 % within two, 97.8 % within three]
    "12, 5", // [92.0 %, 98.9 %]
    "12, 1", // [92.7 %, 99.3 %]
    "24, 1"
  })
  void theErrorCoversWhatTheTwoSigmaRuleTookAway(int kicks, double scatter) {
    SplittableRandom random = new SplittableRandom(12);
    int runs = 1500;
    int within3 = 0;
    int within2 = 0;
    for (int run = 0; run < runs; run++) {
      List<Sample> samples = new ArrayList<>();
      for (int i = 0; i < kicks; i++) {
        double value = scatter * random.nextGaussian() + random.nextGaussian();
        samples.add(new Sample(i, "dampingZ", value, 1, Optional.empty()));
      }
      Average mean = Average.judged(TwoSigma.repeated(samples));
      double sigmas = Math.abs(mean.mean()) / mean.standardError();
      within3 += sigmas <= 3 ? 1 : 0;
      within2 += sigmas <= 2 ? 1 : 0;
    }
    // 95.4 % of 1500 runs are known to 0.54 %, 99.7 % to 0.14 %; Student's tails are longer.
    assertThat(within2 / (double) runs).isBetween(0.937, 0.972);
    assertThat(within3 / (double) runs).isGreaterThan(0.988);
  }

  /** Where the rule excludes one after the other, the few that are left are close together by chance: two errors reach the mean of all. In brackets what it was: 0.024. */
  @Test
  void samplesThatExcludeEachOtherDoNotMakeTheMeanCertain() {
    double[] values = {
      -0.025, -0.015, -0.005, 0.005, 0.015, 0.025, 0.1, 0.17, 0.289, 0.491, 0.835, 1.42
    };
    List<Sample> samples = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      samples.add(new Sample(i, "dampingZ", 1 + values[i], 0.01, Optional.empty()));
    }
    List<Sample> judged = TwoSigma.repeated(samples);
    Average left = Average.of(judged);
    assertThat(left.n()).isEqualTo(6);
    assertThat(left.standardError()).isLessThan(0.01);
    double ofAll = 1 + Arrays.stream(values).average().orElseThrow();
    double error = left.widened(judged).standardError();
    assertThat(2 * error).isGreaterThan(ofAll - left.mean());
  }

  /** A session: kicks without spin agree on 0.688, the others lie lower; their own errors are those of a switch to rolling at 2 to 7 m/s. */
  private static List<Sample> twoSided(SplittableRandom random, int agreeing, double scatter) {
    List<Sample> samples = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double error = 0.0005 * Math.pow(7 / random.nextDouble(2.2, 7), 2.2);
      double other = i < agreeing ? 0 : -0.025 + scatter * random.nextGaussian();
      double value = 0.688 + other + error * random.nextGaussian();
      samples.add(new Sample(i, "kSwitch", value, error, Optional.empty()));
    }
    return samples;
  }

  /**
   * The ball without spin, of which a third to all of twelve kicks tell, lies within two standard errors; so does the mean of all kicks, except where few of them have spin: then the 2σ rule excludes these. In brackets what it was with the median
   * alone.
   */
  @ParameterizedTest
  @CsvSource({
    "4, 0.008, 0.74, 0.96", // [6 and 99 %]
    "4, 0, 0.84, 0.94", // [14 and 93 %]
    "6, 0.008, 0.96, 0.96", // [59 and 99 %]
    "6, 0, 0.98, 0.98", // [95 and 100 %]
    "9, 0.008, 0.98, 0", // [100 %]
    "12, 0, 0.92, 0.92" // [97 and 97 %]
  })
  void theErrorCoversBothSides(int agreeing, double scatter, double ball, double mean) {
    SplittableRandom random = new SplittableRandom(5);
    int runs = 400;
    int coversBall = 0;
    int coversMean = 0;
    for (int run = 0; run < runs; run++) {
      List<Sample> judged = TwoSigma.repeated(twoSided(random, agreeing, scatter));
      Average average = Average.judged(judged);
      double ofAll = 0.688 - 0.025 * (12 - agreeing) / 12;
      coversBall += Math.abs(average.mean() - 0.688) < 2 * average.standardError() ? 1 : 0;
      coversMean += Math.abs(average.mean() - ofAll) < 2 * average.standardError() ? 1 : 0;
    }
    assertThat(coversBall / (double) runs).isGreaterThan(ball);
    assertThat(coversMean / (double) runs).isGreaterThanOrEqualTo(mean);
  }

  /**
   * The values of k_switch of a play on a simulator that is not ours, in their order: kicks without spin agree on 0.688. After ten and eleven kicks the mean was 0.676 ± 0.0062 and 0.679 ± 0.0062, less than 1 %, and the play ended as asked; then, the 2 % were
   * seen.
   */
  @Test
  void onePercentHoldsWhicheverKickIsLeftOut() {
    double[] values = {
      0.6891, 0.6696, 0.6704, 0.6448, 0.6508, 0.6887, 0.6902, 0.6938, 0.6659, 0.6609, 0.6837, 0.6682
    };
    double[] errors = {
      0.0006, 0.0008, 0.0008, 0.0032, 0.0029, 0.0012, 0.0015, 0.0026, 0.0012, 0.0015, 0.0008, 0.0008
    };
    List<Sample> samples = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      samples.add(new Sample(i, "kSwitch", values[i], errors[i], Optional.empty()));
      assertThat(Calibration.leastPrecision(samples)).isGreaterThan(0.01);
    }
    List<Sample> alike = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      alike.add(new Sample(i, "kSwitch", 0.688 + 0.001 * (i % 3), 0.002, Optional.empty()));
    }
    assertThat(Calibration.leastPrecision(alike)).isLessThan(0.002);
    assertThat(Calibration.leastPrecision(alike.subList(0, 2))).isInfinite();
  }
}
