package fieldcal.effect.learned;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Cubic B-splines on equally spaced knots, level at both ends of the range and constant outside: those that reach over an end are folded back, so that
 * they still add up to 1 everywhere.
 *
 * <p>Centred, the functions are {@code Σ_i cos(πji/(K − 1))·B_i} with i = 0 … K − 1 and j = 1 … K − 1: waves of rising frequency without the constant j = 0 (a discrete cosine
 * transform of the knots' values), each with mean 0 over the range, so that a coefficient is about an amplitude. De Boor, A Practical Guide to Splines, 1978, chapter IX.
 *
 * @param from beginning of the range, in the unit of the variable
 * @param to end of the range
 * @param knots number of knots K, the ends included, 3 to 32
 * @param centred whether the constant is left out
 */
public record Spline(double from, double to, int knots, boolean centred) implements Basis {
  static final String TYPE = "spline";

  /** Shortest and longest list of knots; chosen, because fewer make no curve and more are no smooth one. */
  private static final int FEWEST_KNOTS = 3;

  private static final int MOST_KNOTS = 32;

  /** Steps of an integrator per interval between knots; chosen: a path under a term as rough as its knots allow is then right to a twentieth of a millimetre after six seconds (tested). */
  private static final double STEPS_PER_INTERVAL = 2;

  /** The waves of each order at each knot, by the number of knots: a joint fit makes thousands of curves. */
  private static final double[][][] COSINES =
      IntStream.rangeClosed(0, MOST_KNOTS).mapToObj(Spline::cosines).toArray(double[][][]::new);

  /** Six times the four uniform cubic B-splines that are not zero in an interval, by powers of its share. */
  private static final double[][] POWERS = {
    {1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}
  };

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the range is empty or the number of knots out of its range
   */
  public Spline {
    Basis.requireRange("range", from, to);
    if (knots < FEWEST_KNOTS || knots > MOST_KNOTS) {
      throw new IllegalArgumentException(
          "knots: must be within " + FEWEST_KNOTS + " and " + MOST_KNOTS + ", but is " + knots);
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
    return centred ? knots - 1 : knots;
  }

  @Override
  public double resolution(int axis) {
    return (to - from) / (knots - 1) / STEPS_PER_INTERVAL;
  }

  @Override
  public void values(double u, double v, double[] values) {
    double[] hats = new double[knots];
    hats(u, hats);
    for (int j = 0; j < size(); j++) {
      values[j] = centred ? wave(j + 1, hats) : hats[j];
    }
  }

  /** All B-splines at a place. */
  void hats(double u, double[] hats) {
    double p = position(u);
    int i = interval(p);
    double t = p - i;
    for (int k = 0; k < 4; k++) {
      hats[folded(i - 1 + k)] += weight(k, t);
    }
  }

  /** Where the B-spline of a knot is not zero. Splines are constant beyond the ends of the range, so one that is not zero at an end has no bound there. */
  double[] support(int knot) {
    double spacing = (to - from) / (knots - 1);
    double begin = from + (knot - 2) * spacing;
    double end = from + (knot + 2) * spacing;
    return new double[] {
      begin < from ? Double.NEGATIVE_INFINITY : begin, end > to ? Double.POSITIVE_INFINITY : end
    };
  }

  private double wave(int order, double[] hats) {
    double sum = 0;
    for (int i = 0; i < knots; i++) {
      sum += cosine(order, i) * hats[i];
    }
    return sum;
  }

  /** The wave of an order at a knot. */
  double cosine(int order, int knot) {
    return COSINES[knots][order][knot];
  }

  private static double[][] cosines(int knots) {
    double[][] cosines = new double[knots][knots];
    for (int order = 0; order < knots; order++) {
      for (int knot = 0; knot < knots; knot++) {
        cosines[order][knot] = Math.cos(Math.PI * order * knot / (knots - 1));
      }
    }
    return cosines;
  }

  @Override
  public Optional<Spline> finer() {
    int halved = 2 * knots - 1;
    return halved <= MOST_KNOTS
        ? Optional.of(new Spline(from, to, halved, centred))
        : Optional.empty();
  }

  @Override
  public double[] inFiner(double[] coefficients, int from) {
    double[] finer = halved(control(coefficients, from));
    return centred ? Arrays.copyOfRange(amplitudes(finer), 1, finer.length) : finer;
  }

  /**
   * The control values when a knot is inserted in the middle of each interval (Lane and Riesenfeld, A Theoretical Development for the Computer Generation and Display of Piecewise Polynomial Surfaces, 1980).
   *
   * @param control values of the B-splines, one more at each end
   * @return values at the old and new knots in turn
   */
  static double[] halved(double[] control) {
    double[] halved = new double[2 * (control.length - 2) - 1];
    for (int i = 0; i < halved.length; i++) {
      int k = i / 2 + 1;
      halved[i] =
          i % 2 == 0
              ? (control[k - 1] + 6 * control[k] + control[k + 1]) / 8
              : (control[k] + control[k + 1]) / 2;
    }
    return halved;
  }

  /** Amplitudes of the waves whose sums are these values at the knots, the constant first: the inverse of the discrete cosine transform. */
  static double[] amplitudes(double[] values) {
    int last = values.length - 1;
    double[] amplitudes = new double[values.length];
    for (int j = 0; j <= last; j++) {
      double sum = 0;
      for (int i = 0; i <= last; i++) {
        sum += (isEnd(i, last) ? 0.5 : 1) * values[i] * Math.cos(Math.PI * j * i / last);
      }
      amplitudes[j] = (isEnd(j, last) ? 1 : 2) * sum / last;
    }
    return amplitudes;
  }

  private static boolean isEnd(int i, int last) {
    return i == 0 || i == last;
  }

  /** The control values with one more at each end: folding is mirroring them. */
  private double[] control(double[] coefficients, int from) {
    double[] control = new double[knots + 2];
    for (int i = 0; i < knots; i++) {
      double value = centred ? 0 : coefficients[from + i];
      for (int j = 0; centred && j < knots - 1; j++) {
        value += coefficients[from + j] * cosine(j + 1, i);
      }
      control[i + 1] = value;
    }
    control[0] = control[2];
    control[knots + 1] = control[knots - 1];
    return control;
  }

  @Override
  public Curve curve(double[] coefficients, int from) {
    double[] control = control(coefficients, from);
    double[] cubics = cubics(control);
    return (u, v) -> {
      double p = position(u);
      int i = interval(p);
      double t = p - i;
      int n = 4 * i;
      return cubics[n] + t * (cubics[n + 1] + t * (cubics[n + 2] + t * cubics[n + 3]));
    };
  }

  /**
   * The cubic of each interval: the sums are computed once, since an integrator asks many thousand times.
   *
   * @param control values of the B-splines, one more at each end
   * @return four coefficients for each interval, of the powers of its share t
   */
  static double[] cubics(double[] control) {
    double[] cubics = new double[4 * (control.length - 3)];
    for (int i = 0; i < control.length - 3; i++) {
      cubic(control[i], control[i + 1], control[i + 2], control[i + 3], cubics, 4 * i, 1);
    }
    return cubics;
  }

  /**
   * The cubic between the second and the third of four values of successive B-splines: the powers of the share, multiplied out from {@link #POWERS}.
   *
   * @param cubic receives four coefficients, of rising powers
   * @param at index of the first
   * @param stride from one to the next
   */
  static void cubic(double a, double b, double c, double d, double[] cubic, int at, int stride) {
    cubic[at] = (a + 4 * b + c) / 6;
    cubic[at + stride] = (c - a) / 2;
    cubic[at + 2 * stride] = (a - 2 * b + c) / 2;
    cubic[at + 3 * stride] = (d - a) / 6 + (b - c) / 2;
  }

  /** Intervals per unit of the variable. */
  double perUnit() {
    return (knots - 1) / (to - from);
  }

  /** Place in units of knots, 0 to K − 1. */
  double position(double u) {
    double p = (u - from) / (to - from) * (knots - 1);
    return p > 0 ? Math.min(p, knots - 1.0) : 0;
  }

  /** The interval in which a position lies. */
  int interval(double position) {
    return Math.min((int) position, knots - 2);
  }

  private int folded(int i) {
    return i < 0 ? -i : i >= knots ? 2 * (knots - 1) - i : i;
  }

  /** One of the four B-splines that are not zero in an interval, at its share t. */
  private static double weight(int k, double t) {
    double[] p = POWERS[k];
    return (p[0] + t * (p[1] + t * (p[2] + t * p[3]))) / 6;
  }
}
