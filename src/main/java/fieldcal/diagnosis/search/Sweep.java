package fieldcal.diagnosis.search;

import fieldcal.fit.joint.ScoreSystem;

/**
 * Least squares with a changing set of columns: the sweep operator (Goodnight 1979) on normal equations. After sweeping a set in, the rest of the table holds the equations of all other columns with that set refitted. Not thread-safe.
 */
final class Sweep {
  /** A column of which less than that share is left by the columns swept in is a combination of them. */
  private static final double COLLINEAR = 1e-9;

  private final int n;
  private final double[][] m;
  private final double[] original;
  private final boolean[] in;

  /**
   * @param precisions prior precision of each column, 0 = none
   */
  Sweep(ScoreSystem system, double[] precisions) {
    this(system, precisions, new double[system.size()]);
  }

  /**
   * @param removed by how much each parameter is taken back from where the system was made
   */
  Sweep(ScoreSystem system, double[] precisions, double[] removed) {
    n = system.size();
    m = new double[n + 1][n + 1];
    original = new double[n];
    in = new boolean[n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        m[i][j] = system.curvature(i, j);
      }
      m[i][i] += precisions[i];
      original[i] = m[i][i];
      m[i][n] = system.slope(i);
      for (int j = 0; j < n; j++) {
        if (removed[j] != 0) {
          m[i][n] += system.curvature(i, j) * removed[j];
        }
      }
      m[n][i] = m[i][n];
    }
  }

  private Sweep(Sweep of) {
    n = of.n;
    m = new double[n + 1][];
    for (int i = 0; i <= n; i++) {
      m[i] = of.m[i].clone();
    }
    original = of.original;
    in = of.in.clone();
  }

  Sweep copy() {
    return new Sweep(this);
  }

  boolean contains(int column) {
    return in[column];
  }

  /** Sweeps a column in, or out again; a collinear one is left alone. */
  void toggle(int column) {
    double d = m[column][column];
    if (!in[column] && !(d > COLLINEAR * original[column])) {
      return;
    }
    boolean leaving = in[column];
    double sign = leaving ? -1 : 1;
    double[] pivotRow = m[column].clone();
    for (int i = 0; i <= n; i++) {
      if (i == column) {
        continue;
      }
      double factor = m[i][column] / d;
      if (factor == 0) {
        continue;
      }
      double[] row = m[i];
      for (int j = 0; j <= n; j++) {
        if (j != column) {
          row[j] -= factor * pivotRow[j];
        }
      }
      row[column] = sign * factor;
    }
    for (int j = 0; j <= n; j++) {
      if (j != column) {
        m[column][j] = sign * pivotRow[j] / d;
      }
    }
    m[column][column] = -1 / d;
    in[column] = !leaving;
  }

  /** What a set of columns that are out would gain together: gᵀH⁻¹g of their block. */
  double gain(int[] columns) {
    int k = columns.length;
    double[][] l = new double[k][k];
    double[] y = new double[k];
    double gain = 0;
    for (int i = 0; i < k; i++) {
      int ci = columns[i];
      for (int j = 0; j <= i; j++) {
        double sum = m[ci][columns[j]];
        for (int p = 0; p < j; p++) {
          sum -= l[i][p] * l[j][p];
        }
        if (i == j) {
          l[i][i] = sum > COLLINEAR * original[ci] ? Math.sqrt(sum) : Double.POSITIVE_INFINITY;
        } else {
          l[i][j] = sum / l[j][j];
        }
      }
      double rhs = m[ci][n];
      for (int p = 0; p < i; p++) {
        rhs -= l[i][p] * y[p];
      }
      y[i] = rhs / l[i][i];
      gain += y[i] * y[i];
    }
    return gain;
  }

  /** What a column that is out would gain by the best number within a range: beyond the range its end is best. */
  double gain(int column, double min, double max) {
    return gain(m[column][n], m[column][column], original[column], min, max);
  }

  /**
   * The same of several columns that are out and have the same number.
   *
   * @param alone curvature of their sum before anything is swept in, without a prior
   * @param repeated how much of the curvature is precision of the prior that is there once too often for each further column
   */
  double gainTogether(int[] columns, double alone, double repeated, double min, double max) {
    double slope = 0;
    double curvature = -repeated;
    for (int i : columns) {
      slope += m[i][n];
      for (int j : columns) {
        curvature += m[i][j];
      }
    }
    return gain(slope, curvature, alone, min, max);
  }

  private static double gain(double slope, double curvature, double alone, double min, double max) {
    if (!(curvature > COLLINEAR * alone)) {
      return 0;
    }
    double value = Math.max(min, Math.min(max, slope / curvature));
    return (2 * slope - curvature * value) * value;
  }

  /** Estimate of a column that is in. */
  double estimate(int column) {
    return m[column][n];
  }
}
