package fieldcal.diagnosis;

import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;
import org.apache.commons.math3.linear.RealMatrix;

/** Normal equations of the shared unknowns, those that are held left out, each in units of its step so that the matrix is well scaled. */
final class SharedNormal {
  /** Keeps the information matrix of unknowns that nothing determines but their expectation decomposable. */
  private static final double RIDGE = 1e-12;

  private final SharedUnknowns unknowns;
  private final double[][] a;
  private final int[] free;

  /**
   * Normal equations.
   *
   * @param a their matrix, over all shared unknowns
   */
  SharedNormal(SharedUnknowns unknowns, double[][] a) {
    this.unknowns = unknowns;
    this.a = a;
    free = IntStream.range(0, unknowns.size).filter(k -> unknowns.free[k]).toArray();
  }

  /** A damped step of all shared unknowns, zero for those that are held; null when the matrix is not positive definite. */
  double[] solve(double[] b, double lambda) {
    double[] step = new double[unknowns.size];
    if (free.length == 0) {
      return step;
    }
    try {
      double[] right = new double[free.length];
      for (int i = 0; i < right.length; i++) {
        right[i] = b[free[i]] * unknowns.step[free[i]];
      }
      double[] x =
          new CholeskyDecomposition(scaled(lambda), 1e-7, 0)
              .getSolver()
              .solve(new ArrayRealVector(right))
              .toArray();
      for (int i = 0; i < x.length; i++) {
        step[free[i]] = x[i] * unknowns.step[free[i]];
      }
      return step;
    } catch (NonPositiveDefiniteMatrixException e) {
      return null;
    }
  }

  /** What the freedom of the shared unknowns costs: ½ ln of the determinant of their information, in units of what was expected of them. */
  double occam() {
    if (free.length == 0) {
      return 0;
    }
    RealMatrix factor = factor().getL();
    double sum = 0;
    for (int i = 0; i < free.length; i++) {
      sum += Math.log(factor.getEntry(i, i) / unknowns.step[free[i]]);
      sum += Math.log(unknowns.expectedError[free[i]]);
    }
    return sum;
  }

  /** Covariance of all shared unknowns, zero for those that are held. */
  double[][] covariance() {
    double[][] covariance = new double[unknowns.size][unknowns.size];
    if (free.length == 0) {
      return covariance;
    }
    RealMatrix inverse = factor().getSolver().getInverse();
    for (int i = 0; i < free.length; i++) {
      for (int j = 0; j < free.length; j++) {
        covariance[free[i]][free[j]] =
            inverse.getEntry(i, j) * unknowns.step[free[i]] * unknowns.step[free[j]];
      }
    }
    return covariance;
  }

  private CholeskyDecomposition factor() {
    return new CholeskyDecomposition(scaled(RIDGE), 1e-6, -1e-6);
  }

  private RealMatrix scaled(double lambda) {
    RealMatrix m = new Array2DRowRealMatrix(free.length, free.length);
    for (int i = 0; i < free.length; i++) {
      for (int j = 0; j <= i; j++) {
        double value =
            0.5
                * (a[free[i]][free[j]] + a[free[j]][free[i]])
                * unknowns.step[free[i]]
                * unknowns.step[free[j]];
        value *= i == j ? 1 + lambda : 1;
        m.setEntry(i, j, value);
        m.setEntry(j, i, value);
      }
    }
    return m;
  }
}
