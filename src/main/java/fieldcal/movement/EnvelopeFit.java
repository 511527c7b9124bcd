package fieldcal.movement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * The limit by direction, of any shape: the modal regression of {@link SaturationFit} with a polygon over the directions, f(φ) = Σ vₖ·Bₖ(φ), Bₖ a hat of one direction's width to either side.
 *
 * <p>Maximizes Σ n·exp(−(a − f(φ))²/2h²) − ½ Σ (vₖ₋₁ − 2vₖ + vₖ₊₁)²/s² by iterated weighted least squares: the manoeuvres pile up at the polygon, and where manoeuvres are few, its corners bend by no more than s = {@link #BEND} of the limit
 * or so (P-splines, Eilers and Marx 1996). The errors are the sandwich A⁻¹BA⁻¹ of the estimating equations.
 */
final class EnvelopeFit {
  private static final int KNOTS = Envelope.DIRECTIONS;

  /** Prior standard deviation of the difference between the slopes of neighbouring sides of the polygon, as a part of the limit per direction: a limit that falls to half as |sin φ| does, bends by 0.17 at its corner. */
  private static final double BEND = 0.1;

  /** As {@link SaturationFit}'s kernel, in standard errors of a manoeuvre … */
  private static final double ERRORS = 2;

  /** … and in parts of the limit. */
  private static final double SPREAD = 0.03;

  /** The kernel is made narrower down to its proper width, so that a start some per cent off finds the mode. */
  private static final double[] SPREADS = {0.15, 0.08, 0.05, SPREAD};

  private static final int ITERATIONS = 60;
  private static final double SETTLED = 1e-5;

  /** The search in a direction starts from the manoeuvres within this many directions of it, … */
  private static final int START_WINDOW = 2;

  /** … if there are so many. */
  private static final double START_FEWEST = 6;

  /** So many manoeuvres must lie at the limit about a direction, … */
  private static final double FEWEST = 4;

  /** … and this part of those about it; … */
  private static final double REACHED = 0.1;

  /** … with a smaller standard error, in parts. */
  private static final double WORST = 0.08;

  /** Error of the method apart from noise, as a part of the limit: the straight sides of the polygon, and 5° of the table's classes. */
  private static final double SYSTEMATIC = 0.01;

  private final double[] acceleration;
  private final double[] error;
  private final double[] count;

  /** The hat on the left of each manoeuvre's direction, and how far it is from there to the next. */
  private final int[] left;

  private final double[] part;
  private final double total;
  private double[] values;
  private double[] errors;
  private double[] at;
  private double[] about;
  private double mass;

  /** Takes rows of known direction. */
  private EnvelopeFit(ManoeuvreTable.Columns data) {
    int n = data.count().length;
    int[] rows = new int[n];
    int kept = 0;
    for (int i = 0; i < n; i++) {
      if (Double.isFinite(data.direction()[i]) && Double.isFinite(data.acceleration()[i])) {
        rows[kept++] = i;
      }
    }
    acceleration = new double[kept];
    error = new double[kept];
    count = new double[kept];
    left = new int[kept];
    part = new double[kept];
    for (int k = 0; k < kept; k++) {
      int i = rows[k];
      acceleration[k] = data.acceleration()[i];
      error[k] = data.error()[i];
      count[k] = data.count()[i];
      double position = data.direction()[i] / Envelope.STEP;
      left[k] = Math.floorMod((int) Math.floor(position), KNOTS);
      part[k] = position - Math.floor(position);
    }
    total = Arrays.stream(count).sum();
  }

  /**
   * Fits an envelope.
   *
   * @param data manoeuvres, with what is known of other effects taken out
   * @param guess the limit by direction as far as it is known otherwise
   * @return null when there is none
   */
  static EnvelopeFit of(ManoeuvreTable.Columns data, DoubleUnaryOperator guess) {
    EnvelopeFit local = new EnvelopeFit(data);
    EnvelopeFit global = new EnvelopeFit(data);
    boolean first = local.climb(local.localStart());
    double[] start = new double[KNOTS];
    Arrays.setAll(start, k -> guess.applyAsDouble(k * Envelope.STEP));
    boolean second = global.climb(start);
    if (first && second) {
      return global.mass > local.mass ? global : local;
    }
    return first ? local : second ? global : null;
  }

  /** Where the manoeuvres about each direction pile up; between directions with too few of them a straight line. Null when there are nowhere enough. */
  private double[] localStart() {
    double[] start = new double[KNOTS];
    Arrays.fill(start, Double.NaN);
    for (int k = 0; k < KNOTS; k++) {
      int knot = k;
      int[] near =
          java.util.stream.IntStream.range(0, left.length)
              .filter(i -> distance(i, knot) <= START_WINDOW)
              .toArray();
      ManoeuvreTable.Columns some =
          new ManoeuvreTable.Columns(
              pick(acceleration, near),
              pick(error, near),
              new double[near.length],
              new double[near.length],
              pick(count, near));
      if (Arrays.stream(some.count()).sum() >= START_FEWEST) {
        SaturationFit.Uniform mode = SaturationFit.uniform(some);
        start[k] = mode == null ? Double.NaN : mode.highest().beta()[0];
      }
    }
    return filled(start);
  }

  private double distance(int i, int knot) {
    return Math.abs(Math.IEEEremainder(left[i] + part[i] - knot, KNOTS));
  }

  private static double[] pick(double[] from, int[] rows) {
    return Arrays.stream(rows).mapToDouble(i -> from[i]).toArray();
  }

  private static double[] filled(double[] start) {
    double[] full = start.clone();
    for (int k = 0; k < KNOTS; k++) {
      if (Double.isNaN(start[k])) {
        int before = 1;
        while (before < KNOTS && Double.isNaN(start[Math.floorMod(k - before, KNOTS)])) {
          before++;
        }
        if (before == KNOTS) {
          return null;
        }
        int after = 1;
        while (Double.isNaN(start[(k + after) % KNOTS])) {
          after++;
        }
        double low = start[Math.floorMod(k - before, KNOTS)];
        double high = start[(k + after) % KNOTS];
        full[k] = (after * low + before * high) / (before + after);
      }
    }
    return full;
  }

  private boolean climb(double[] start) {
    values = start;
    for (double spread : SPREADS) {
      for (int i = 0; i < ITERATIONS && values != null; i++) {
        double[] next = step(spread);
        double change = 0;
        for (int k = 0; k < KNOTS && next != null; k++) {
          change = Math.max(change, Math.abs(next[k] - values[k]) / values[k]);
        }
        values = next;
        if (change < SETTLED) {
          break;
        }
      }
    }
    return values != null && describe();
  }

  private double value(int i) {
    return (1 - part[i]) * values[left[i]] + part[i] * values[(left[i] + 1) % KNOTS];
  }

  private double width2(int i, double value, double spread) {
    double own = ERRORS * error[i];
    return own * own + spread * spread * value * value;
  }

  /** Adds w·B(φᵢ)·B(φᵢ)ᵀ to {@code a}. */
  private void add(double[][] a, int i, double w) {
    int l = left[i];
    int r = (l + 1) % KNOTS;
    double p = part[i];
    a[l][l] += w * (1 - p) * (1 - p);
    a[l][r] += w * p * (1 - p);
    a[r][l] += w * p * (1 - p);
    a[r][r] += w * p * p;
  }

  private double[][] penalty() {
    double level = Arrays.stream(values).average().orElseThrow();
    double weight = 1 / (BEND * BEND * level * level);
    double[][] a = new double[KNOTS][KNOTS];
    int[] sign = {1, -2, 1};
    for (int k = 0; k < KNOTS; k++) {
      for (int i = 0; i < sign.length; i++) {
        for (int j = 0; j < sign.length; j++) {
          a[(k + i) % KNOTS][(k + j) % KNOTS] += weight * sign[i] * sign[j];
        }
      }
    }
    return a;
  }

  private double[] step(double spread) {
    double[][] a = penalty();
    double[] b = new double[KNOTS];
    for (int i = 0; i < count.length; i++) {
      double f = value(i);
      double r = acceleration[i] - f;
      double h2 = width2(i, f, spread);
      double w = count[i] * Math.exp(-0.5 * r * r / h2) / h2;
      add(a, i, w);
      b[left[i]] += w * (1 - part[i]) * acceleration[i];
      b[(left[i] + 1) % KNOTS] += w * part[i] * acceleration[i];
    }
    DecompositionSolver solver = solver(a);
    if (solver == null) {
      return null;
    }
    double[] next = solver.solve(new ArrayRealVector(b, false)).toArray();
    return Arrays.stream(next).allMatch(v -> v > 0) ? next : null;
  }

  private static DecompositionSolver solver(double[][] a) {
    try {
      return new CholeskyDecomposition(new Array2DRowRealMatrix(a, false)).getSolver();
    } catch (NonPositiveDefiniteMatrixException e) {
      return null;
    }
  }

  private boolean describe() {
    double[][] a = penalty();
    double[][] b = new double[KNOTS][KNOTS];
    at = new double[KNOTS];
    about = new double[KNOTS];
    for (int i = 0; i < count.length; i++) {
      double f = value(i);
      double r = acceleration[i] - f;
      double h2 = width2(i, f, SPREAD);
      double kernel = Math.exp(-0.5 * r * r / h2);
      double n = count[i];
      mass += n * kernel;
      at[left[i]] += n * kernel * (1 - part[i]);
      at[(left[i] + 1) % KNOTS] += n * kernel * part[i];
      about[left[i]] += n * (1 - part[i]);
      about[(left[i] + 1) % KNOTS] += n * part[i];
      double w = kernel / h2;
      // Not below zero: a manoeuvre on the flank of the kernel must not make its direction less
      // certain.
      add(a, i, n * w * Math.max(0, 1 - r * r / h2));
      add(b, i, n * w * w * r * r);
    }
    DecompositionSolver solver = solver(a);
    if (solver == null) {
      return false;
    }
    RealMatrix inverse = solver.getInverse();
    RealMatrix covariance =
        inverse.multiply(new Array2DRowRealMatrix(b, false)).multiply(inverse.transpose());
    errors = new double[KNOTS];
    Arrays.setAll(errors, k -> Math.sqrt(Math.max(0, covariance.getEntry(k, k))));
    return true;
  }

  /** How many manoeuvres lie at the envelope. */
  double mass() {
    return mass;
  }

  /** Manoeuvres of known direction. */
  double total() {
    return total;
  }

  /** Share of the manoeuvres of known direction at a limit that is given by direction. */
  double shareAt(DoubleUnaryOperator limit) {
    double sum = 0;
    for (int i = 0; i < count.length; i++) {
      double f = limit.applyAsDouble((left[i] + part[i]) * Envelope.STEP);
      double r = acceleration[i] - f;
      sum += count[i] * Math.exp(-0.5 * r * r / width2(i, f, SPREAD));
    }
    return sum / total;
  }

  /** The directions that are known. */
  List<Envelope.Point> points() {
    List<Envelope.Point> points = new ArrayList<>();
    for (int k = 0; k < KNOTS; k++) {
      double e = Math.hypot(errors[k], SYSTEMATIC * values[k]);
      if (at[k] >= FEWEST && at[k] >= REACHED * about[k] && e <= WORST * values[k]) {
        points.add(new Envelope.Point(k * Envelope.STEP, values[k], e, at[k]));
      }
    }
    return points;
  }
}
