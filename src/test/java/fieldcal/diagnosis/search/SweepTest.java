package fieldcal.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Against regressions that commons-math makes one by one. */
class SweepTest {
  /** Rounding of sums of squares of some dozens. */
  private static final Offset<Double> EXACT = within(1e-8);

  private final LinearKicks kicks = new LinearKicks(3);
  private final Sweep sweep = new Sweep(kicks.system(), new double[LinearKicks.COLUMNS]);

  private Sweep withBase() {
    Sweep base = sweep.copy();
    base.toggle(0);
    base.toggle(1);
    return base;
  }

  @Test
  void gainIsWhatARegressionWithTheSetLeavesLess() {
    Sweep base = withBase();
    assertThat(base.gain(new int[] {2})).isCloseTo(kicks.left(0, 1) - kicks.left(0, 1, 2), EXACT);
    assertThat(base.gain(new int[] {2, 4}))
        .isCloseTo(kicks.left(0, 1) - kicks.left(0, 1, 2, 4), EXACT);
    base.toggle(4);
    assertThat(base.gain(new int[] {2, 3}))
        .isCloseTo(kicks.left(0, 1, 4) - kicks.left(0, 1, 2, 3, 4), EXACT);
  }

  @Test
  void gainWithinARangeIsThatOfItsBestNumber() {
    Sweep base = withBase();
    double full = base.gain(new int[] {2});
    Sweep with = base.copy();
    with.toggle(2);
    double best = with.estimate(2);
    double far = 2 * Math.abs(best);
    assertThat(base.gain(2, -far, far)).isCloseTo(full, EXACT);
    // A parabola: half of the way gains three quarters.
    double half = best / 2;
    assertThat(base.gain(2, Math.min(0, half), Math.max(0, half))).isCloseTo(0.75 * full, EXACT);
    // On the wrong side of zero there is nothing to gain.
    assertThat(best > 0 ? base.gain(2, -far, 0) : base.gain(2, 0, far)).isZero();
    base.toggle(3);
    base.toggle(2);
    assertThat(base.gain(5, -far, far)).isZero();
  }

  @Test
  void estimatesAreTheRegressions() {
    Sweep base = withBase();
    base.toggle(2);
    base.toggle(4);
    double[] expected = kicks.coefficients(0, 1, 2, 4);
    double[] start = kicks.solution().values();
    assertThat(base.estimate(2)).isCloseTo(expected[2], EXACT);
    assertThat(base.estimate(4)).isCloseTo(expected[3], EXACT);
    // Columns of the model say how far the solution would move.
    assertThat(start[0] + base.estimate(0)).isCloseTo(expected[0], EXACT);
    assertThat(start[1] + base.estimate(1)).isCloseTo(expected[1], EXACT);
  }

  @Test
  void columnsThatComeAndGoLeaveNothingBehind() {
    Sweep base = withBase();
    double before = base.gain(new int[] {3, 4});
    base.toggle(2);
    assertThat(base.contains(2)).isTrue();
    assertThat(base.gain(new int[] {3, 4})).isNotCloseTo(before, within(1e-3));
    base.toggle(2);
    assertThat(base.contains(2)).isFalse();
    assertThat(base.gain(new int[] {3, 4})).isCloseTo(before, EXACT);
  }

  @Test
  void aCopyIsItsOwn() {
    Sweep base = withBase();
    double before = base.gain(new int[] {4});
    base.copy().toggle(2);
    assertThat(base.contains(2)).isFalse();
    assertThat(base.gain(new int[] {4})).isEqualTo(before);
  }

  @Test
  void aColumnThatOthersMakeUpIsLeftAlone() {
    Sweep base = withBase();
    base.toggle(2);
    base.toggle(3);
    double before = base.gain(new int[] {4});
    base.toggle(5);
    assertThat(base.contains(5)).isFalse();
    assertThat(base.gain(new int[] {5})).isZero();
    assertThat(base.gain(new int[] {4})).isEqualTo(before);
    assertThat(base.gain(new int[] {4, 5})).isCloseTo(before, EXACT);
  }

  @Test
  void whatTheModelHasMayBeTakenBack() {
    double[] removed = new double[LinearKicks.COLUMNS];
    removed[1] = kicks.solution().values()[1];
    Sweep without = new Sweep(kicks.system(), new double[LinearKicks.COLUMNS], removed);
    without.toggle(0);
    assertThat(without.gain(new int[] {1})).isCloseTo(kicks.left(0) - kicks.left(0, 1), EXACT);
    assertThat(without.gain(new int[] {2, 4}))
        .isCloseTo(kicks.left(0) - kicks.left(0, 2, 4), EXACT);
  }

  @Test
  void whatIsKnownBeforehandHoldsAColumnBack() {
    double[] precisions = new double[LinearKicks.COLUMNS];
    precisions[2] = 1e12;
    Sweep held = new Sweep(kicks.system(), precisions);
    held.toggle(0);
    held.toggle(1);
    assertThat(held.gain(new int[] {2})).isCloseTo(0, within(1e-6));
    assertThat(held.gain(new int[] {4})).isCloseTo(kicks.left(0, 1) - kicks.left(0, 1, 4), EXACT);
  }
}
