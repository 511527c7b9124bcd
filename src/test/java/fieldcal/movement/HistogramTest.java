package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HistogramTest {
  @Test
  void percentileOfAnEmptyOneIsUnknown() {
    assertThat(new Histogram(0.1, 10).percentile(0.5)).isNaN();
  }

  @Test
  void oneValueLiesInItsOwnBin() {
    Histogram h = new Histogram(0.1, 10);
    h.add(0.34);
    assertThat(h.percentile(0)).isEqualTo(0.3, within(1e-12));
    assertThat(h.percentile(0.5)).isEqualTo(0.35, within(1e-12));
    assertThat(h.percentile(1)).isEqualTo(0.4, within(1e-12));
  }

  @Test
  void anEdgeBelongsToTheBinAboveIt() {
    Histogram h = new Histogram(0.5, 4);
    h.add(0.5);
    assertThat(h.count(1)).isEqualTo(1);
    assertThat(h.count(0)).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.05, 0.25, 0.5, 0.75, 0.95, 0.995})
  void percentilesOfEvenlySpreadValuesAreNotHalfABinOff(double share) {
    Histogram h = new Histogram(0.1, 50);
    int n = 100_000;
    for (int i = 0; i < n; i++) {
      h.add(4.0 * (i + 0.5) / n);
    }
    assertThat(h.percentile(share)).isEqualTo(4 * share, within(1e-4));
  }

  @Test
  void equalValuesAllCount() {
    Histogram h = new Histogram(0.1, 10);
    for (int i = 0; i < 7; i++) {
      h.add(0.55);
    }
    assertThat(h.samples()).isEqualTo(7);
    assertThat(h.count(5)).isEqualTo(7);
  }

  @Test
  void valuesBeyondTheLastBinBelongToEveryPercentile() {
    Histogram h = new Histogram(0.1, 10);
    for (int i = 0; i < 90; i++) {
      h.add(0.5);
    }
    for (int i = 0; i < 10; i++) {
      h.add(i == 0 ? Double.POSITIVE_INFINITY : 50);
    }
    assertThat(h.beyond()).isEqualTo(10);
    assertThat(h.samples()).isEqualTo(100);
    assertThat(h.percentile(0.9)).isEqualTo(0.6, within(1e-12));
    assertThat(h.percentile(0.95)).isEqualTo(1.0, within(1e-12));
  }

  @Test
  void negativeAndUnknownValuesAreRefused() {
    Histogram h = new Histogram(0.1, 10);
    assertThat(h.add(-1e-9)).isFalse();
    assertThat(h.add(Double.NaN)).isFalse();
    assertThat(h.samples()).isZero();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void partsMergeToTheWholeInAnyOrder(long seed) {
    Random random = new Random(seed);
    Histogram whole = new Histogram(0.1, 30);
    Histogram[] parts = {new Histogram(0.1, 30), new Histogram(0.1, 30), new Histogram(0.1, 30)};
    for (int i = 0; i < 5000; i++) {
      double value = Math.abs(random.nextGaussian());
      whole.add(value);
      parts[random.nextInt(3)].add(value);
    }
    Histogram forth = new Histogram(0.1, 30);
    Histogram back = new Histogram(0.1, 30);
    for (int i = 0; i < 3; i++) {
      forth.merge(parts[i]);
      back.merge(parts[2 - i]);
    }
    for (double share : new double[] {0, 0.1, 0.5, 0.75, 0.95, 0.995, 1}) {
      assertThat(forth.percentile(share)).isEqualTo(whole.percentile(share));
      assertThat(back.percentile(share)).isEqualTo(whole.percentile(share));
    }
    assertThat(forth.samples()).isEqualTo(whole.samples());
  }

  @Test
  void wrongBinsAndSharesAreRefused() {
    assertThatThrownBy(() -> new Histogram(0, 3)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Histogram(Double.NaN, 3))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Histogram(1, 0)).isInstanceOf(IllegalArgumentException.class);
    Histogram h = new Histogram(1, 3);
    assertThatThrownBy(() -> h.percentile(Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> h.merge(new Histogram(1, 4)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
