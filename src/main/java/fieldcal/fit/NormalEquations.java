package fieldcal.fit;

import java.util.Arrays;

/**
 * Normal equations of a least-squares problem, {@code A = JᵀWJ}, {@code b = JᵀWr}, with the cost {@code Σ ρ(|r|²)}; only the lower
 * triangle of A is filled.
 */
final class NormalEquations {
  final int size;
  final double[][] a;
  final double[] b;
  double cost;

  NormalEquations(int size) {
    this.size = size;
    a = new double[size][size];
    b = new double[size];
  }

  void clear() {
    for (double[] row : a) {
      Arrays.fill(row, 0);
    }
    Arrays.fill(b, 0);
    cost = 0;
  }

  /**
   * Cholesky factor of {@code A + λ·diag(A)} over the free unknowns, each scaled by {@code scale}; those that are not free get a
   * unit row.
   *
   * @return false when the matrix is not positive definite to working precision
   */
  boolean factor(double lambda, double[] scale, boolean[] free, double[][] l) {
    for (int i = 0; i < size; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = free[i] && free[j] ? a[i][j] * scale[i] * scale[j] : 0;
        if (i == j) {
          sum = free[i] ? sum * (1 + lambda) : 1;
        }
        double original = sum;
        for (int k = 0; k < j; k++) {
          sum -= l[i][k] * l[j][k];
        }
        if (i == j) {
          if (!(sum > 1e-13 * original) || !(sum > 0)) {
            return false;
          }
          l[i][i] = Math.sqrt(sum);
        } else {
          l[i][j] = sum / l[j][j];
        }
      }
    }
    return true;
  }

  /** Squared distance of two points in standard errors, dᵀ·A·d: what the linear model costs from a minimum at one to the other. */
  double squaredDistance(double[] from, double[] to) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      double di = to[i] - from[i];
      sum += a[i][i] * di * di;
      for (int j = 0; j < i; j++) {
        sum += 2 * a[i][j] * di * (to[j] - from[j]);
      }
    }
    return sum;
  }

  /** Solves {@code L·Lᵀ·step = b} in scaled unknowns; {@code step} comes out unscaled. */
  void solve(double[][] l, double[] scale, boolean[] free, double[] step) {
    for (int i = 0; i < size; i++) {
      step[i] = free[i] ? b[i] * scale[i] : 0;
    }
    solveInPlace(l, step);
    for (int i = 0; i < size; i++) {
      step[i] = free[i] ? step[i] * scale[i] : 0;
    }
  }

  /** Replaces x by the solution of {@code L·Lᵀ·x' = x}. */
  static void solveInPlace(double[][] l, double[] x) {
    int n = x.length;
    for (int i = 0; i < n; i++) {
      double sum = x[i];
      for (int k = 0; k < i; k++) {
        sum -= l[i][k] * x[k];
      }
      x[i] = sum / l[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
      double sum = x[i];
      for (int k = i + 1; k < n; k++) {
        sum -= l[k][i] * x[k];
      }
      x[i] = sum / l[i][i];
    }
  }

  /**
   * Inverse of A over the free unknowns, zero elsewhere.
   *
   * @return null when A is singular to working precision
   */
  double[][] inverse(double[] scale, boolean[] free) {
    double[][] l = new double[size][size];
    if (!factor(0, scale, free, l)) {
      return null;
    }
    double[][] inverse = new double[size][size];
    double[] saved = b.clone();
    double[] column = new double[size];
    for (int j = 0; j < size; j++) {
      if (free[j]) {
        Arrays.fill(b, 0);
        b[j] = 1;
        solve(l, scale, free, column);
        for (int i = 0; i < size; i++) {
          inverse[i][j] = column[i];
        }
      }
    }
    System.arraycopy(saved, 0, b, 0, size);
    return inverse;
  }
}
