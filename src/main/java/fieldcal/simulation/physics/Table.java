package fieldcal.simulation.physics;

import java.util.Arrays;

/**
 * A function of one or two numbers, tabulated: linear between the points, constant beyond them, or repeating. For laws that were measured and have no formula. Immutable.
 */
public final class Table {
  /** Most points of a table; chosen, far above what a curve needs. */
  private static final int MOST_POINTS = 100_000;

  private final double[] xs;
  private final double[] ys;
  private final double[] values;
  private final double period;

  private Table(double[] xs, double[] ys, double[] values, double period) {
    this.xs = ascending("x", xs);
    this.ys = ascending("y", ys);
    this.values = values.clone();
    this.period = period;
    if (values.length != xs.length * ys.length) {
      throw new IllegalArgumentException(
          "a table of "
              + xs.length
              + " × "
              + ys.length
              + " points has "
              + values.length
              + " values");
    }
    for (double value : values) {
      Check.finite("value", value);
    }
    Check.range("period", period, 0, 1e6);
  }

  private static double[] ascending(String name, double[] points) {
    if (points.length == 0 || points.length > MOST_POINTS) {
      throw new IllegalArgumentException(
          name + " needs 1 to " + MOST_POINTS + " points, but has " + points.length);
    }
    for (int i = 0; i < points.length; i++) {
      Check.finite(name, points[i]);
      if (i > 0 && !(points[i] > points[i - 1])) {
        throw new IllegalArgumentException(
            name + " must ascend, but " + points[i] + " follows " + points[i - 1]);
      }
    }
    return points.clone();
  }

  /**
   * A curve.
   *
   * @param x where its points are, ascending
   * @param values at these points
   * @param period after which it repeats, in the unit of x; 0 = it does not
   * @return the table
   * @throws IllegalArgumentException when the points do not ascend, a number is not finite, or the counts differ
   */
  public static Table curve(double[] x, double[] values, double period) {
    return new Table(x, new double[] {0}, values, period);
  }

  /**
   * A surface.
   *
   * @param x grid, ascending
   * @param y grid, ascending
   * @param values row by row: all x of the first y first
   * @return the table
   * @throws IllegalArgumentException when a grid does not ascend, a number is not finite, or the counts differ
   */
  public static Table surface(double[] x, double[] y, double[] values) {
    return new Table(x, y, values, 0);
  }

  /**
   * The grid along x.
   *
   * @return a copy
   */
  public double[] x() {
    return xs.clone();
  }

  /**
   * The grid along y.
   *
   * @return a copy; one point of a curve
   */
  public double[] y() {
    return ys.clone();
  }

  /**
   * The values.
   *
   * @return a copy, row by row
   */
  public double[] values() {
    return values.clone();
  }

  /**
   * After which it repeats.
   *
   * @return 0 = it does not
   */
  public double period() {
    return period;
  }

  /**
   * Whether it depends on two numbers.
   *
   * @return false of a curve
   */
  public boolean isSurface() {
    return ys.length > 1;
  }

  /**
   * Its value.
   *
   * @param x first number
   * @param y second number; not used by a curve
   * @return interpolated
   */
  public double at(double x, double y) {
    double u = period > 0 ? xs[0] + x - xs[0] - period * Math.floor((x - xs[0]) / period) : x;
    int i = below(xs, u);
    double share = share(xs, i, u);
    int j = below(ys, y);
    double lower = row(j, i, share);
    if (ys.length == 1) {
      return lower;
    }
    double up = share(ys, j, y);
    return lower + up * (row(Math.min(j + 1, ys.length - 1), i, share) - lower);
  }

  private double row(int j, int i, double share) {
    int at = j * xs.length + i;
    int next = Math.min(i + 1, xs.length - 1) + j * xs.length;
    return values[at] + share * (values[next] - values[at]);
  }

  private static int below(double[] grid, double at) {
    int found = Arrays.binarySearch(grid, at);
    int index = found >= 0 ? found : -found - 2;
    return Math.max(0, Math.min(grid.length - 1, index));
  }

  private static double share(double[] grid, int i, double at) {
    if (i + 1 >= grid.length) {
      return 0;
    }
    return Math.max(0, Math.min(1, (at - grid[i]) / (grid[i + 1] - grid[i])));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Table t
        && Arrays.equals(xs, t.xs)
        && Arrays.equals(ys, t.ys)
        && Arrays.equals(values, t.values)
        && period == t.period;
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return "table of " + xs.length + " × " + ys.length + " points";
  }
}
