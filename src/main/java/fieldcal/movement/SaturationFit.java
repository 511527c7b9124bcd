package fieldcal.movement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Finds where manoeuvres pile up. Robots that are in a hurry use all they have, so the accelerations of a team gather at its limit, while milder ones are spread below: the limit is a mode, and may
 * depend linearly on a few columns (speed, direction).
 *
 * <p>Modal linear regression (Yao and Li 2014): the {@linkplain #mass mass} Σ exp(−r²/2h²) is climbed by iterated weighted least squares. Each manoeuvre has a kernel of its own width h, twice its standard error
 * and three per cent of the limit, so that the noise of a manoeuvre neither moves nor hides the mode, and what is not at the limit has no weight.
 */
final class SaturationFit {
  /** The kernel in standard errors of a manoeuvre: wide enough to hold nearly all that noise does. */
  private static final double ERRORS = 2;

  /** Width of the kernel as a fraction of the limit: robots of a team differ by this much. */
  private static final double SPREAD = 0.03;

  /** A higher mode counts as the limit when it holds at least this part of the largest one's mass … */
  private static final double SECOND_MODE = 0.12;

  /** … and at least so many manoeuvres. */
  private static final double SECOND_MODE_MASS = 8;

  private static final double[] QUANTILES = {0.15, 0.3, 0.45, 0.6, 0.75, 0.85, 0.92, 0.97};

  private static final int ITERATIONS = 80;
  private static final double SETTLED = 1e-6;

  private final ManoeuvreTable.Columns data;
  private final double[][] columns;
  private final double total;

  /**
   * A mode.
   *
   * @param beta value without, and change per unit of each column
   * @param errors standard errors of beta
   * @param mass how much lies there, in manoeuvres
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
  }

  /**
   * Modes of a uniform limit.
   *
   * @param largest at which most manoeuvres lie
   * @param highest at which a fair part of what the largest one holds lies
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

  /** The acceleration below which that share of the manoeuvres lies, if the rows are in their order. */
  private double quantile(double share) {
    double wanted = share * total;
    double below = 0;
    for (int i = 0; i < data.count().length; i++) {
      below += data.count()[i];
      if (below >= wanted) {
        return data.acceleration()[i];
      }
    }
    return data.acceleration()[data.count().length - 1];
  }

  /** Climbs to the largest mode of a limit that depends on columns, from many starts; null when there is none. */
  Mode climbFromEverywhere(double[] coefficients, double... spreads) {
    int p = columns.length;
    Mode best = null;
    for (double share : QUANTILES) {
      for (double coefficient : coefficients) {
        double[] start = new double[p];
        start[0] = quantile(share);
        for (int k = 1; k < p; k++) {
          start[k] = -coefficient * start[0];
        }
        Mode found = climb(start, spreads);
        if (found != null && (best == null || found.mass() > best.mass())) {
          best = found;
        }
      }
    }
    return best;
  }

  /** Climbs from a start to the mode; the kernel is made narrower step by step, down to its proper width. Null when there is none. */
  Mode climb(double[] start, double... spreads) {
    double[] beta = start.clone();
    for (double spread : spreads) {
      beta = climb(beta, spread);
      if (beta == null) {
        return null;
      }
    }
    beta = climb(beta, SPREAD);
    return beta == null ? null : describe(beta);
  }

  private double[] climb(double[] start, double spread) {
    double[] beta = start;
    for (int i = 0; i < ITERATIONS; i++) {
      double[] next = step(beta, spread);
      if (next == null || !(next[0] > 0)) {
        return null;
      }
      double change = 0;
      for (int k = 0; k < beta.length; k++) {
        change = Math.max(change, Math.abs(next[k] - beta[k]));
      }
      beta = next;
      if (change < SETTLED * beta[0]) {
        break;
      }
    }
    return beta;
  }

  private double[] step(double[] beta, double spread) {
    int p = beta.length;
    double[][] a = new double[p][p];
    double[] b = new double[p];
    for (int i = 0; i < data.count().length; i++) {
      double r = residual(i, beta);
      double h2 = width2(i, beta[0], spread);
      double w = data.count()[i] * Math.exp(-0.5 * r * r / h2) / h2;
      if (!(w > 0)) {
        continue;
      }
      for (int j = 0; j < p; j++) {
        b[j] += w * columns[j][i] * (data.acceleration()[i] - product(i, beta));
        for (int k = 0; k < p; k++) {
          a[j][k] += w * columns[j][i] * columns[k][i];
        }
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
    double r = data.acceleration()[i] - product(i, beta);
    for (int k = 0; k < beta.length; k++) {
      r -= beta[k] * columns[k][i];
    }
    return r;
  }

  /** Two effects multiply: what that adds to their sum, from the coefficients of the iteration before. */
  private double product(int i, double[] beta) {
    return beta.length < 3 ? 0 : beta[1] * beta[2] / beta[0] * columns[1][i] * columns[2][i];
  }

  private double width2(int i, double limit, double spread) {
    double error = ERRORS * data.error()[i];
    return error * error + spread * spread * limit * limit;
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
