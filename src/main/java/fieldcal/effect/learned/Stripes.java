package fieldcal.effect.learned;

import java.util.Optional;
import org.apache.commons.math3.util.MathArrays;

/**
 * Sum of a spline over x and one over y, for what depends on a place in stripes: an additive model (Hastie and Tibshirani, Generalized Additive Models, 1990). It resolves finer structures than a {@link Surface} with as many coefficients, but not isolated patches.
 *
 * @param x over the first number, centred
 * @param y over the second number, centred
 */
public record Stripes(Spline x, Spline y) implements Basis {
  static final String TYPE = "stripes";

  /**
   * Checks the splines. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one of the splines is not centred
   */
  public Stripes {
    if (!x.centred() || !y.centred()) {
      throw new IllegalArgumentException("splines of stripes must be centred");
    }
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
    return x.size() + y.size();
  }

  @Override
  public double resolution(int axis) {
    return axis == 0 ? x.resolution(0) : y.resolution(0);
  }

  @Override
  public void values(double u, double v, double[] values) {
    x.values(u, 0, values);
    double[] ofY = new double[y.size()];
    y.values(v, 0, ofY);
    System.arraycopy(ofY, 0, values, x.size(), ofY.length);
  }

  @Override
  public Optional<Stripes> finer() {
    return x.finer().flatMap(fx -> y.finer().map(fy -> new Stripes(fx, fy)));
  }

  @Override
  public double[] inFiner(double[] coefficients, int from) {
    return MathArrays.concatenate(
        x.inFiner(coefficients, from), y.inFiner(coefficients, from + x.size()));
  }

  @Override
  public Curve curve(double[] coefficients, int from) {
    Curve ofX = x.curve(coefficients, from);
    Curve ofY = y.curve(coefficients, from + x.size());
    return (u, v) -> ofX.at(u, 0) + ofY.at(v, 0);
  }
}
