package fieldcal.effect.learned;

import java.util.Optional;

/**
 * A few functions of one or two numbers, of which smooth curves are made as linear combinations. Immutable.
 *
 * <p>A <em>centred</em> basis has no constant part, for quantities whose mean is a parameter of the simple model already.
 */
public sealed interface Basis permits Spline, Surface, Stripes, Harmonics, Polynomial, Levels {

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  String type();

  /**
   * Of how many numbers the functions are.
   *
   * @return 1 or 2
   */
  int dimension();

  /**
   * How many functions there are.
   *
   * @return 1 or more
   */
  int size();

  /**
   * All functions at one place.
   *
   * @param u first number
   * @param v second number; not used when there is one
   * @param values receives {@link #size()} values (–)
   */
  void values(double u, double v, double[] values);

  /**
   * The curve of given coefficients, with everything computed that does not depend on the place.
   *
   * @param coefficients as many as functions from index {@code from} on; copied
   * @param from index of the first
   * @return the linear combination
   */
  Curve curve(double[] coefficients, int from);

  /**
   * The longest piece along an axis over which an integrator may step at once.
   *
   * @param axis 0 or 1
   * @return in the unit of the number, positive; infinite when it does not matter
   */
  double resolution(int axis);

  /**
   * A basis of the same kind with finer detail: knots half as far apart, a higher degree. Every curve of this one is a curve of it, too.
   *
   * @return empty when there is none
   */
  default Optional<? extends Basis> finer() {
    return Optional.empty();
  }

  /**
   * The same curve in the finer basis, which must exist.
   *
   * @param coefficients as many as functions from index {@code from} on
   * @param from index of the first
   * @return as many as the finer basis has functions
   * @throws UnsupportedOperationException of a kind of basis that has no finer ones
   */
  default double[] inFiner(double[] coefficients, int from) {
    throw new UnsupportedOperationException(type() + ": has no finer basis");
  }

  /** A function of one or two numbers. Immutable. */
  @FunctionalInterface
  interface Curve {
    /**
     * Its value.
     *
     * @param u first number
     * @param v second number; not used when there is one
     * @return in the unit of the coefficients
     */
    double at(double u, double v);
  }

  /**
   * Checks a range.
   *
   * @param name for the message
   * @param from begin
   * @param to end
   * @throws IllegalArgumentException when it is empty or not finite
   */
  static void requireRange(String name, double from, double to) {
    if (!(from < to) || Double.isInfinite(from) || Double.isInfinite(to)) {
      throw new IllegalArgumentException(
          name + ": must be [from, to] with from < to, but is [" + from + ", " + to + "]");
    }
  }
}
