package fieldcal.movement;

import java.util.Arrays;

/**
 * Fits a piece of constant acceleration together with its two neighbours: velocity is continuous, the acceleration changes at two knots whose times are fitted too, and at each not at once but with a {@link Rounding} that is fitted about what is usual. So the path beyond a knot does not lower the piece's acceleration, as it would in a sliding window.
 *
 * <p>Least squares on the positions, each with its own time; a constant for each camera is projected out, so that cameras may disagree. For given knots the
 * problem is linear, so only the knots and their roundings are iterated (variable projection, Golub and Pereyra 1973, in Kaufman's form). The errors of the result contain those of knots and roundings.
 */
final class RampFit {
  /** How well the knots are known beforehand, s: a cell of the grid they come from, and the noise in choosing it. */
  private static final double KNOT_PRIOR = 0.05;

  private static final double SHORTEST = 0.05;
  private static final int ITERATIONS = 16;

  /** Knots are settled within this, s, … */
  private static final double SETTLED = 2e-4;

  /** … and roundings within this, s²: of 5 m/s² it moves the path by 5 µm. */
  private static final double SETTLED_ROUNDING = 1e-6;

  /** The functions whose factors are fitted. */
  private static final int[] FITTED = {RampGram.T, RampGram.T2, RampGram.Q1, RampGram.Q2};

  private static final int LINEAR = FITTED.length;

  /** Knots and roundings of both corners: the derivatives by them, and which of the fitted factors multiplies each. */
  private static final int[] DERIVATIVE = {RampGram.R1, RampGram.R2, RampGram.K1, RampGram.K2};

  private static final int[] FACTOR = {2, 3, 2, 3};
  private static final int[] SIGN = {-1, -1, 1, 1};
  private static final int CURVED = DERIVATIVE.length;

  private final RampGram gram = new RampGram();
  private final double[] f = new double[LINEAR];
  private final double[][] cholesky = new double[LINEAR][LINEAR];
  private final double[][] normal = new double[LINEAR][LINEAR];
  private final double[] cx = new double[LINEAR];
  private final double[] cy = new double[LINEAR];
  private final double[][] u = new double[CURVED][LINEAR];
  private final double[] e = new double[LINEAR];

  /** τ1, τ2, κ1, κ2; what is assumed of them beforehand, and how firmly: the noise's variance over their variance. */
  private final double[] theta = new double[CURVED];

  private final double[] prior = new double[CURVED];
  private final double[] firmness = new double[CURVED];
  private final double[][] information = new double[CURVED][CURVED];
  private final double[][] root = new double[CURVED][CURVED];
  private final double[] gradient = new double[CURVED];

  /** 2 for a path in the plane, 1 for one of an angle, which is given as x with y = 0. */
  private final int dimensions;

  private double width1;
  private double width2;
  private int freedom;
  private double rss;

  /**
   * A fit of paths.
   *
   * @param dimensions 1 or 2; in one dimension, y must be 0
   */
  RampFit(int dimensions) {
    this.dimensions = dimensions;
  }

  /**
   * Fits the detections of [from, to] with knots near τ1 and τ2.
   *
   * @param first what is usual at the first knot
   * @param second what is usual at the second knot
   * @return false when there are too few, or the knots diverge
   */
  boolean fit(
      Stretch s,
      double from,
      double to,
      double firstKnot,
      double secondKnot,
      Rounding first,
      Rounding second,
      double variance) {
    gram.read(s, s.indexAt(from), s.indexAt(to));
    freedom = dimensions * (gram.samples() - LINEAR - gram.cameras()) - CURVED;
    believe(0, firstKnot, KNOT_PRIOR, variance);
    believe(1, secondKnot, KNOT_PRIOR, variance);
    believe(2, first.mean(), first.scatter(), variance);
    believe(3, second.mean(), second.scatter(), variance);
    width1 = first.width();
    width2 = second.width();
    System.arraycopy(prior, 0, theta, 0, CURVED);
    for (int i = 0; i < ITERATIONS; i++) {
      gram.accumulate(corner(0, width1), corner(1, width2));
      if (gram.samples() < 12 || !solveLinear() || !linearise()) {
        return false;
      }
      solveCurved(gradient);
      gradient[0] = limited(gradient[0], 0.02);
      gradient[1] = limited(gradient[1], 0.02);
      double knots = Math.abs(gradient[0]) + Math.abs(gradient[1]);
      double roundings = Math.abs(gradient[2]) + Math.abs(gradient[3]);
      if (!(knots + roundings < 1)) {
        return false;
      }
      if (knots < SETTLED && roundings < SETTLED_ROUNDING) {
        rss = Math.max(0, unexplained(RampGram.X, cx) + unexplained(RampGram.Y, cy));
        return freedom > 0;
      }
      for (int j = 0; j < CURVED; j++) {
        theta[j] += gradient[j];
      }
      if (theta[1] - theta[0] < SHORTEST || theta[0] < from || theta[1] > to) {
        return false;
      }
    }
    return false;
  }

  private RampGram.Corner corner(int knot, double width) {
    return new RampGram.Corner(theta[knot], width, theta[2 + knot] - prior[2 + knot]);
  }

  /** Sum of the squares of a coordinate that the fitted functions leave. */
  private double unexplained(int coordinate, double[] c) {
    return gram.get(coordinate, coordinate) - dot(coordinate, c);
  }

  private void believe(int j, double mean, double scatter, double variance) {
    prior[j] = mean;
    firmness[j] = variance / (scatter * scatter);
  }

  private static double limited(double step, double most) {
    return Math.max(-most, Math.min(most, step));
  }

  /** Normal equations of knots and roundings, with the fitted factors projected out; false when they are singular. */
  private boolean linearise() {
    for (int j = 0; j < CURVED; j++) {
      double ax = SIGN[j] * cx[FACTOR[j]];
      double ay = SIGN[j] * cy[FACTOR[j]];
      int function = DERIVATIVE[j];
      gradient[j] =
          ax * (gram.get(RampGram.X, function) - dot(function, cx))
              + ay * (gram.get(RampGram.Y, function) - dot(function, cy))
              - firmness[j] * (theta[j] - prior[j]);
      for (int k = 0; k <= j; k++) {
        double b = SIGN[k] * (ax * cx[FACTOR[k]] + ay * cy[FACTOR[k]]);
        information[j][k] = b * (gram.get(function, DERIVATIVE[k]) - dot(function, u[k]));
      }
      information[j][j] += firmness[j];
    }
    return decompose(information, root);
  }

  private static boolean decompose(double[][] a, double[][] root) {
    for (int i = 0; i < a.length; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = a[i][j];
        for (int k = 0; k < j; k++) {
          sum -= root[i][k] * root[j][k];
        }
        if (i == j) {
          if (!(sum > 1e-9 * a[i][i])) {
            return false;
          }
          root[i][i] = Math.sqrt(sum);
        } else {
          root[i][j] = sum / root[j][j];
        }
      }
    }
    return true;
  }

  private void solveCurved(double[] b) {
    solve(root, b);
  }

  private static void solve(double[][] root, double[] b) {
    int n = root.length;
    for (int i = 0; i < n; i++) {
      double sum = b[i];
      for (int k = 0; k < i; k++) {
        sum -= root[i][k] * b[k];
      }
      b[i] = sum / root[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
      double sum = b[i];
      for (int k = i + 1; k < n; k++) {
        sum -= root[k][i] * b[k];
      }
      b[i] = sum / root[i][i];
    }
  }

  /** Sum over the linear functions of their product with function j, weighted. */
  private double dot(int j, double[] c) {
    double sum = 0;
    for (int k = 0; k < LINEAR; k++) {
      sum += gram.get(j, FITTED[k]) * c[k];
    }
    return sum;
  }

  private boolean solveLinear() {
    double[][] a = normal;
    for (int i = 0; i < LINEAR; i++) {
      for (int j = 0; j <= i; j++) {
        a[i][j] = gram.get(FITTED[i], FITTED[j]);
      }
    }
    if (!decompose(a, cholesky)) {
      return false;
    }
    for (int k = 0; k < LINEAR; k++) {
      cx[k] = gram.get(RampGram.X, FITTED[k]);
      cy[k] = gram.get(RampGram.Y, FITTED[k]);
      for (int j = 0; j < CURVED; j++) {
        u[j][k] = gram.get(DERIVATIVE[j], FITTED[k]);
      }
    }
    solve(cholesky, cx);
    solve(cholesky, cy);
    for (int j = 0; j < CURVED; j++) {
      solve(cholesky, u[j]);
    }
    return true;
  }

  /** A corner's rounding as the detections alone determine it, s², and its variance for a given variance of a detection. */
  void learn(int corner, double variance, Rounding sink) {
    int j = 2 + corner;
    Arrays.fill(gradient, 0);
    gradient[j] = 1;
    solveCurved(gradient);
    double alone = 1 / gradient[j] - firmness[j];
    if (alone > 0) {
      double own = prior[j] + (theta[j] - prior[j]) * (alone + firmness[j]) / alone;
      sink.add(own, variance / alone);
    }
  }

  double firstKnot() {
    return theta[0];
  }

  double secondKnot() {
    return theta[1];
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

  /** By how much the acceleration along a direction grows at the first (0) or the second knot (1), m/s². */
  double change(int knot, double nx, double ny) {
    return cx[FACTOR[knot]] * nx + cy[FACTOR[knot]] * ny;
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
    e[1] = 0.5 * (theta[1] - theta[0]);
    e[2] = e[1];
    return parameterVariance(nx, ny, variance);
  }

  /** Variance of eᵀc along a unit vector. */
  private double parameterVariance(double nx, double ny, double variance) {
    for (int j = 0; j < CURVED; j++) {
      double w = 0;
      for (int k = 0; k < LINEAR; k++) {
        w += e[k] * u[j][k];
      }
      gradient[j] = w * (cx[FACTOR[j]] * nx + cy[FACTOR[j]] * ny) * SIGN[j];
    }
    double curved = 0;
    for (int i = 0; i < CURVED; i++) {
      double sum = gradient[i];
      for (int k = 0; k < i; k++) {
        sum -= root[i][k] * gradient[k];
      }
      gradient[i] = sum / root[i][i];
      curved += gradient[i] * gradient[i];
    }
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
    return variance * (linear + curved);
  }
}
