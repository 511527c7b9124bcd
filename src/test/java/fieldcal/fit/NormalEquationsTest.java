package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Against the linear algebra of Commons Math. */
class NormalEquationsTest {
  private static final int SIZE = 7;

  /** As far apart as positions in metres and seconds of a kick are. */
  private static final double[] SCALE = {0.01, 0.01, 0.1, 3, 0.005, 1, 0.1};

  private final boolean[] free = new boolean[SIZE];
  private final NormalEquations equations = new NormalEquations(SIZE);

  /** Lower triangle of JᵀJ for a random J whose columns are as unequal as the scales. */
  private void fill(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    double[][] j = new double[20][SIZE];
    for (double[] row : j) {
      for (int k = 0; k < SIZE; k++) {
        row[k] = random.nextDouble(-1, 1) / SCALE[k];
      }
    }
    for (int i = 0; i < SIZE; i++) {
      equations.b[i] = random.nextDouble(-1, 1) / SCALE[i];
      for (int k = 0; k <= i; k++) {
        for (double[] row : j) {
          equations.a[i][k] += row[i] * row[k];
        }
      }
    }
    Arrays.fill(free, true);
  }

  private int[] indices() {
    return java.util.stream.IntStream.range(0, SIZE).filter(i -> free[i]).toArray();
  }

  private RealMatrix reference(double lambda) {
    RealMatrix full = new Array2DRowRealMatrix(SIZE, SIZE);
    for (int i = 0; i < SIZE; i++) {
      for (int k = 0; k <= i; k++) {
        double entry = equations.a[i][k] * (i == k ? 1 + lambda : 1);
        full.setEntry(i, k, entry);
        full.setEntry(k, i, entry);
      }
    }
    return full.getSubMatrix(indices(), indices());
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void solvesAsCommonsMathDoes(long seed) {
    fill(seed);
    free[(int) (seed % SIZE)] = false;
    free[SIZE - 1] = seed % 2 == 0;
    for (double lambda : new double[] {0, 1e-4, 3}) {
      double[][] l = new double[SIZE][SIZE];
      double[] step = new double[SIZE];
      assertThat(equations.factor(lambda, SCALE, free, l)).isTrue();
      equations.solve(l, SCALE, free, step);
      int[] index = indices();
      RealVector b =
          new ArrayRealVector(Arrays.stream(index).mapToDouble(i -> equations.b[i]).toArray());
      RealVector expected = new LUDecomposition(reference(lambda)).getSolver().solve(b);
      for (int k = 0; k < index.length; k++) {
        assertThat(step[index[k]]).isEqualTo(expected.getEntry(k), within(1e-9 * SCALE[index[k]]));
      }
      for (int i = 0; i < SIZE; i++) {
        if (!free[i]) {
          assertThat(step[i]).isZero();
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void invertsAsCommonsMathDoes(long seed) {
    fill(seed);
    free[3] = false;
    double[] before = equations.b.clone();
    double[][] inverse = equations.inverse(SCALE, free);
    RealMatrix expected = new LUDecomposition(reference(0)).getSolver().getInverse();
    int[] index = indices();
    for (int i = 0; i < index.length; i++) {
      for (int k = 0; k < index.length; k++) {
        assertThat(inverse[index[i]][index[k]])
            .isEqualTo(expected.getEntry(i, k), within(1e-9 * SCALE[index[i]] * SCALE[index[k]]));
      }
    }
    assertThat(inverse[3]).containsOnly(0);
    assertThat(equations.b).as("the right side is left as it was").containsExactly(before);
  }

  @Test
  void aSingularMatrixIsRefused() {
    fill(21);
    // Unknown 5 is twice unknown 2.
    for (int k = 0; k < SIZE; k++) {
      double entry = 2 * (k <= 2 ? equations.a[2][k] : equations.a[k][2]);
      if (k < 5) {
        equations.a[5][k] = entry;
      } else if (k > 5) {
        equations.a[k][5] = entry;
      }
    }
    equations.a[5][5] = 4 * equations.a[2][2];
    assertThat(equations.inverse(SCALE, free)).isNull();
    assertThat(equations.factor(1e-3, SCALE, free, new double[SIZE][SIZE]))
        .as("damping makes it regular")
        .isTrue();
    free[5] = false;
    assertThat(equations.inverse(SCALE, free)).isNotNull();
  }

  @Test
  void notANumberIsRefused() {
    fill(22);
    equations.a[4][1] = Double.NaN;
    assertThat(equations.inverse(SCALE, free)).isNull();
  }
}
