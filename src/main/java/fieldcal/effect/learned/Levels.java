package fieldcal.effect.learned;

import java.util.Arrays;

/**
 * One step for each of several whole numbers, each independent of the others: impacts from the {@code first} on. What lies below has no function and stays as the
 * model says; the last level holds for all numbers above, too.
 *
 * @param first the first number that may differ, 0 or more
 * @param count how many, 1 to 16
 */
public record Levels(int first, int count) implements Basis {
  static final String TYPE = "levels";
  private static final int MOST_LEVELS = 16;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is out of its range
   */
  public Levels {
    if (first < 0) {
      throw new IllegalArgumentException("first: must not be negative, but is " + first);
    }
    if (count < 1 || count > MOST_LEVELS) {
      throw new IllegalArgumentException(
          "count: must be within 1 and " + MOST_LEVELS + ", but is " + count);
    }
  }

  @Override
  public String type() {
    return TYPE;
  }

  @Override
  public int dimension() {
    return 1;
  }

  @Override
  public int size() {
    return count;
  }

  @Override
  public double resolution(int axis) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public void values(double u, double v, double[] values) {
    Arrays.fill(values, 0, count, 0);
    int level = level(u);
    if (level >= 0) {
      values[level] = 1;
    }
  }

  @Override
  public Curve curve(double[] coefficients, int from) {
    double[] c = Arrays.copyOfRange(coefficients, from, from + count);
    return (u, v) -> {
      int level = level(u);
      return level < 0 ? 0 : c[level];
    };
  }

  private int level(double u) {
    return Math.min((int) Math.rint(u) - first, count - 1);
  }
}
