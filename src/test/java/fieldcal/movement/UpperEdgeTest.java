package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which heap of manoeuvres is the limit. */
class UpperEdgeTest {
  private static final double LIMIT = 5;
  private static final int MANOEUVRES = 1200;

  private static UpperEdge edge(double[] values, double[] errors) {
    double[] once = new double[values.length];
    Arrays.fill(once, 1);
    return UpperEdge.of(values, errors, once);
  }

  /** As matches of robots that brake hard and accelerate weakly have them: one manoeuvre of seven is measured too strong by several per cent, more than its error says. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void piecesThatWereCutWronglyAreNoLimitOfTheirOwn(long seed) {
    Random random = new Random(seed);
    double[] values = new double[MANOEUVRES];
    double[] errors = new double[MANOEUVRES];
    for (int i = 0; i < MANOEUVRES; i++) {
      boolean wrong = random.nextDouble() < 0.14;
      errors[i] = LIMIT * (wrong ? 0.015 : 0.009);
      values[i] = LIMIT * (wrong ? 1.055 : 1) + 0.7 * errors[i] * random.nextGaussian();
    }
    UpperEdge found = edge(values, errors);
    assertThat(found.value()).isEqualTo(LIMIT, within(0.01 * LIMIT));
    assertThat(found.share()).isGreaterThan(0.5);
    // Nobody knows that these were cut wrongly: two errors reach to where they are.
    assertThat(found.value() + 2.5 * found.error()).isGreaterThan(1.045 * LIMIT);
  }

  /** Few are well measured, and these are weak ones. */
  @ParameterizedTest
  @ValueSource(ints = {20, 60, 110})
  void theWellMeasuredDoNotSpeakForAllOthers(int well) {
    Random random = new Random(7);
    double[] values = new double[MANOEUVRES];
    double[] errors = new double[MANOEUVRES];
    for (int i = 0; i < MANOEUVRES; i++) {
      errors[i] = LIMIT * (i < well ? 0.025 : 0.05);
      values[i] = LIMIT * (i < well ? 0.9 : 1) + errors[i] * random.nextGaussian();
    }
    assertThat(edge(values, errors)).isNull();
  }
}
