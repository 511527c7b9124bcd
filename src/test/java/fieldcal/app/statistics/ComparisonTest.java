package fieldcal.app.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.statistics.Statistic.How;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Comparisons of drawn samples: what is the same is seldom said to differ, what differs is found. */
class ComparisonTest {
  private static final int STATISTICS = 40;
  private static final int SAMPLES = 24;

  private static Statistic statistic(
      int number, How how, Random random, double shift, double scale) {
    Map<String, Double> samples = new HashMap<>();
    for (int i = 0; i < SAMPLES; i++) {
      samples.put("kick " + i, 5 + shift + scale * random.nextGaussian());
    }
    return new Statistic("s" + number, "statistic " + number, "m", how, samples);
  }

  private static List<Statistic> drawn(
      Random random, How how, int odd, double shift, double scale) {
    List<Statistic> all = new ArrayList<>();
    for (int s = 0; s < STATISTICS; s++) {
      all.add(statistic(s, how, random, s == odd ? shift : 0, s == odd ? scale : 1));
    }
    return all;
  }

  /** Of 200 pairs of equal recordings at most 5 % may show any difference; 5 % and three binomial errors are allowed. */
  @ParameterizedTest
  @EnumSource(How.class)
  void equalRecordingsSeldomDiffer(How how) {
    Random random = new Random(17);
    int wrong = 0;
    int pairs = 200;
    for (int i = 0; i < pairs; i++) {
      List<Comparison> compared =
          Comparison.of(drawn(random, how, -1, 0, 1), drawn(random, how, -1, 0, 1));
      assertThat(compared).hasSize(STATISTICS);
      wrong += compared.stream().anyMatch(Comparison::differs) ? 1 : 0;
    }
    assertThat(wrong / (double) pairs)
        .isLessThan(Comparison.ALPHA + 3 * Math.sqrt(0.05 * 0.95 / pairs));
  }

  @ParameterizedTest
  @EnumSource(How.class)
  void theOneThatDiffersIsFoundAmongAll(How how) {
    Random random = new Random(4);
    boolean scatter = how == How.SCATTER;
    List<Comparison> compared =
        Comparison.of(
            drawn(random, how, -1, 0, 1),
            drawn(random, how, 7, scatter ? 0 : 2.5, scatter ? 8 : 1));
    assertThat(compared.stream().filter(Comparison::differs).map(c -> c.statistic().id()))
        .containsExactly("s7");
    Comparison found = compared.get(7);
    if (!scatter) {
      assertThat(Math.abs(found.difference() - 2.5)).isLessThan(3 * found.error());
    }
  }

  @Test
  void whatIsTheSameToTheBitDoesNotDiffer() {
    Map<String, Double> zeros = new HashMap<>();
    for (int i = 0; i < SAMPLES; i++) {
      zeros.put("block " + i, 0.0);
    }
    for (How how : How.values()) {
      Statistic lost = new Statistic("lost", "lost frames", "%", how, zeros);
      assertThat(Comparison.of(List.of(lost), List.of(lost)))
          .singleElement()
          .matches(c -> c.p() == 1 && !c.differs());
    }
  }

  @Test
  void tooFewSamplesAreNotCompared() {
    Map<String, Double> few = Map.of("a", 1.0, "b", 2.0, "c", Double.NaN);
    Statistic one = new Statistic("few", "few", "", How.LEVEL, few);
    assertThat(one.samples()).hasSize(2);
    assertThat(Comparison.of(List.of(one), List.of(one))).isEmpty();
  }

  /** Most stretches lose no frame, so that both medians are zero, though one camera loses twice as many. */
  @Test
  void whatIsMostlyZeroIsShownAsAMean() {
    Map<String, Double> few = new HashMap<>();
    Map<String, Double> many = new HashMap<>();
    for (int i = 0; i < 100; i++) {
      few.put("stretch " + i, i % 20 == 0 ? 1.0 : 0);
      many.put("stretch " + i, i % 4 == 0 ? 1.0 : 0);
    }
    Comparison c =
        Comparison.of(
                List.of(new Statistic("lost.3", "lost frames", "%", How.LEVEL, few)),
                List.of(new Statistic("lost.3", "lost frames", "%", How.LEVEL, many)))
            .get(0);
    assertThat(c.differs()).isTrue();
    assertThat(c.first()).isCloseTo(0.05, within(1e-12));
    assertThat(c.second()).isCloseTo(0.25, within(1e-12));
    assertThat(c.difference()).isCloseTo(0.2, within(1e-12));
    assertThat(c.error()).isBetween(0.03, 0.07);
  }
}
