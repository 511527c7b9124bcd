package fieldcal.fit.joint;

/**
 * Normal equations of one kick: own parameters first, then columns that are shared. The own parameters are eliminated by a Schur complement, so that the system of all kicks stays as small as the number of shared columns,
 * however many kicks there are.
 */
final class KickBlock {
  /** Relative size below which a pivot means that the data do not determine an own parameter. */
  private static final double SINGULAR = 1e-12;

  final int own;
  final int shared;

  /** Own by own, own by shared, shared by shared (full, symmetric). */
  final double[][] a;

  final double[][] b;
  final double[][] c;
  final double[] ga;
  final double[] gc;

  /** Weighted sum of squared residuals, without priors. */
  double chiSquare;

  /** What the own parameters' priors add. */
  double priorCost;

  private final double[][] l;
  private double[][] solved;
  private double[] solvedGradient;

  KickBlock(int own, int shared) {
    this.own = own;
    this.shared = shared;
    a = new double[own][own];
    b = new double[own][shared];
    c = new double[shared][shared];
    ga = new double[own];
    gc = new double[shared];
    l = new double[own][own];
  }

  /** Adds rows: columns are derivatives of the prediction, residuals observed minus predicted. */
  void add(double[][] ownColumns, double[][] sharedColumns, double[] residuals, double weight) {
    double sum = 0;
    for (double r : residuals) {
      sum += r * r;
    }
    chiSquare += weight * sum;
    for (int i = 0; i < own; i++) {
      double[] ci = ownColumns[i];
      ga[i] += weight * dot(ci, residuals);
      for (int j = 0; j <= i; j++) {
        a[i][j] += weight * dot(ci, ownColumns[j]);
        a[j][i] = a[i][j];
      }
      for (int k = 0; k < shared; k++) {
        b[i][k] += weight * dot(ci, sharedColumns[k]);
      }
    }
    for (int k = 0; k < shared; k++) {
      double[] ck = sharedColumns[k];
      gc[k] += weight * dot(ck, residuals);
      for (int m = 0; m <= k; m++) {
        c[k][m] += weight * dot(ck, sharedColumns[m]);
        c[m][k] = c[k][m];
      }
    }
  }

  /** Ties an own parameter to a value. */
  void tieOwn(int i, double distance, double precision) {
    a[i][i] += precision;
    ga[i] -= precision * distance;
    priorCost += precision * distance * distance;
  }

  /** Ties an own parameter to a shared one: their difference is {@code distance} now. */
  void tieToShared(int i, int k, double distance, double precision) {
    tieOwn(i, distance, precision);
    if (k >= 0) {
      b[i][k] -= precision;
      c[k][k] += precision;
      gc[k] += precision * distance;
    }
  }

  /** Factors the own part, damped by {@code lambda}. */
  void factor(double lambda) {
    double largest = 0;
    for (int i = 0; i < own; i++) {
      largest = Math.max(largest, a[i][i]);
    }
    for (int i = 0; i < own; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = a[i][j];
        if (i == j) {
          sum = sum * (1 + lambda) + SINGULAR * largest;
        }
        for (int k = 0; k < j; k++) {
          sum -= l[i][k] * l[j][k];
        }
        l[i][j] =
            i == j ? Math.sqrt(Math.max(sum, SINGULAR * Math.max(a[i][i], 1e-300))) : sum / l[j][j];
      }
    }
    solvedGradient = ga.clone();
    solve(solvedGradient);
    solved = new double[shared][own];
    for (int k = 0; k < shared; k++) {
      for (int i = 0; i < own; i++) {
        solved[k][i] = b[i][k];
      }
      solve(solved[k]);
    }
  }

  private void solve(double[] x) {
    for (int i = 0; i < own; i++) {
      double sum = x[i];
      for (int k = 0; k < i; k++) {
        sum -= l[i][k] * x[k];
      }
      x[i] = sum / l[i][i];
    }
    for (int i = own - 1; i >= 0; i--) {
      double sum = x[i];
      for (int k = i + 1; k < own; k++) {
        sum -= l[k][i] * x[k];
      }
      x[i] = sum / l[i][i];
    }
  }

  /** Shared by shared after the elimination; call {@link #factor} first. */
  double[][] reducedMatrix() {
    double[][] s = new double[shared][shared];
    for (int k = 0; k < shared; k++) {
      for (int m = 0; m <= k; m++) {
        double sum = c[k][m];
        for (int i = 0; i < own; i++) {
          sum -= b[i][k] * solved[m][i];
        }
        s[k][m] = sum;
        s[m][k] = sum;
      }
    }
    return s;
  }

  double[] reducedGradient() {
    double[] t = gc.clone();
    for (int k = 0; k < shared; k++) {
      for (int i = 0; i < own; i++) {
        t[k] -= b[i][k] * solvedGradient[i];
      }
    }
    return t;
  }

  /** What is left of chi-square and of the own parameters' priors when those parameters follow, to first order. */
  double reducedCost() {
    return chiSquare + priorCost - dot(ga, solvedGradient);
  }

  /** The own step that belongs to a shared one. */
  double[] ownStep(double[] sharedStep) {
    double[] step = solvedGradient.clone();
    for (int k = 0; k < shared; k++) {
      if (sharedStep[k] != 0) {
        for (int i = 0; i < own; i++) {
          step[i] -= solved[k][i] * sharedStep[k];
        }
      }
    }
    return step;
  }

  /** Variance of an own parameter with everything shared held; call {@link #factor} with no damping first. */
  double ownVariance(int i) {
    double[] e = new double[own];
    e[i] = 1;
    solve(e);
    return e[i];
  }

  /** Twice the logarithm of the determinant's root: of the own part. */
  double logDeterminant() {
    double sum = 0;
    for (int i = 0; i < own; i++) {
      sum += 2 * Math.log(l[i][i]);
    }
    return sum;
  }

  static double dot(double[] x, double[] y) {
    double s0 = 0;
    double s1 = 0;
    int n = x.length & ~1;
    for (int i = 0; i < n; i += 2) {
      s0 += x[i] * y[i];
      s1 += x[i + 1] * y[i + 1];
    }
    return n < x.length ? s0 + s1 + x[n] * y[n] : s0 + s1;
  }
}
