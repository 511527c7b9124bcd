package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Modes of accelerations whose rows come in any order. */
class SaturationFitTest {
  /** Rows differ in the order of sums only. */
  private static final double ROUNDING = 1e-9;

  /** A third of the manoeuvres at 2, a seventh at the limit of 4, the others below. */
  private static List<Double> accelerations() {
    List<Double> all = new ArrayList<>();
    Random random = new Random(5);
    for (int i = 0; i < 300; i++) {
      double noise = 0.02 * random.nextGaussian();
      all.add(i < 42 ? 4 + noise : i < 140 ? 2 + noise : 0.4 + 1.4 * random.nextDouble());
    }
    Collections.sort(all);
    return all;
  }

  private static SaturationFit.Uniform fit(List<Double> accelerations) {
    double[] a = accelerations.stream().mapToDouble(v -> v).toArray();
    double[] error = new double[a.length];
    double[] count = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      error[i] = 0.01 * a[i];
      count[i] = 1;
    }
    return SaturationFit.uniform(new ManoeuvreTable.Columns(a, error, a, a, count));
  }

  private static void same(SaturationFit.Uniform found, SaturationFit.Uniform expected) {
    assertThat(found.highest().beta()[0]).isCloseTo(expected.highest().beta()[0], within(ROUNDING));
    assertThat(found.largest().beta()[0]).isCloseTo(expected.largest().beta()[0], within(ROUNDING));
  }

  @Test
  void theOrderOfTheRowsDoesNotMatter() {
    SaturationFit.Uniform expected = fit(accelerations());
    assertThat(expected.highest().beta()[0]).isCloseTo(4, within(0.02));
    List<Double> rows = accelerations();
    Collections.reverse(rows);
    same(fit(rows), expected);
    Collections.shuffle(rows, new Random(1));
    same(fit(rows), expected);
  }

  /** Without its direction a manoeuvre has no acceleration once the direction is taken out. */
  @Test
  void rowsOfUnknownAccelerationAreNoStarts() {
    SaturationFit.Uniform expected = fit(accelerations());
    List<Double> rows = new ArrayList<>(Collections.nCopies(20_000, Double.NaN));
    rows.addAll(accelerations());
    same(fit(rows), expected);
  }
}
