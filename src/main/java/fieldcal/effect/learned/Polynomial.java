package fieldcal.effect.learned;

import java.util.Arrays;
import java.util.Optional;

/**
 * Products of Legendre polynomials P_i(u)·P_j(v) with i + j ≤ degree over a rectangle, first by the sum i + j, then by j; constant beyond the rectangle's sides. Centred, without the constant P_0·P_0.
 *
 * @param degree 1 to 5
 * @param fromX beginning of the first number's range
 * @param toX its end
 * @param fromY beginning of the second number's range
 * @param toY its end
 * @param centred whether the constant is left out
 */
public record Polynomial(
    int degree, double fromX, double toX, double fromY, double toY, boolean centred)
    implements Basis {
  static final String TYPE = "polynomial";
  private static final int HIGHEST_DEGREE = 5;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a range is empty or the degree out of its range
   */
  public Polynomial {
    if (degree < 1 || degree > HIGHEST_DEGREE) {
      throw new IllegalArgumentException(
          "degree: must be within 1 and " + HIGHEST_DEGREE + ", but is " + degree);
    }
    Basis.requireRange("range", fromX, toX);
    Basis.requireRange("range_y", fromY, toY);
  }

  @Override
  public String type() {
    return TYPE;
  }

  @Override
  public int dimension() {
    return 2;
  }

  @Override
  public int size() {
    return (degree + 1) * (degree + 2) / 2 - (centred ? 1 : 0);
  }

  @Override
  public double resolution(int axis) {
    // A quarter of the range for a cubic, which is integrated to a hundredth over it.
    return 0.75 / degree * (axis == 0 ? toX - fromX : toY - fromY);
  }

  @Override
  public void values(double u, double v, double[] values) {
    double x = scaled(u, fromX, toX);
    double y = scaled(v, fromY, toY);
    int n = 0;
    for (int sum = lowest(); sum <= degree; sum++) {
      for (int j = 0; j <= sum; j++) {
        values[n++] = legendre(sum - j, x) * legendre(j, y);
      }
    }
  }

  @Override
  public Optional<Polynomial> finer() {
    return degree + 2 <= HIGHEST_DEGREE
        ? Optional.of(new Polynomial(degree + 2, fromX, toX, fromY, toY, centred))
        : Optional.empty();
  }

  @Override
  public double[] inFiner(double[] coefficients, int from) {
    // The functions of higher degree come after these.
    double[] own = Arrays.copyOfRange(coefficients, from, from + size());
    return Arrays.copyOf(own, new Polynomial(degree + 2, fromX, toX, fromY, toY, centred).size());
  }

  @Override
  public Curve curve(double[] coefficients, int from) {
    double[] c = Arrays.copyOfRange(coefficients, from, from + size());
    return (u, v) -> {
      double x = scaled(u, fromX, toX);
      double y = scaled(v, fromY, toY);
      double total = 0;
      int n = 0;
      for (int sum = lowest(); sum <= degree; sum++) {
        for (int j = 0; j <= sum; j++) {
          total += c[n++] * legendre(sum - j, x) * legendre(j, y);
        }
      }
      return total;
    };
  }

  /** The least sum i + j. */
  private int lowest() {
    return centred ? 1 : 0;
  }

  private static double scaled(double u, double from, double to) {
    return Math.max(-1, Math.min(1, (2 * u - from - to) / (to - from)));
  }

  private static double legendre(int order, double x) {
    return switch (order) {
      case 0 -> 1;
      case 1 -> x;
      case 2 -> 1.5 * x * x - 0.5;
      case 3 -> (2.5 * x * x - 1.5) * x;
      case 4 -> (4.375 * x * x - 3.75) * x * x + 0.375;
      default -> ((7.875 * x * x - 8.75) * x * x + 1.875) * x;
    };
  }
}
