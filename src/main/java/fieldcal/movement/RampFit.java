package fieldcal.movement;

import java.util.Arrays;

/**
 * Fits a piece of constant acceleration together with its two neighbours: velocity is continuous, the acceleration changes at two knots whose times are fitted too. What lies beyond a knot
 * so does not pull the piece's acceleration down, as it does in any window that is slid over the path.
 *
 * <p>Least squares on the positions, each with its own time; a constant for each camera is projected out, so that cameras may disagree. For given knots the
 * problem is linear, so only the knots are iterated (variable projection, Golub and Pereyra 1973, in Kaufman's form). The errors contain what the knots' errors add.
 */
final class RampFit {
  /** How well the knots are known before, s: a cell of the grid they come from, and the noise in choosing it. */
  private static final double KNOT_PRIOR = 0.05;

  private static final double SHORTEST = 0.05;
  private static final int ITERATIONS = 12;
  private static final double SETTLED = 2e-4;

  // Functions of time and what is to be explained, in the order of the Gram matrix: what is zero
  // before the first knot comes after what is not, and what is zero before the second comes last.
  private static final int T = 0;
  private static final int T2 = 1; // t²/2
  private static final int X = 2;
  private static final int Y = 3;
  private static final int Q1 = 4; // (t−τ1)²/2
  private static final int R1 = 5; // (t−τ1), the derivative by the knot but for its factor
  private static final int Q2 = 6; // (t−τ2)²/2
  private static final int R2 = 7;
  private static final int ALL = 8;

  /** The functions whose factors are fitted. */
  private static final int[] FITTED = {T, T2, Q1, Q2};

  private static final int LINEAR = FITTED.length;

  private final double[][] gram = new double[ALL][ALL];
  private final double[][] cameraSums = new double[Stretch.CAMERAS][ALL];
  private final int[] cameraCounts = new int[Stretch.CAMERAS];
  private final double[] f = new double[ALL];
  private final double[][] cholesky = new double[LINEAR][LINEAR];
  private final double[] cx = new double[LINEAR];
  private final double[] cy = new double[LINEAR];
  private final double[] u1 = new double[LINEAR];
  private final double[] u2 = new double[LINEAR];
  private final double[] e = new double[LINEAR];

  private double tau1;
  private double tau2;
  private double s11;
  private double s12;
  private double s22;
  private int samples;
  private int freedom;
  private double rss;

  /**
   * Fits the detections of [from, to] with knots near τ1 and τ2.
   *
   * @return false when there are too few, or the knots run away
   */
  boolean fit(
      Stretch s, double from, double to, double firstKnot, double secondKnot, double variance) {
    int first = s.indexAt(from);
    int last = s.indexAt(to);
    tau1 = firstKnot;
    tau2 = secondKnot;
    double damping = variance / (KNOT_PRIOR * KNOT_PRIOR);
    for (int i = 0; i < ITERATIONS; i++) {
      accumulate(s, first, last);
      if (samples < 12 || !solveLinear()) {
        return false;
      }
      double d11 = cx[2] * cx[2] + cy[2] * cy[2];
      double d12 = cx[2] * cx[3] + cy[2] * cy[3];
      double d22 = cx[3] * cx[3] + cy[3] * cy[3];
      double p11 = gram[R1][R1] - dot(R1, u1);
      double p12 = gram[R1][R2] - dot(R1, u2);
      double p22 = gram[R2][R2] - dot(R2, u2);
      s11 = d11 * p11 + damping;
      s12 = d12 * p12;
      s22 = d22 * p22 + damping;
      double g1 =
          -cx[2] * (gram[X][R1] - dot(R1, cx))
              - cy[2] * (gram[Y][R1] - dot(R1, cy))
              - damping * (tau1 - firstKnot);
      double g2 =
          -cx[3] * (gram[X][R2] - dot(R2, cx))
              - cy[3] * (gram[Y][R2] - dot(R2, cy))
              - damping * (tau2 - secondKnot);
      double determinant = s11 * s22 - s12 * s12;
      double step1 = limited((s22 * g1 - s12 * g2) / determinant);
      double step2 = limited((s11 * g2 - s12 * g1) / determinant);
      if (!(Math.abs(step1) + Math.abs(step2) < 1)) {
        return false;
      }
      if (Math.abs(step1) + Math.abs(step2) < SETTLED) {
        rss = Math.max(0, gram[X][X] - dot(X, cx) + gram[Y][Y] - dot(Y, cy));
        return freedom > 0;
      }
      tau1 += step1;
      tau2 += step2;
      if (tau2 - tau1 < SHORTEST || tau1 < from || tau2 > to) {
        return false;
      }
    }
    return false;
  }

  private static double limited(double step) {
    return Math.max(-0.02, Math.min(0.02, step));
  }

  private void accumulate(Stretch s, int first, int last) {
    for (double[] row : gram) {
      Arrays.fill(row, 0);
    }
    for (int c = 0; c < s.cameras(); c++) {
      Arrays.fill(cameraSums[c], 0);
      cameraCounts[c] = 0;
    }
    samples = last - first;
    int knot1 = Math.max(first, Math.min(last, s.indexAt(tau1)));
    int knot2 = Math.max(knot1, Math.min(last, s.indexAt(tau2)));
    add(s, first, knot1, Q1);
    add(s, knot1, knot2, Q2);
    add(s, knot2, last, ALL);
    freedom = 2 * samples - 2 * LINEAR - 2;
    for (int c = 0; c < s.cameras(); c++) {
      if (cameraCounts[c] > 0) {
        freedom -= 2;
        double[] sums = cameraSums[c];
        for (int j = 0; j < ALL; j++) {
          for (int k = 0; k <= j; k++) {
            gram[j][k] -= sums[j] * sums[k] / cameraCounts[c];
          }
        }
      }
    }
    for (int j = 0; j < ALL; j++) {
      for (int k = j + 1; k < ALL; k++) {
        gram[j][k] = gram[k][j];
      }
    }
  }

  /** Adds detections to the sums; only the first {@code active} functions are not zero there. */
  private void add(Stretch s, int from, int to, int active) {
    for (int i = from; i < to; i++) {
      double t = s.t[i] - tau1;
      f[T] = t;
      f[T2] = 0.5 * t * t;
      f[X] = s.x[i];
      f[Y] = s.y[i];
      f[Q1] = f[T2];
      f[R1] = t;
      double late = s.t[i] - tau2;
      f[Q2] = 0.5 * late * late;
      f[R2] = late;
      double[] sums = cameraSums[s.camera[i]];
      cameraCounts[s.camera[i]]++;
      for (int j = 0; j < active; j++) {
        double value = f[j];
        double[] row = gram[j];
        sums[j] += value;
        for (int k = 0; k <= j; k++) {
          row[k] += value * f[k];
        }
      }
    }
  }

  /** Sum over the linear functions of their product with function j, weighted. */
  private double dot(int j, double[] c) {
    double sum = 0;
    for (int k = 0; k < LINEAR; k++) {
      sum += gram[j][FITTED[k]] * c[k];
    }
    return sum;
  }

  private boolean solveLinear() {
    for (int i = 0; i < LINEAR; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = gram[FITTED[i]][FITTED[j]];
        for (int k = 0; k < j; k++) {
          sum -= cholesky[i][k] * cholesky[j][k];
        }
        if (i == j) {
          if (!(sum > 1e-9 * gram[FITTED[i]][FITTED[i]])) {
            return false;
          }
          cholesky[i][i] = Math.sqrt(sum);
        } else {
          cholesky[i][j] = sum / cholesky[j][j];
        }
      }
    }
    for (int k = 0; k < LINEAR; k++) {
      cx[k] = gram[X][FITTED[k]];
      cy[k] = gram[Y][FITTED[k]];
      u1[k] = gram[R1][FITTED[k]];
      u2[k] = gram[R2][FITTED[k]];
    }
    solve(cx);
    solve(cy);
    solve(u1);
    solve(u2);
    return true;
  }

  private void solve(double[] b) {
    for (int i = 0; i < LINEAR; i++) {
      double sum = b[i];
      for (int k = 0; k < i; k++) {
        sum -= cholesky[i][k] * b[k];
      }
      b[i] = sum / cholesky[i][i];
    }
    for (int i = LINEAR - 1; i >= 0; i--) {
      double sum = b[i];
      for (int k = i + 1; k < LINEAR; k++) {
        sum -= cholesky[k][i] * b[k];
      }
      b[i] = sum / cholesky[i][i];
    }
  }

  double firstKnot() {
    return tau1;
  }

  double secondKnot() {
    return tau2;
  }

  /** Velocity at the first knot. */
  double vx() {
    return cx[0];
  }

  double vy() {
    return cy[0];
  }

  double ax() {
    return cx[1] + cx[2];
  }

  double ay() {
    return cy[1] + cy[2];
  }

  /** Sum of squared residuals over its degrees of freedom, m². */
  double variance() {
    return rss / freedom;
  }

  int freedom() {
    return freedom;
  }

  /** Variance of the acceleration along a unit vector, m²/s⁴, for a variance of one component of a detection. */
  double accelerationVariance(double nx, double ny, double variance) {
    Arrays.fill(e, 0);
    e[1] = 1;
    e[2] = 1;
    return parameterVariance(nx, ny, variance);
  }

  /** Variance of the velocity along a unit vector in the middle between the knots, m²/s². */
  double velocityVariance(double nx, double ny, double variance) {
    Arrays.fill(e, 0);
    e[0] = 1;
    e[1] = 0.5 * (tau2 - tau1);
    e[2] = e[1];
    return parameterVariance(nx, ny, variance);
  }

  /** Variance of eᵀc along a unit vector. */
  private double parameterVariance(double nx, double ny, double variance) {
    double w1 = 0;
    double w2 = 0;
    for (int k = 0; k < LINEAR; k++) {
      w1 += e[k] * u1[k];
      w2 += e[k] * u2[k];
    }
    w1 *= cx[2] * nx + cy[2] * ny;
    w2 *= cx[3] * nx + cy[3] * ny;
    double knots = (s22 * w1 * w1 - 2 * s12 * w1 * w2 + s11 * w2 * w2) / (s11 * s22 - s12 * s12);
    System.arraycopy(e, 0, f, 0, LINEAR);
    double linear = 0;
    for (int i = 0; i < LINEAR; i++) {
      double sum = f[i];
      for (int k = 0; k < i; k++) {
        sum -= cholesky[i][k] * f[k];
      }
      f[i] = sum / cholesky[i][i];
      linear += f[i] * f[i];
    }
    return variance * (linear + knots);
  }
}
