package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.decision.Dependence.Form;
import fieldcal.diagnosis.decision.Dependence.Level;
import fieldcal.diagnosis.decision.KickValues.Kick;
import fieldcal.effect.learned.Variable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.special.Beta;

/**
 * Tests whether values that differ from kick to kick follow something that is recorded. If they do, the model lacks a law, and they do not differ by chance.
 *
 * <p>Tried are straight lines, curves of rising order and steps, those over the session's time also beside a straight line over the speed, of the values themselves and of their normal scores, in which a kick that is far off only comes last in the order (van der Waerden 1952). The statistic is the smallest chance of an F-test, times the number of forms of that kind (the minimum-p statistic of Westfall and Young, "Resampling-based multiple testing", 1993). How often chance alone makes it as small is counted by assigning the same values to the kicks in other orders. So the level holds for any distribution of the values, and for any number of forms, even if they overlap.
 */
final class DependenceSearch {
  /** When this many other orders do as well, the chance is above the limit, and no more are drawn (Besag and Clifford 1991): with ten the chance is known to a third of itself. */
  private static final int ENOUGH_ORDERS = 10;

  /** Highest order of a curve over the session's time: six full waves. */
  private static final int TIME_ORDER = 12;

  /** Highest order of a curve over the speed; chosen: friction rises, falls and rises again at most (Stribeck). */
  private static final int SPEED_ORDER = 4;

  /** Orders of a surface over the place, with their numbers of functions: a plane, a quadric, a cubic. */
  private static final int[] PLACE_FUNCTIONS = {2, 5, 9};

  /** The same over the direction: a slope or nap, a preferred axis, the square weave of a carpet. */
  private static final int[] HEADING_FUNCTIONS = {2, 4, 8};

  /** The same of what repeats every quarter turn: a friction box needs no other waves, and few kicks allow no more. */
  private static final int[] QUARTER_FUNCTIONS = {2, 4};

  /** Kicks for each function of a form, at least. */
  private static final int KICKS_PER_FUNCTION = 3;

  /** Kicks that a step needs on each side: two may be wrong for any reason. */
  private static final int FEWEST_ON_A_SIDE = 3;

  /** A column of whose square the others leave no more than this share depends on them. */
  private static final double DEPENDENT = 1e-9;

  /** Rounds of a robust fit: it then moves by less than a per cent. */
  private static final int ROUNDS = 15;

  /** Distance beyond which a robust fit gives less weight, in standard deviations: 95 % efficiency for normal values (Huber 1981). */
  private static final double HUBER = 1.345;

  /** Standard deviation of a normal variable over its median absolute deviation. */
  private static final double MEDIAN_TO_DEVIATION = 1.4826;

  /** Steps of a bisection: a double has 52 binary digits. */
  private static final int BISECTIONS = 60;

  private final double limit;
  private final List<Kick> kicks;
  private final int n;
  private final double[] roots;
  private final double weight;
  private final double[] values;

  /** The values, and their normal scores. */
  private final double[][] kinds;

  private final List<Family> families = new ArrayList<>();

  /** A straight line over the speed, orthogonal to the mean and of length 1. */
  private double[] speedLine = {};

  private DependenceSearch(KickValues all, double limit) {
    this.limit = limit;
    kicks = all.kicks();
    n = kicks.size();
    roots = new double[n];
    values = new double[n];
    double sum = 0;
    double total = 0;
    for (int i = 0; i < n; i++) {
      Kick k = kicks.get(i);
      roots[i] = Math.sqrt(k.reliability());
      // A value is shrunk to the mean by its reliability r; the value that its detections alone
      // give has a variance in proportion to 1/r. Multiplied by the root of r, all have the same
      // variance, and may be assigned to the kicks in any order.
      values[i] = (k.value() - all.mean()) / roots[i];
      sum += values[i] * roots[i];
      total += k.reliability();
    }
    weight = total;
    for (int i = 0; i < n; i++) {
      values[i] -= roots[i] * sum / total;
    }
    kinds = new double[][] {values, scores(values)};
    kinds[1] = centred(kinds[1]);
  }

  /** Normal scores: the values that normally distributed numbers of the same order would have; equal values share the mean of theirs. */
  private static double[] scores(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    NormalDistribution normal = new NormalDistribution(null, 0, 1);
    double[] scores = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      double sum = 0;
      int equal = 0;
      for (int rank = 0; rank < sorted.length; rank++) {
        if (sorted[rank] == values[i]) {
          sum += normal.inverseCumulativeProbability((rank + 1.0) / (sorted.length + 1));
          equal++;
        }
      }
      scores[i] = sum / equal;
    }
    return scores;
  }

  /** Without what one value for all kicks explains. */
  private double[] centred(double[] z) {
    double mean = dot(z, roots) / weight;
    double[] centred = new double[n];
    for (int i = 0; i < n; i++) {
      centred[i] = z[i] - mean * roots[i];
    }
    return centred;
  }

  /**
   * What the values follow.
   *
   * @param values of the kicks
   * @param limit chance of finding something in values that follow nothing
   * @param seed of the orders
   * @return empty when nothing tells the values from chance
   */
  static Optional<Dependence> of(KickValues values, double limit, long seed) {
    return new DependenceSearch(values, limit).test(seed);
  }

  /** Forms over one quantity, each of which has the functions of the one before and more; or all steps. Beside a line over the speed, all functions are orthogonal to it. */
  private final class Family {
    final Variable on;
    final double[][] columns;

    /** The same functions, not orthogonal to the line over the speed: so a step is told, level before and after it. */
    final double[][] plain;

    final int[] sizes;
    final boolean steps;
    final boolean besideSpeed;
    final double[] enough;

    Family(
        Variable on,
        double[][] columns,
        double[][] plain,
        int[] sizes,
        boolean steps,
        boolean besideSpeed) {
      this.on = on;
      this.columns = columns;
      this.plain = plain;
      this.sizes = sizes;
      this.steps = steps;
      this.besideSpeed = besideSpeed;
      enough = new double[sizes.length];
    }

    int count() {
      return steps ? columns.length : sizes.length;
    }

    /** Share of the squares that a form explains. */
    double share(int form, double[] z, double squares) {
      double sum = bySpeed(z);
      for (double[] column : of(columns, form)) {
        double p = dot(column, z);
        sum += p * p;
      }
      return sum / squares;
    }

    /** What the line over the speed explains, if the forms are beside one. */
    double bySpeed(double[] z) {
      double p = besideSpeed ? dot(speedLine, z) : 0;
      return p * p;
    }

    /** The functions of a form without the line over the speed. */
    double[][] of(double[][] all, int form) {
      return steps ? new double[][] {all[form]} : Arrays.copyOf(all, sizes[form]);
    }

    int functions(int form) {
      return (steps ? 1 : sizes[form]) + (besideSpeed ? 1 : 0);
    }

    /** Chance of an F-test, times the forms of the family. */
    double corrected(int form, double share) {
      return count() * chance(share, functions(form));
    }

    /** Remembers which share each size of a form must explain for the same chance. */
    void require(double corrected) {
      for (int i = 0; i < sizes.length; i++) {
        enough[i] = shareOf(corrected / count(), functions(i));
      }
    }

    /** Whether any form explains as much as it was required to. */
    boolean reaches(double[] z, double squares) {
      double speed = bySpeed(z);
      double sum = speed;
      int size = 0;
      for (int c = 0; c < columns.length; c++) {
        double p = dot(columns[c], z);
        sum = (steps ? speed : sum) + p * p;
        boolean whole = steps || c + 1 == sizes[size];
        if (whole && sum >= enough[steps ? 0 : size++] * squares) {
          return true;
        }
      }
      return false;
    }
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /** Chance that noise explains a share of the squares with so many functions (F-test). */
  private double chance(double share, int functions) {
    double left = Math.max(0, Math.min(1, 1 - share));
    return Beta.regularizedBeta(left, 0.5 * (n - functions - 1), 0.5 * functions);
  }

  /** The share that noise explains with a given chance. */
  private double shareOf(double chance, int functions) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < BISECTIONS; i++) {
      double middle = 0.5 * (low + high);
      if (chance(middle, functions) > chance) {
        low = middle;
      } else {
        high = middle;
      }
    }
    // Orders count that are equal except for rounding.
    return low * (1 - DEPENDENT);
  }

  private Optional<Dependence> test(long seed) {
    if (n < 2 * FEWEST_ON_A_SIDE || !(dot(values, values) > 0)) {
      return Optional.empty();
    }
    addFamilies();
    Family best = null;
    int form = -1;
    double least = 1;
    for (Family f : families) {
      for (int i = 0; i < f.count(); i++) {
        for (double[] z : kinds) {
          double corrected = f.corrected(i, f.share(i, z, dot(z, z)));
          if (corrected < least) {
            least = corrected;
            best = f;
            form = i;
          }
        }
      }
    }
    if (best == null || least > limit) {
      // Several families find something by chance more often than one does, so no orders need be
      // counted.
      return Optional.empty();
    }
    double required = least;
    families.forEach(f -> f.require(required));
    double chance = chanceOfOrders(seed);
    return chance <= limit ? Optional.of(describe(best, form, chance)) : Optional.empty();
  }

  /** How often other orders of the values reach as much. */
  private double chanceOfOrders(long seed) {
    Random random = new Random(seed);
    int orders = (int) Math.round(ENOUGH_ORDERS / limit) - 1;
    int[] order = new int[n];
    Arrays.setAll(order, i -> i);
    double[] z = new double[n];
    int reached = 0;
    for (int b = 1; b <= orders; b++) {
      for (int i = n - 1; i > 0; i--) {
        int j = random.nextInt(i + 1);
        int swapped = order[i];
        order[i] = order[j];
        order[j] = swapped;
      }
      boolean any = false;
      for (int k = 0; k < kinds.length && !any; k++) {
        any = reaches(kinds[k], order, z);
      }
      reached += any ? 1 : 0;
      if (reached >= ENOUGH_ORDERS) {
        return (double) reached / b;
      }
    }
    return (reached + 1.0) / (orders + 1);
  }

  /** Whether any form explains as much of the values in another order; uses z. */
  private boolean reaches(double[] values, int[] order, double[] z) {
    double mean = 0;
    for (int i = 0; i < n; i++) {
      z[i] = values[order[i]];
      mean += z[i] * roots[i] / weight;
    }
    double squares = 0;
    for (int i = 0; i < n; i++) {
      z[i] -= mean * roots[i];
      squares += z[i] * z[i];
    }
    for (Family f : families) {
      if (f.reaches(z, squares)) {
        return true;
      }
    }
    return false;
  }

  private void addFamilies() {
    double[] speeds = kicks.stream().mapToDouble(Kick::speed).toArray();
    add(Variable.SPEED, polynomials(speeds, SPEED_ORDER), orders(SPEED_ORDER), false);
    double[][] line = polynomials(speeds, 1);
    boolean speedsDiffer = orthonormal(line, false) == 1;
    speedLine = line[0];
    add(Variable.HEADING, waves(1, 2, 3, 4), HEADING_FUNCTIONS, false);
    add(Variable.HEADING, waves(4, 8), QUARTER_FUNCTIONS, false);
    add(Variable.PLACE, places(), PLACE_FUNCTIONS, false);
    double[] times = kicks.stream().mapToDouble(Kick::time).toArray();
    for (boolean beside : speedsDiffer ? new boolean[] {false, true} : new boolean[1]) {
      add(Variable.SESSION_TIME, polynomials(times, TIME_ORDER), orders(TIME_ORDER), beside);
      addSteps(beside);
    }
  }

  private void addSteps(boolean besideSpeed) {
    double[][] steps = new double[Math.max(0, n - 2 * FEWEST_ON_A_SIDE + 1)][n];
    double[][] plain = new double[steps.length][];
    for (int s = 0; s < steps.length; s++) {
      for (int i = FEWEST_ON_A_SIDE + s; i < n; i++) {
        steps[s][i] = 1;
      }
      plain[s] = steps[s].clone();
      orthonormal(new double[][] {plain[s]}, false);
      orthonormal(new double[][] {steps[s]}, besideSpeed);
    }
    families.add(new Family(Variable.SESSION_TIME, steps, plain, new int[] {1}, true, besideSpeed));
  }

  private static int[] orders(int highest) {
    int[] orders = new int[highest];
    for (int i = 0; i < highest; i++) {
      orders[i] = i + 1;
    }
    return orders;
  }

  private void add(Variable on, double[][] functions, int[] sizes, boolean besideSpeed) {
    double[][] plain = Arrays.stream(functions).map(double[]::clone).toArray(double[][]::new);
    orthonormal(plain, false);
    int determined = orthonormal(functions, besideSpeed);
    int most = Math.min(determined, n / KICKS_PER_FUNCTION - (besideSpeed ? 1 : 0));
    int count = 0;
    while (count < sizes.length && sizes[count] <= most) {
      count++;
    }
    if (count > 0) {
      int[] kept = Arrays.copyOf(sizes, count);
      double[][] columns = Arrays.copyOf(functions, kept[count - 1]);
      families.add(new Family(on, columns, plain, kept, false, besideSpeed));
    }
  }

  /** Legendre's polynomials over the range of the numbers; powers would lose all digits. */
  private static double[][] polynomials(double[] of, int highest) {
    double low = Arrays.stream(of).min().orElse(0);
    double high = Arrays.stream(of).max().orElse(1);
    double[][] columns = new double[highest][of.length];
    for (int i = 0; i < of.length; i++) {
      double u = high > low ? 2 * (of[i] - low) / (high - low) - 1 : 0;
      double before = 1;
      double now = u;
      for (int order = 1; order <= highest; order++) {
        columns[order - 1][i] = now;
        double next = ((2 * order + 1) * u * now - order * before) / (order + 1);
        before = now;
        now = next;
      }
    }
    return columns;
  }

  /** Cosines and sines of multiples of the heading. */
  private double[][] waves(int... waves) {
    double[][] columns = new double[2 * waves.length][n];
    for (int i = 0; i < n; i++) {
      for (int w = 0; w < waves.length; w++) {
        columns[2 * w][i] = Math.cos(waves[w] * kicks.get(i).heading());
        columns[2 * w + 1][i] = Math.sin(waves[w] * kicks.get(i).heading());
      }
    }
    return columns;
  }

  private double[][] places() {
    double[][] x = polynomials(kicks.stream().mapToDouble(Kick::x).toArray(), 3);
    double[][] y = polynomials(kicks.stream().mapToDouble(Kick::y).toArray(), 3);
    return new double[][] {
      x[0],
      y[0],
      x[1],
      product(x[0], y[0]),
      y[1],
      x[2],
      product(x[1], y[0]),
      product(x[0], y[1]),
      y[2]
    };
  }

  private static double[] product(double[] a, double[] b) {
    double[] c = new double[a.length];
    for (int i = 0; i < c.length; i++) {
      c[i] = a[i] * b[i];
    }
    return c;
  }

  /** Makes functions orthonormal: weights them, takes out the mean, the line over the speed if they are beside it, and what the functions before explain, and scales each to length 1 (Gram–Schmidt, twice because of rounding); returns how many are determined. */
  private int orthonormal(double[][] columns, boolean besideSpeed) {
    for (int c = 0; c < columns.length; c++) {
      double[] column = columns[c];
      for (int i = 0; i < n; i++) {
        column[i] *= roots[i];
      }
      double before = dot(column, column);
      for (int twice = 0; twice < 2; twice++) {
        double mean = dot(column, roots) / weight;
        for (int i = 0; i < n; i++) {
          column[i] -= mean * roots[i];
        }
        if (besideSpeed) {
          takeOut(speedLine, column);
        }
        for (int o = 0; o < c; o++) {
          takeOut(columns[o], column);
        }
      }
      double after = dot(column, column);
      if (!(after > DEPENDENT * before)) {
        return c;
      }
      double length = Math.sqrt(after);
      for (int i = 0; i < n; i++) {
        column[i] /= length;
      }
    }
    return columns.length;
  }

  private void takeOut(double[] unit, double[] column) {
    double p = dot(column, unit);
    for (int i = 0; i < n; i++) {
      column[i] -= p * unit[i];
    }
  }

  /** Describes a form; beside a line over the speed, the one of the two that explains more. */
  private Dependence describe(Family family, int form, double chance) {
    double[][] own = family.of(family.plain, form);
    double[][] all = family.besideSpeed ? with(speedLine, own) : own;
    double[] coefficients = coefficients(all);
    double[] whole = sum(all, coefficients);
    double left = 0;
    for (int i = 0; i < n; i++) {
      left += Math.pow(values[i] - coefficients[all.length] * roots[i] - whole[i], 2);
    }
    double squares = dot(values, values);
    double explained = Math.max(0, 1 - left / squares);
    boolean bySpeed =
        family.besideSpeed
            && 2 * family.bySpeed(values) > squares * family.share(form, values, squares);
    double[][] told = bySpeed ? new double[][] {speedLine} : own;
    int first = all.length - own.length;
    double[] factors = bySpeed ? coefficients : Arrays.copyOfRange(coefficients, first, all.length);
    double[] fitted = sum(told, factors);
    int low = 0;
    int high = 0;
    for (int i = 0; i < n; i++) {
      fitted[i] /= roots[i];
      low = fitted[i] < fitted[low] ? i : low;
      high = fitted[i] > fitted[high] ? i : high;
    }
    Variable on = bySpeed ? Variable.SPEED : family.on;
    Level lowest = level(on, low, fitted[low]);
    Level highest = level(on, high, fitted[high]);
    double place = Double.NaN;
    double change = Double.NaN;
    Form kind = Form.CURVE;
    if (family.steps && !bySpeed) {
      int begin = FEWEST_ON_A_SIDE + form;
      kind = Form.STEP;
      place = 0.5 * (kicks.get(begin - 1).time() + kicks.get(begin).time());
      change = fitted[n - 1] - fitted[0];
    } else if (told.length == 1) {
      kind = Form.LINE;
      change = (highest.value() - lowest.value()) / (highest.x() - lowest.x());
    }
    return new Dependence(on, kind, told.length, place, change, lowest, highest, explained, chance);
  }

  private static double[][] with(double[] first, double[][] rest) {
    double[][] all = new double[rest.length + 1][];
    all[0] = first;
    System.arraycopy(rest, 0, all, 1, rest.length);
    return all;
  }

  private double[] sum(double[][] columns, double[] coefficients) {
    double[] sum = new double[n];
    for (int c = 0; c < columns.length; c++) {
      for (int i = 0; i < n; i++) {
        sum[i] += coefficients[c] * columns[c][i];
      }
    }
    return sum;
  }

  /** Coefficients of functions, and last of the constant, fitted with less weight for kicks that are far from the form (Huber 1964), which would bend it. */
  private double[] coefficients(double[][] columns) {
    int m = columns.length;
    double[] weights = new double[n];
    Arrays.fill(weights, 1);
    double[] solved = new double[m + 1];
    for (int round = 0; round < ROUNDS; round++) {
      RealMatrix a = new Array2DRowRealMatrix(n, m + 1);
      RealVector z = new ArrayRealVector(n);
      for (int i = 0; i < n; i++) {
        for (int c = 0; c < m; c++) {
          a.setEntry(i, c, weights[i] * columns[c][i]);
        }
        a.setEntry(i, m, weights[i] * roots[i]);
        z.setEntry(i, weights[i] * values[i]);
      }
      solved = new SingularValueDecomposition(a).getSolver().solve(z).toArray();
      double[] form = sum(columns, solved);
      double[] distances = new double[n];
      for (int i = 0; i < n; i++) {
        distances[i] = Math.abs(values[i] - solved[m] * roots[i] - form[i]);
      }
      double[] sorted = distances.clone();
      Arrays.sort(sorted);
      double scale = HUBER * MEDIAN_TO_DEVIATION * sorted[n / 2];
      for (int i = 0; i < n; i++) {
        weights[i] = distances[i] > scale ? Math.sqrt(scale / distances[i]) : 1;
      }
    }
    return solved;
  }

  private Level level(Variable on, int kick, double value) {
    Kick k = kicks.get(kick);
    return switch (on) {
      case SPEED -> new Level(k.speed(), 0, value);
      case HEADING -> new Level(k.heading(), 0, value);
      case PLACE -> new Level(k.x(), k.y(), value);
      default -> new Level(k.time(), 0, value);
    };
  }
}
