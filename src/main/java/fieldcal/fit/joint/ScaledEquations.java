package fieldcal.fit.joint;

import java.util.Optional;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;

/** Symmetric equations solved in scaled variables, so that a slope in 1/s and an offset in mm are of the same size. */
final class ScaledEquations {
  /** Added to the curvature by scaled parameters, so that one that nothing determines stays where it is. */
  private static final double UNDETERMINED = 1e-9;

  private static final double SYMMETRY = 1e-9;
  private static final double POSITIVITY = 1e-14;

  private ScaledEquations() {}

  /** Symmetric to the last bit: entries that are nothing but rounding differ across the diagonal by more than a decomposition accepts. */
  private static double[][] scaled(double[][] h, double[] scale, double lambda) {
    int n = scale.length;
    double[][] scaled = new double[n][n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        scaled[i][j] = 0.5 * (h[i][j] + h[j][i]) * scale[i] * scale[j];
        scaled[j][i] = scaled[i][j];
      }
      scaled[i][i] = scaled[i][i] * (1 + lambda) + UNDETERMINED;
    }
    return scaled;
  }

  private static CholeskyDecomposition decomposed(double[][] scaled) {
    return new CholeskyDecomposition(new Array2DRowRealMatrix(scaled, false), SYMMETRY, POSITIVITY);
  }

  private static boolean isFinite(double[][] scaled) {
    for (int i = 0; i < scaled.length; i++) {
      if (!Double.isFinite(scaled[i][i])) {
        return false;
      }
    }
    return true;
  }

  /** Solves (H + λ·diag H)·x = g; null when that is not positive definite. */
  static double[] solve(double[][] h, double[] g, double[] scale, double lambda) {
    int n = g.length;
    double[][] scaled = scaled(h, scale, lambda);
    double[] rhs = new double[n];
    for (int i = 0; i < n; i++) {
      rhs[i] = g[i] * scale[i];
      if (!Double.isFinite(rhs[i])) {
        return null;
      }
    }
    if (!isFinite(scaled)) {
      return null;
    }
    try {
      double[] x = decomposed(scaled).getSolver().solve(new ArrayRealVector(rhs, false)).toArray();
      for (int i = 0; i < n; i++) {
        x[i] *= scale[i];
      }
      return x;
    } catch (NonPositiveDefiniteMatrixException e) {
      return null;
    }
  }

  /** Inverse of an information matrix; empty when that is singular. */
  static Optional<double[][]> inverse(double[][] h, double[] scale) {
    int n = scale.length;
    double[][] scaled = scaled(h, scale, 0);
    if (n == 0) {
      return Optional.of(scaled);
    }
    if (!isFinite(scaled)) {
      return Optional.empty();
    }
    try {
      double[][] v = decomposed(scaled).getSolver().getInverse().getData();
      for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
          v[i][j] *= scale[i] * scale[j];
        }
      }
      return Optional.of(v);
    } catch (NonPositiveDefiniteMatrixException e) {
      return Optional.empty();
    }
  }
}
