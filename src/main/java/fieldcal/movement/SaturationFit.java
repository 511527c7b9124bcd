package fieldcal.movement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Finds where manoeuvres pile up. Robots that are in a hurry accelerate as much as they can, so the accelerations of a team gather at its limit, while milder ones are spread below: the limit is a mode, and may
 * depend linearly on a few columns (speed, direction).
 *
 * <p>Modal linear regression (Yao and Li 2014): the {@linkplain #mass mass} Σ exp(−r²/2h²) is climbed by iterated weighted least squares. Each manoeuvre has a kernel of its own width h, twice its standard error
 * and three per cent of the limit, so that the noise of a manoeuvre neither moves nor hides the mode, and what is not at the limit has no weight.
 */
final class SaturationFit {
  /** The kernel in standard errors of a manoeuvre: wide enough to hold nearly all of the noise. */
  private static final double ERRORS = 2;

  /** Width of the kernel as a fraction of the limit: robots of a team differ by this much. */
  private static final double SPREAD = 0.03;

  /** A higher mode counts as the limit when it holds at least this part of the largest one's mass … */
  private static final double SECOND_MODE = 0.12;

  /** … and at least this many manoeuvres. */
  private static final double SECOND_MODE_MASS = 8;

  private static final double[] QUANTILES = {0.15, 0.3, 0.45, 0.6, 0.75, 0.85, 0.92, 0.97};

  /** Weights below exp(−40) are less than the rounding of those at the mode, 1e-16. */
  private static final double FAR = 40;

  private static final int ITERATIONS = 80;
  private static final double SETTLED = 1e-6;

  /** Places that are no farther apart, relative to the limit, are the same: climbs stop this near to a mode, and modes are some per cent apart, the width of a kernel. */
  private static final double SAME = 1e-4;

  private final ManoeuvreTable.Columns data;
  private final double[][] columns;
  private final int size;
  private final double[] acceleration;
  private final double[] count;

  /** Part of the squared width of each manoeuvre's kernel that is due to its own error. */
  private final double[] squaredKernel;

  private final double total;

  /** The rows of known acceleration in its order: what was taken out of a table has changed the order of its rows. */
  private final int[] ascending;

  /**
   * A mode.
   *
   * @param beta the limit where all columns are 0, and its change per unit of each column
   * @param errors standard errors of beta
   * @param mass number of manoeuvres that lie there, weighted by the kernel
   * @param share of all manoeuvres
   * @param noise mean standard error of the manoeuvres that lie there
   */
  record Mode(double[] beta, double[] errors, double mass, double share, double noise) {}

  /** Looks for modes of the accelerations; without further columns for a uniform limit. A row with NaN in a column does not count. */
  SaturationFit(ManoeuvreTable.Columns data, double[]... further) {
    this.data = data;
    columns = new double[1 + further.length][];
    columns[0] = new double[data.count().length];
    Arrays.fill(columns[0], 1);
    System.arraycopy(further, 0, columns, 1, further.length);
    total = Arrays.stream(data.count()).sum();
    acceleration = data.acceleration();
    count = data.count();
    size = count.length;
    ascending =
        IntStream.range(0, size)
            .filter(i -> !Double.isNaN(acceleration[i]))
            .boxed()
            .sorted(Comparator.comparingDouble(i -> acceleration[i]))
            .mapToInt(i -> i)
            .toArray();
    squaredKernel = Arrays.stream(data.error()).map(e -> ERRORS * e * (ERRORS * e)).toArray();
  }

  /**
   * Modes of a uniform limit.
   *
   * @param largest the one at which most manoeuvres lie
   * @param highest the highest one that holds a fair part of the largest one's mass
   */
  record Uniform(Mode largest, Mode highest) {}

  /** The uniform limit; null when there is none. */
  static Uniform uniform(ManoeuvreTable.Columns data) {
    List<Mode> modes = modes(new SaturationFit(data.merged()));
    if (modes.isEmpty()) {
      return null;
    }
    Mode largest = modes.stream().max(Comparator.comparingDouble(Mode::mass)).orElseThrow();
    Mode highest = largest;
    for (Mode m : modes) {
      boolean fair =
          m.mass() > SECOND_MODE * largest.mass()
              && m.mass() > SECOND_MODE_MASS
              && m.errors()[0] < 0.1 * m.beta()[0];
      if (fair && m.beta()[0] > highest.beta()[0]) {
        highest = m;
      }
    }
    return new Uniform(largest, highest);
  }

  /** The same mode may be found several times. */
  private static List<Mode> modes(SaturationFit fit) {
    List<Mode> modes = new ArrayList<>();
    for (double share : QUANTILES) {
      Mode found = fit.climb(new double[] {fit.quantile(share)});
      if (found != null) {
        modes.add(found);
      }
    }
    return modes;
  }

  /** The acceleration below which that share of the manoeuvres lies; those of unknown acceleration do not count. NaN when there are no others. */
  private double quantile(double share) {
    double wanted = share * Arrays.stream(ascending).mapToDouble(i -> count[i]).sum();
    double below = 0;
    for (int i : ascending) {
      below += count[i];
      if (below >= wanted) {
        return acceleration[i];
      }
    }
    return ascending.length == 0 ? Double.NaN : acceleration[ascending[ascending.length - 1]];
  }

  /**
   * Climbs to the largest mode of a limit that depends on columns, from many starts; null when there is none. A wide kernel leaves few modes: climbs that meet there continue as one.
   *
   * @param spreads widths of kernels before the proper one, as fractions of the limit, the widest first
   */
  Mode climbFromEverywhere(double[] coefficients, double... spreads) {
    int p = columns.length;
    List<double[]> points = new ArrayList<>();
    for (double share : QUANTILES) {
      for (double coefficient : coefficients) {
        double[] start = new double[p];
        start[0] = quantile(share);
        for (int k = 1; k < p; k++) {
          start[k] = -coefficient * start[0];
        }
        points.add(start);
      }
    }
    for (double spread : spreads) {
      points = climb(points, spread);
    }
    return climb(points, SPREAD).stream()
        .map(this::describe)
        .max(Comparator.comparingDouble(Mode::mass))
        .orElse(null);
  }

  /** The places that the starts lead to, each once. */
  private List<double[]> climb(List<double[]> starts, double spread) {
    List<double[]> ends = new ArrayList<>();
    for (double[] start : starts) {
      double[] end = climb(start, spread);
      if (end != null && ends.stream().noneMatch(other -> change(end, other) < SAME * end[0])) {
        ends.add(end);
      }
    }
    return ends;
  }

  /** Climbs from a start to the mode. Null when there is none. */
  Mode climb(double[] start) {
    double[] beta = climb(start, SPREAD);
    return beta == null ? null : describe(beta);
  }

  private double[] climb(double[] start, double spread) {
    double[] beta = start;
    for (int i = 0; i < ITERATIONS; i++) {
      double[] next = step(beta, spread);
      if (next == null || !(next[0] > 0)) {
        return null;
      }
      double change = change(next, beta);
      beta = next;
      if (change < SETTLED * beta[0]) {
        break;
      }
    }
    return beta;
  }

  private static double change(double[] next, double[] beta) {
    double change = 0;
    for (int k = 0; k < beta.length; k++) {
      change = Math.max(change, Math.abs(next[k] - beta[k]));
    }
    return change;
  }

  private double[] step(double[] beta, double spread) {
    int p = beta.length;
    double[][] a = new double[p][p];
    double[] b = new double[p];
    double both = both(beta);
    double floor = spread * spread * beta[0] * beta[0];
    for (int i = 0; i < size; i++) {
      double product = both == 0 ? 0 : both * columns[1][i] * columns[2][i];
      double value = acceleration[i] - product;
      double r = value;
      for (int k = 0; k < p; k++) {
        r -= beta[k] * columns[k][i];
      }
      double h2 = squaredKernel[i] + floor;
      double exponent = 0.5 * r * r / h2;
      if (!(exponent < FAR)) {
        continue;
      }
      double w = count[i] * Math.exp(-exponent) / h2;
      for (int j = 0; j < p; j++) {
        double wj = w * columns[j][i];
        b[j] += wj * value;
        for (int k = 0; k <= j; k++) {
          a[j][k] += wj * columns[k][i];
        }
      }
    }
    for (int j = 0; j < p; j++) {
      for (int k = 0; k < j; k++) {
        a[k][j] = a[j][k];
      }
    }
    DecompositionSolver solver = solver(a);
    return solver == null ? null : solver.solve(new Array2DRowRealMatrix(b)).getColumn(0);
  }

  private static DecompositionSolver solver(double[][] a) {
    DecompositionSolver solver =
        new LUDecomposition(new Array2DRowRealMatrix(a, false), 1e-12 * a[0][0]).getSolver();
    return solver.isNonSingular() ? solver : null;
  }

  private double residual(int i, double[] beta) {
    double r = acceleration[i] - (beta.length < 3 ? 0 : both(beta) * columns[1][i] * columns[2][i]);
    for (int k = 0; k < beta.length; k++) {
      r -= beta[k] * columns[k][i];
    }
    return r;
  }

  /** Two effects multiply: per unit of both columns, what that adds to their sum, from the coefficients of the iteration before. */
  private static double both(double[] beta) {
    return beta.length < 3 ? 0 : beta[1] * beta[2] / beta[0];
  }

  private double width2(int i, double limit, double spread) {
    return squaredKernel[i] + spread * spread * limit * limit;
  }

  /** Mass, and errors from the sandwich A⁻¹BA⁻¹ of the estimating equations. */
  private Mode describe(double[] beta) {
    int p = beta.length;
    double[][] a = new double[p][p];
    double[][] b = new double[p][p];
    double mass = 0;
    double noise = 0;
    for (int i = 0; i < data.count().length; i++) {
      double r = residual(i, beta);
      double h2 = width2(i, beta[0], SPREAD);
      double kernel = Math.exp(-0.5 * r * r / h2);
      if (!(kernel >= 0)) {
        continue;
      }
      double n = data.count()[i];
      mass += n * kernel;
      noise += n * kernel * data.error()[i];
      double w = kernel / h2;
      for (int j = 0; j < p; j++) {
        for (int k = 0; k < p; k++) {
          double product = columns[j][i] * columns[k][i];
          a[j][k] += n * w * (1 - r * r / h2) * product;
          b[j][k] += n * w * w * r * r * product;
        }
      }
    }
    double[] errors = new double[p];
    Arrays.fill(errors, Double.POSITIVE_INFINITY);
    DecompositionSolver solver = a[0][0] > 0 ? solver(a) : null;
    if (solver != null) {
      RealMatrix inverse = solver.getInverse();
      RealMatrix covariance =
          inverse.multiply(new Array2DRowRealMatrix(b, false)).multiply(inverse.transpose());
      for (int k = 0; k < p; k++) {
        errors[k] = Math.sqrt(covariance.getEntry(k, k));
      }
    }
    return new Mode(beta, errors, mass, mass / total, noise / mass);
  }
}
