package fieldcal.diagnosis;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * Normal equations of one kick in blocks: its own unknowns and the shared ones, and how they reduce to the shared ones alone (Schur complement). Own unknowns are scaled by their steps.
 */
final class KickNormal {
  /** Keeps a kick of which something is not determined at all from making its block singular: a ten-thousandth of an observation per step. */
  private static final double FLOOR = 1e-8;

  final double cost;

  /** Own by own, own by shared, shared by shared. */
  private final RealMatrix oo;

  private final RealMatrix os;
  private final RealMatrix ss;
  private final RealVector bo;
  private final RealVector bs;
  private final double[] ownScale;
  private CholeskyDecomposition factor;
  private RealMatrix solvedOs;
  private RealVector solvedBo;

  /**
   * @param own columns by own unknowns
   * @param shared columns by shared unknowns; null where the kick does not depend on one
   * @param residual seen minus predicted
   */
  KickNormal(double[][] own, double[][] shared, double[] residual, double cost, double[] ownScale) {
    this.cost = cost;
    this.ownScale = ownScale;
    int p = own.length;
    int q = shared.length;
    oo = new Array2DRowRealMatrix(p, p);
    os = new Array2DRowRealMatrix(p, Math.max(1, q));
    ss = new Array2DRowRealMatrix(Math.max(1, q), Math.max(1, q));
    bo = new ArrayRealVector(p);
    bs = new ArrayRealVector(Math.max(1, q));
    for (int i = 0; i < p; i++) {
      bo.setEntry(i, dot(own[i], residual) * ownScale[i]);
      for (int j = 0; j <= i; j++) {
        double value = dot(own[i], own[j]) * ownScale[i] * ownScale[j];
        oo.setEntry(i, j, value);
        oo.setEntry(j, i, value);
      }
      for (int j = 0; j < q; j++) {
        if (shared[j] != null) {
          os.setEntry(i, j, dot(own[i], shared[j]) * ownScale[i]);
        }
      }
    }
    for (int i = 0; i < q; i++) {
      if (shared[i] == null) {
        continue;
      }
      bs.setEntry(i, dot(shared[i], residual));
      for (int j = 0; j <= i; j++) {
        if (shared[j] != null) {
          double value = dot(shared[i], shared[j]);
          ss.setEntry(i, j, value);
          ss.setEntry(j, i, value);
        }
      }
    }
  }

  /** Four sums at a time, so that none waits for the one before. */
  static double dot(double[] a, double[] b) {
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    int i = 0;
    for (; i + 3 < a.length; i += 4) {
      s0 += a[i] * b[i];
      s1 += a[i + 1] * b[i + 1];
      s2 += a[i + 2] * b[i + 2];
      s3 += a[i + 3] * b[i + 3];
    }
    for (; i < a.length; i++) {
      s0 += a[i] * b[i];
    }
    return s0 + s1 + (s2 + s3);
  }

  /** Adds what is known of an own unknown beforehand, and, of a random effect, of its mean: weight·(own − mean)². */
  void tie(int ownIndex, int meanIndex, double away, double weight) {
    double s = ownScale[ownIndex];
    oo.addToEntry(ownIndex, ownIndex, weight * s * s);
    bo.addToEntry(ownIndex, -weight * away * s);
    if (meanIndex >= 0) {
      os.addToEntry(ownIndex, meanIndex, -weight * s);
      ss.addToEntry(meanIndex, meanIndex, weight);
      bs.addToEntry(meanIndex, weight * away);
    }
  }

  /** Eliminates the own unknowns and adds what remains to the shared equations. */
  void reduce(double lambda, double[][] a, double[] b) {
    RealMatrix damped = oo.copy();
    for (int i = 0; i < damped.getRowDimension(); i++) {
      double d = damped.getEntry(i, i);
      damped.setEntry(i, i, d * (1 + lambda) + FLOOR * (1 + d));
    }
    factor = new CholeskyDecomposition(damped, 1e-9, 0);
    solvedOs = factor.getSolver().solve(os);
    solvedBo = factor.getSolver().solve(bo);
    RealMatrix reduced = ss.subtract(os.transpose().multiply(solvedOs));
    RealVector right = bs.subtract(os.preMultiply(solvedBo));
    for (int i = 0; i < b.length; i++) {
      b[i] += right.getEntry(i);
      for (int j = 0; j < b.length; j++) {
        a[i][j] += reduced.getEntry(i, j);
      }
    }
  }

  /** By how much the best choice of the own unknowns lowers the cost when the shared ones stay, as far as the problem is linear; after {@link #reduce}. */
  double ownDecrease() {
    return bo.dotProduct(solvedBo);
  }

  /** The step of the own unknowns that goes with a step of the shared ones; after {@link #reduce}. */
  double[] ownStep(double[] sharedStep) {
    double[] step = new double[ownScale.length];
    for (int i = 0; i < step.length; i++) {
      double sum = solvedBo.getEntry(i);
      for (int j = 0; j < sharedStep.length; j++) {
        sum -= solvedOs.getEntry(i, j) * sharedStep[j];
      }
      step[i] = sum * ownScale[i];
    }
    return step;
  }

  /** Solution of the kick's own equations for a right-hand side of columns; after {@link #reduce}. */
  RealMatrix solve(RealMatrix columns) {
    return factor.getSolver().solve(columns);
  }

  /** Logarithm of the determinant of the first {@code n} own unknowns' block, unscaled steps left in. */
  double logDeterminant(int n) {
    RealMatrix part = oo.getSubMatrix(0, n - 1, 0, n - 1);
    for (int i = 0; i < n; i++) {
      part.addToEntry(i, i, FLOOR * (1 + part.getEntry(i, i)));
    }
    RealMatrix l = new CholeskyDecomposition(part, 1e-6, 0).getL();
    double sum = 0;
    for (int i = 0; i < n; i++) {
      sum += 2 * Math.log(l.getEntry(i, i));
    }
    return sum;
  }

  /** Variance of an own unknown when the shared ones are known; after {@link #reduce}. */
  double ownVariance(int index) {
    ArrayRealVector unit = new ArrayRealVector(ownScale.length);
    unit.setEntry(index, 1);
    return factor.getSolver().solve(unit).getEntry(index) * ownScale[index] * ownScale[index];
  }
}
