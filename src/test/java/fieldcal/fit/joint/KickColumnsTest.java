package fieldcal.fit.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Equations from columns that are kept are those of a block that is made at once. */
class KickColumnsTest {
  private static final long SEED = 20261124;
  private static final int ROWS = 21;
  private static final double WEIGHT = 0.7;

  private final SplittableRandom random = new SplittableRandom(SEED);

  private double[][] columns(int n) {
    double[][] all = new double[n][ROWS];
    for (double[] column : all) {
      for (int i = 0; i < ROWS; i++) {
        column[i] = random.nextGaussian();
      }
    }
    return all;
  }

  @Test
  void theEquationsAreThoseOfABlock() {
    double[][] own = columns(3);
    double[][] shared = columns(5);
    KickColumns kept = new KickColumns(own, shared, ROWS, WEIGHT);
    for (double[] residuals : columns(2)) {
      KickBlock expected = new KickBlock(3, 5);
      expected.add(own, shared, residuals, WEIGHT);
      KickBlock block = kept.equations(residuals);
      // One kick's ties must not stay for the next equations.
      KickBlock tied = kept.equations(residuals);
      tied.tieToShared(1, 2, 0.3, 5);
      assertThat(kept.equations(residuals).a[1][1]).isEqualTo(block.a[1][1]);
      assertThat(block.chiSquare).isEqualTo(expected.chiSquare, within(1e-12));
      for (int i = 0; i < 3; i++) {
        assertThat(block.ga[i]).isEqualTo(expected.ga[i], within(1e-12));
        assertThat(block.a[i]).containsExactly(expected.a[i], within(1e-12));
        assertThat(block.b[i]).containsExactly(expected.b[i], within(1e-12));
      }
      for (int k = 0; k < 5; k++) {
        assertThat(block.gc[k]).isEqualTo(expected.gc[k], within(1e-12));
        assertThat(block.c[k]).containsExactly(expected.c[k], within(1e-12));
      }
    }
  }
}
