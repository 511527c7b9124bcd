package fieldcal.fit.joint;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Normal equations of one kick: own parameters first, then columns that are shared. The own parameters are eliminated by a Schur complement, so that the system of all kicks stays as small as the number of shared columns,
 * however many kicks there are.
 */
final class KickBlock {
  /** Relative size below which a pivot means that the data do not determine an own parameter. */
  private static final double SINGULAR = 1e-12;

  /** Rows whose products are summed in one go. */
  private static final int TOGETHER = 4;

  /** Rows that are taken from the columns at once: as many numbers as a line of the processor's cache holds; a multiple of {@link #TOGETHER}. */
  private static final int GATHERED = 8;

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
    this(own, shared, new double[shared][shared]);
  }

  private KickBlock(int own, int shared, double[][] c) {
    this.own = own;
    this.shared = shared;
    this.c = c;
    a = new double[own][own];
    b = new double[own][shared];
    ga = new double[own];
    gc = new double[shared];
    l = new double[own][own];
  }

  /** A copy, to be tied and factored by itself. The products of shared columns are the most by far, and are copied by row when a tie changes them; nothing can be added to a copy. */
  KickBlock(KickBlock of) {
    this(of.own, of.shared, of.c.clone());
    for (int i = 0; i < own; i++) {
      System.arraycopy(of.a[i], 0, a[i], 0, own);
      System.arraycopy(of.b[i], 0, b[i], 0, shared);
    }
    System.arraycopy(of.ga, 0, ga, 0, own);
    System.arraycopy(of.gc, 0, gc, 0, shared);
    chiSquare = of.chiSquare;
    priorCost = of.priorCost;
  }

  /** Adds rows: columns are derivatives of the prediction, residuals observed minus predicted. */
  void add(double[][] ownColumns, double[][] sharedColumns, double[] residuals, double weight) {
    addProducts(ownColumns, sharedColumns, residuals.length, weight);
    addResiduals(ownColumns, sharedColumns, residuals, weight);
  }

  /** Adds what the residuals of rows bring, whose products have been added. */
  void addResiduals(
      double[][] ownColumns, double[][] sharedColumns, double[] residuals, double weight) {
    chiSquare += weight * dot(residuals, residuals);
    for (int i = 0; i < own; i++) {
      ga[i] += weight * dot(ownColumns[i], residuals);
    }
    for (int k = 0; k < shared; k++) {
      gc[k] += weight * dot(sharedColumns[k], residuals);
    }
  }

  /** Adds the products of the columns of rows. */
  void addProducts(double[][] ownColumns, double[][] sharedColumns, int rows, double weight) {
    // Some rows of all columns at once: the search asks for hundreds of columns, of which dot
    // products would each read all rows. Most of them do not concern this kick: other cameras,
    // places, robots.
    int[] used = nonZero(sharedColumns);
    double[][] columns = Arrays.copyOf(ownColumns, own + used.length);
    for (int k = 0; k < used.length; k++) {
      columns[own + k] = sharedColumns[used[k]];
    }
    double[][] products = new double[columns.length][columns.length];
    double[][] some = new double[GATHERED][columns.length];
    for (int from = 0; from < rows; from += GATHERED) {
      gather(columns, from, some);
      for (int r = 0; r < GATHERED; r += TOGETHER) {
        for (int k = 0; k < columns.length; k++) {
          addProducts(columns[k], from + r, weight, some, r, products[k], k + 1);
        }
      }
    }
    for (int i = 0; i < own; i++) {
      for (int j = 0; j <= i; j++) {
        a[i][j] += products[i][j];
        a[j][i] = a[i][j];
      }
    }
    for (int k = 0; k < used.length; k++) {
      double[] product = products[own + k];
      for (int i = 0; i < own; i++) {
        b[i][used[k]] += product[i];
      }
      for (int m = 0; m <= k; m++) {
        c[used[k]][used[m]] += product[own + m];
        c[used[m]][used[k]] = c[used[k]][used[m]];
      }
    }
  }

  /** The columns that are not zero in all rows. */
  private static int[] nonZero(double[][] columns) {
    return IntStream.range(0, columns.length).filter(k -> !isZero(columns[k])).toArray();
  }

  private static boolean isZero(double[] column) {
    for (double v : column) {
      if (v != 0) {
        return false;
      }
    }
    return true;
  }

  /** Some rows of the columns, zero after the last. */
  private static void gather(double[][] columns, int from, double[][] some) {
    for (int k = 0; k < columns.length; k++) {
      double[] column = columns[k];
      for (int r = 0; r < GATHERED; r++) {
        some[r][k] = at(column, from + r);
      }
    }
  }

  private static double at(double[] column, int row) {
    return row < column.length ? column[row] : 0;
  }

  /** Adds to sums[m], for m below {@code count}, the products of a column with column m over a few rows; nothing where the column is zero, as a camera's is for balls that it does not see. */
  private static void addProducts(
      double[] column,
      int from,
      double weight,
      double[][] some,
      int first,
      double[] sums,
      int count) {
    double f0 = weight * at(column, from);
    double f1 = weight * at(column, from + 1);
    double f2 = weight * at(column, from + 2);
    double f3 = weight * at(column, from + 3);
    if (f0 == 0 && f1 == 0 && f2 == 0 && f3 == 0) {
      return;
    }
    double[] r0 = some[first];
    double[] r1 = some[first + 1];
    double[] r2 = some[first + 2];
    double[] r3 = some[first + 3];
    for (int m = 0; m < count; m++) {
      sums[m] += f0 * r0[m] + f1 * r1[m] + (f2 * r2[m] + f3 * r3[m]);
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
      c[k] = c[k].clone();
      c[k][k] += precision;
      gc[k] += precision * distance;
    }
  }

  /** Factors the own part, damped by {@code lambda}. */
  void factor(double lambda) {
    double[] free = new double[own];
    Arrays.fill(free, Double.NaN);
    factor(lambda, free);
  }

  /** The same with the steps of some own parameters given: those that are no NaN. */
  void factor(double lambda, double[] given) {
    double largest = 0;
    for (int i = 0; i < own; i++) {
      largest = Math.max(largest, a[i][i]);
    }
    for (int i = 0; i < own; i++) {
      for (int j = 0; j <= i; j++) {
        if (isGiven(given[i]) || isGiven(given[j])) {
          l[i][j] = i == j ? 1 : 0;
          continue;
        }
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
    solvedGradient = new double[own];
    for (int i = 0; i < own; i++) {
      solvedGradient[i] = isGiven(given[i]) ? given[i] : ga[i];
      for (int j = 0; j < own && !isGiven(given[i]); j++) {
        solvedGradient[i] -= isGiven(given[j]) ? a[i][j] * given[j] : 0;
      }
    }
    solve(solvedGradient);
    solved = new double[shared][own];
    for (int k = 0; k < shared; k++) {
      if (isZero(k)) {
        continue;
      }
      for (int i = 0; i < own; i++) {
        solved[k][i] = isGiven(given[i]) ? 0 : b[i][k];
      }
      solve(solved[k]);
    }
  }

  /** Whether a shared column does not concern this kick. */
  private boolean isZero(int k) {
    return c[k][k] == 0;
  }

  private static boolean isGiven(double step) {
    return !Double.isNaN(step);
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
      addReducedRow(k, s[k]);
      for (int m = 0; m < k; m++) {
        s[m][k] = s[k][m];
      }
    }
    return s;
  }

  /** Adds a row of the same, as far as the diagonal. */
  void addReducedRow(int k, double[] row) {
    if (isZero(k)) {
      return;
    }
    double[] ofOwn = new double[own];
    for (int i = 0; i < own; i++) {
      ofOwn[i] = b[i][k];
    }
    for (int m = 0; m <= k; m++) {
      double sum = c[k][m];
      for (int i = 0; i < own; i++) {
        sum -= ofOwn[i] * solved[m][i];
      }
      row[m] += sum;
    }
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

  /** By how much the own parameters follow each shared one, with the sign turned round; call {@link #factor} first. Not to be changed. */
  double[][] following() {
    return solved;
  }

  /** Variance of an own parameter with everything shared held; call {@link #factor} with no damping first. */
  double ownVariance(int i) {
    double[] e = new double[own];
    e[i] = 1;
    solve(e);
    return e[i];
  }

  /** Whether all are numbers: near what cannot be predicted derivatives may be none. */
  static boolean areFinite(double[] x) {
    for (double v : x) {
      if (!Double.isFinite(v)) {
        return false;
      }
    }
    return true;
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
