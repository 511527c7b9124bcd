package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Samples that agree within their errors beside others, and samples about one mean that must not look so. */
class AgreementTest {
  /** As drawn samples, {@code sides} of two: these about 0, the others about −0.025 with a scatter. Errors as those of a switch to rolling: 0.0005 at 7 m/s, 0.007 at 2. */
  private static double[][] sides(SplittableRandom random, int n, int agreeing, double scatter) {
    double[][] drawn = new double[2][n];
    for (int i = 0; i < n; i++) {
      drawn[1][i] = 0.0005 * Math.pow(7 / random.nextDouble(2.2, 7), 2.2);
      double other = i < agreeing ? 0 : -0.025 + scatter * random.nextGaussian();
      drawn[0][i] = 0.688 + other + drawn[1][i] * random.nextGaussian();
    }
    return drawn;
  }

  /** By number of samples and their errors in units of the scatter; 0: different errors, from 0.02 to 0.6. */
  @ParameterizedTest
  @CsvSource({
    "6, 0.003",
    "6, 0.1",
    "6, 0.3",
    "6, 0",
    "12, 0.01",
    "12, 0.03",
    "12, 0.3",
    "12, 0",
    "24, 0.01",
    "24, 0.1",
    "24, 0",
    "48, 0.003",
    "48, 0.03"
  })
  void aScatterAboutOneMeanIsSeldomTakenForTwoSides(int n, double error) {
    SplittableRandom random = new SplittableRandom(17);
    int sets = 500;
    int found = 0;
    for (int set = 0; set < sets; set++) {
      double[] errors = new double[n];
      double[] values = new double[n];
      for (int i = 0; i < n; i++) {
        errors[i] = error > 0 ? error : Math.exp(random.nextDouble(Math.log(0.02), Math.log(0.6)));
        values[i] = Math.hypot(1, errors[i]) * random.nextGaussian();
      }
      found += Agreement.of(values, errors).isPresent() ? 1 : 0;
    }
    // 2000 sets of each row: 0.2 to 7 %; the error of 500 is 1 %.
    assertThat(found / (double) sets).isLessThan(0.09);
  }

  @Test
  void errorsAloneAreNoSecondSide() {
    SplittableRandom random = new SplittableRandom(3);
    int found = 0;
    for (int set = 0; set < 500; set++) {
      double[][] drawn = sides(random, 12, 12, 0);
      found += Agreement.of(drawn[0], drawn[1]).isPresent() ? 1 : 0;
    }
    assertThat(found).isLessThan(10);
  }

  @ParameterizedTest
  @CsvSource({
    "8, 4, 0.008, 0.75", // [85 %]
    "12, 4, 0.008, 0.7",
    "12, 6, 0.008, 0.9",
    "12, 9, 0.008, 0.9",
    "24, 8, 0.008, 0.7",
    "12, 6, 0, 0.9"
  })
  void whatSomeAgreeOnIsFound(int n, int agreeing, double scatter, double share) {
    SplittableRandom random = new SplittableRandom(4);
    int found = 0;
    for (int set = 0; set < 300; set++) {
      double[][] drawn = sides(random, n, agreeing, scatter);
      Optional<Agreement> agreement = Agreement.of(drawn[0], drawn[1]);
      // Of two groups that both agree, either may be called the one that does.
      found +=
          agreement
                  .filter(
                      a ->
                          Math.abs(a.value() - 0.688) < 0.004
                              || a.othersAgree() && Math.abs(a.others() - 0.688) < 0.004)
                  .isPresent()
              ? 1
              : 0;
    }
    assertThat(found / 300.0).isGreaterThan(share);
  }

  @Test
  void twoGroupsAreTold() {
    double[] values = {0.711, 0.7108, 0.7112, 0.7109, 0.667, 0.6672, 0.6668, 0.6671};
    double[] errors = new double[8];
    Arrays.fill(errors, 0.0005);
    Agreement agreement = Agreement.of(values, errors).orElseThrow();
    assertThat(agreement.share()).isEqualTo(0.5, within(0.01));
    assertThat(agreement.othersAgree()).isTrue();
    assertThat(agreement.value() + agreement.others()).isEqualTo(0.711 + 0.667, within(0.001));
  }

  /** Sliding decelerations of ER-Force's ball: slow kicks, whose errors are five times as large, lie to one side by what the model lacks. */
  @Test
  void othersThatAreDeterminedMuchWorseAreNoGroup() {
    double[] values = new double[24];
    double[] errors = new double[24];
    for (int i = 0; i < 24; i++) {
      boolean slow = i < 10;
      errors[i] = slow ? 0.1 : 0.02;
      values[i] = (slow ? -4.33 : -3.92) + errors[i] * (i % 3 - 1) / 2;
    }
    Agreement agreement = Agreement.of(values, errors).orElseThrow();
    assertThat(agreement.value()).isEqualTo(-3.92, within(0.01));
    assertThat(agreement.others()).isEqualTo(-4.33, within(0.05));
    assertThat(agreement.othersAgree()).isFalse();
    Arrays.fill(errors, 0.05);
    assertThat(Agreement.of(values, errors).orElseThrow().othersAgree()).isTrue();
  }

  @Test
  void twoSamplesThatAgreeAreChance() {
    double[] values = {1, 1, 3, -4, 7, 12, -9, 5};
    double[] errors = IntStream.range(0, 8).mapToDouble(i -> 1e-4).toArray();
    assertThat(Agreement.of(values, errors)).isEmpty();
    assertThat(Agreement.of(new double[5], new double[] {1, 1, 1, 1, 1})).isEmpty();
    assertThat(Agreement.of(new double[0], new double[0])).isEmpty();
  }

  /** Samples that are all the same leave no scatter at all. */
  @Test
  void equalSamplesScatterAboutOneMean() {
    double[] same = new double[8];
    double[] errors = new double[8];
    Arrays.fill(same, 0.7);
    Arrays.fill(errors, 0.01);
    assertThat(Agreement.of(same, errors)).isEmpty();
  }
}
