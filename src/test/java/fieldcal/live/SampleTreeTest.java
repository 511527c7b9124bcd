package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SampleTreeTest {
  private static BallSample sample(double time, double value) {
    return new BallSample(time, value, 0.01, false);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void isTheSortedNewestOfARandomSeries(long seed) {
    Random random = new Random(seed);
    SampleTree tree = new SampleTree(SampleTree.ENOUGH);
    List<Double> all = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      // Few different values, so that many are equal.
      double value = random.nextInt(8);
      all.add(value);
      tree.add(sample(i, value));
      List<Double> newest = new ArrayList<>(all.subList(Math.max(0, i - 30), i + 1));
      assertThat(tree.samples().stream().map(BallSample::value)).isEqualTo(newest);
      Collections.sort(newest);
      int n = newest.size();
      assertThat(tree.median())
          .as("seed %d, sample %d", seed, i)
          .isEqualTo(0.5 * (newest.get((n - 1) / 2) + newest.get(n / 2)));
      assertThat(tree.quantile(0)).isEqualTo(newest.get(0));
      assertThat(tree.quantile(1)).isEqualTo(newest.get(n - 1));
      assertThat(tree.enough()).isEqualTo(i >= 30);
    }
  }

  @Test
  void equalValuesAllCount() {
    SampleTree tree = new SampleTree(SampleTree.ENOUGH);
    IntStream.range(0, 20).forEach(i -> tree.add(sample(i, -0.3)));
    IntStream.range(20, 30).forEach(i -> tree.add(sample(i, -0.2)));
    assertThat(tree.size()).isEqualTo(30);
    assertThat(tree.median()).isEqualTo(-0.3);
  }

  @Test
  void anOldCarpetDoesNotLiveOn() {
    SampleTree tree = new SampleTree(SampleTree.ENOUGH);
    IntStream.range(0, 1000).forEach(i -> tree.add(sample(i, -0.28)));
    IntStream.range(1000, 1016).forEach(i -> tree.add(sample(i, -0.36)));
    assertThat(tree.median()).isEqualTo(-0.36);
    IntStream.range(1016, 1031).forEach(i -> tree.add(sample(i, -0.36)));
    assertThat(tree.quantile(0)).isEqualTo(-0.36);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void theOrderOfAddingDoesNotMatter(long seed) {
    Random random = new Random(seed);
    List<BallSample> samples = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      samples.add(sample(random.nextInt(40), random.nextInt(5)));
    }
    SampleTree first = new SampleTree(SampleTree.ENOUGH);
    samples.forEach(first::add);
    Collections.shuffle(samples, random);
    SampleTree second = new SampleTree(SampleTree.ENOUGH);
    samples.forEach(second::add);
    assertThat(second.samples()).as("seed %d", seed).isEqualTo(first.samples());
    assertThat(second.median()).isEqualTo(first.median());
  }

  @Test
  void knowsNothingWhenEmpty() {
    SampleTree tree = new SampleTree(40);
    assertThat(tree.size()).isZero();
    assertThat(tree.median()).isNaN();
    assertThat(tree.quantile(0.5)).isNaN();
    assertThat(tree.samples()).isEmpty();
  }

  @Test
  void refusesWhatMakesNoSense() {
    assertThatThrownBy(() -> new SampleTree(30)).hasMessageContaining("30");
    assertThatThrownBy(() -> new SampleTree(31).quantile(Double.NaN)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> sample(Double.NaN, 1)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> new BallSample(1, 1, 0, false)).hasMessageContaining("0.0");
    assertThatThrownBy(() -> new BallSample(1, Double.POSITIVE_INFINITY, 1, false))
        .hasMessageContaining("Infinity");
  }
}
