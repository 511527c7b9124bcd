package fieldcal.effect.learned;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A learned term with its errors over the range where data lie: points of a curve, or a table of a place. Immutable.
 *
 * <p>The mean over the points is taken out, of values and functions alike: it is a parameter of the simple model or of a named effect, and how well a recording distinguishes the two does not concern the shape of the curve. The mean of levels is not taken out: they are relative to what the model says of the impacts before. The error of a point is {@code √(φᵀCφ)} with the functions' values φ there and the covariance C of the coefficients; errors of neighbouring points go together, for a curve has no more independent numbers than
 * coefficients.
 *
 * @param family what depends on what
 * @param component 0, or 1 for the second component of a quantity that has two (see {@link Quantity})
 * @param points by x, of a table by y and then by x
 */
public record LearnedCurve(LearnedFamily family, int component, List<Point> points) {
  /** A value within this many standard errors may be zero: of values that are zero, 95 % lie within. */
  private static final double ERRORS = 2;

  /** Fewest points of a curve, and rows of a table; chosen, enough for a plot. */
  private static final int POINTS = 33;

  private static final int TABLE = 9;

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there is no such component or no point
   */
  public LearnedCurve {
    points = List.copyOf(points);
    requireComponent(family, component);
    if (points.isEmpty()) {
      throw new IllegalArgumentException(family.key() + ": a curve needs a point");
    }
  }

  private static void requireComponent(LearnedFamily family, int component) {
    if (component < 0 || component >= family.quantity().components()) {
      throw new IllegalArgumentException(family.key() + " has no component " + component);
    }
  }

  /**
   * A point.
   *
   * @param x first number of the basis
   * @param y second number of a place, else 0
   * @param value of the term there, in the quantity's unit
   * @param error its standard error
   */
  public record Point(double x, double y, double value, double error) {}

  /**
   * Where data lie.
   *
   * @param fromX smallest first number
   * @param toX largest first number
   * @param fromY smallest second number; not used when there is one
   * @param toY largest second number
   */
  public record Support(double fromX, double toX, double fromY, double toY) {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when a range is not finite or not in order
     */
    public Support {
      if (!(fromX <= toX && fromY <= toY && Double.isFinite(toX - fromX + toY - fromY))) {
        throw new IllegalArgumentException(
            "support: " + fromX + ", " + toX + ", " + fromY + ", " + toY);
      }
    }

    /**
     * The support of one number.
     *
     * @param from smallest
     * @param to largest
     * @return the support
     * @throws IllegalArgumentException when the range is not finite or not in order
     */
    public static Support of(double from, double to) {
      return new Support(from, to, 0, 0);
    }
  }

  /**
   * The curve of a fitted term.
   *
   * @param term the term
   * @param component 0, or 1 for the second component of a quantity that has two (see {@link Quantity})
   * @param covariance of its coefficients, in their order; NaN where unknown
   * @param support where data lie
   * @return the curve
   * @throws IllegalArgumentException when the covariance has another size than the coefficients or there is no such component
   */
  public static LearnedCurve of(
      LearnedTerm term, int component, double[][] covariance, Support support) {
    Objects.requireNonNull(support, "support");
    LearnedFamily family = term.family();
    requireComponent(family, component);
    if (covariance.length != family.size()) {
      throw new IllegalArgumentException(
          "covariance has " + covariance.length + " rows, but coefficients are " + family.size());
    }
    boolean table = family.basis().dimension() == 2;
    double[] xs = grid(family, support, table);
    double[] ys = table ? spread(support.fromY(), support.toY(), TABLE) : new double[1];
    List<Point> points = new ArrayList<>();
    double[][] functions = new double[xs.length * ys.length][family.basis().size()];
    double mean = 0;
    for (double y : ys) {
      for (double x : xs) {
        double value = term.valueAt(component, x, y);
        family.basis().values(x, y, functions[points.size()]);
        points.add(new Point(x, y, value, 0));
        mean += value / functions.length;
      }
    }
    boolean level = family.basis() instanceof Levels;
    double[] means = level ? new double[family.basis().size()] : means(functions);
    for (int i = 0; i < functions.length; i++) {
      Point p = points.get(i);
      double error = error(component, covariance, functions[i], means);
      points.set(i, new Point(p.x(), p.y(), p.value() - (level ? 0 : mean), error));
    }
    return new LearnedCurve(family, component, points);
  }

  private static double[] means(double[][] functions) {
    double[] means = new double[functions[0].length];
    for (double[] at : functions) {
      for (int j = 0; j < means.length; j++) {
        means[j] += at[j] / functions.length;
      }
    }
    return means;
  }

  private static double[] grid(LearnedFamily family, Support support, boolean table) {
    if (family.basis() instanceof Levels) {
      int from = (int) Math.rint(support.fromX());
      int to = (int) Math.rint(support.toX());
      return spread(from, to, to - from + 1);
    }
    return spread(support.fromX(), support.toX(), table ? TABLE : points(family, support));
  }

  /** Two for each piece that an integrator takes at once, so that a plot shows all that the curve does. */
  private static int points(LearnedFamily family, Support support) {
    double pieces = (support.toX() - support.fromX()) / family.basis().resolution(0);
    return Math.max(POINTS, 1 + (int) Math.rint(2 * pieces));
  }

  private static double[] spread(double from, double to, int count) {
    int n = from == to ? 1 : count;
    double[] values = new double[n];
    for (int i = 0; i < n; i++) {
      values[i] = n == 1 ? from : from + (to - from) * i / (n - 1);
    }
    return values;
  }

  private static double error(
      int component, double[][] covariance, double[] functions, double[] means) {
    int n = functions.length;
    int at = component * n;
    double variance = 0;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        variance +=
            (functions[i] - means[i]) * covariance[at + i][at + j] * (functions[j] - means[j]);
      }
    }
    return Math.sqrt(Math.max(0, variance));
  }

  /**
   * Whether it is a table over a place.
   *
   * @return false of a curve
   */
  public boolean isTable() {
    return family.basis().dimension() == 2;
  }

  /**
   * The point with the smallest value.
   *
   * @return the first of them
   */
  public Point lowest() {
    Point lowest = points.get(0);
    for (Point p : points) {
      lowest = p.value() < lowest.value() ? p : lowest;
    }
    return lowest;
  }

  /**
   * The point with the largest value.
   *
   * @return the first of them
   */
  public Point highest() {
    Point highest = points.get(0);
    for (Point p : points) {
      highest = p.value() > highest.value() ? p : highest;
    }
    return highest;
  }

  /**
   * Where the curve is most certainly below zero. The ends of a curve, which few data reach, often have the largest values and the largest errors, and then show nothing.
   *
   * @return the point whose upper bound, two standard errors above its value, is lowest; empty when none is below zero
   */
  public Optional<Point> certainlyLowest() {
    return points.stream()
        .filter(p -> p.value() + ERRORS * p.error() < 0)
        .min(Comparator.comparingDouble(p -> p.value() + ERRORS * p.error()));
  }

  /**
   * Where the curve is most certainly above zero.
   *
   * @return the point whose lower bound, two standard errors below its value, is highest; empty when none is above zero
   */
  public Optional<Point> certainlyHighest() {
    return points.stream()
        .filter(p -> p.value() - ERRORS * p.error() > 0)
        .max(Comparator.comparingDouble(p -> p.value() - ERRORS * p.error()));
  }
}
