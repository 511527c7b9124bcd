package fieldcal.effect.learned;

import java.util.Arrays;

/**
 * Cosines and sines of a period and its fractions: {@code cos(2πu/P), sin(2πu/P), cos(4πu/P), …}; without a constant.
 *
 * @param order number of harmonics, 1 to 4
 * @param period P, in the unit of the number, positive
 */
public record Harmonics(int order, double period) implements Basis {
  static final String TYPE = "harmonics";
  private static final int HIGHEST_ORDER = 4;

  /** Steps of an integrator per period of the highest harmonic; chosen: Simpson's rule errs by (π/2)⁴/2880 = 0.2 % of the term then. */
  private static final double STEPS_PER_PERIOD = 4;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is out of its range
   */
  public Harmonics {
    if (order < 1 || order > HIGHEST_ORDER) {
      throw new IllegalArgumentException(
          "order: must be within 1 and " + HIGHEST_ORDER + ", but is " + order);
    }
    if (!(period > 0) || Double.isInfinite(period)) {
      throw new IllegalArgumentException("period: must be positive, but is " + period);
    }
  }

  /**
   * Harmonics of an angle in rad.
   *
   * @param order number of harmonics, 1 to 4
   * @return the basis
   */
  public static Harmonics ofAngle(int order) {
    return new Harmonics(order, 2 * Math.PI);
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
    return 2 * order;
  }

  @Override
  public double resolution(int axis) {
    return period / order / STEPS_PER_PERIOD;
  }

  @Override
  public void values(double u, double v, double[] values) {
    for (int k = 1; k <= order; k++) {
      double angle = 2 * Math.PI * k * u / period;
      values[2 * k - 2] = Math.cos(angle);
      values[2 * k - 1] = Math.sin(angle);
    }
  }

  @Override
  public Curve curve(double[] coefficients, int from) {
    double[] k = Arrays.copyOfRange(coefficients, from, from + size());
    double perUnit = 2 * Math.PI / period;
    return (u, v) -> {
      double c = Math.cos(perUnit * u);
      double s = Math.sin(perUnit * u);
      double sum = k[0] * c + k[1] * s;
      double cn = c;
      double sn = s;
      for (int i = 2; i < k.length; i += 2) {
        double next = cn * c - sn * s;
        sn = sn * c + cn * s;
        cn = next;
        sum += k[i] * cn + k[i + 1] * sn;
      }
      return sum;
    };
  }
}
