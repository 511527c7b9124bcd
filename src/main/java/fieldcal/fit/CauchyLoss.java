package fieldcal.fit;

/**
 * Sum of Cauchy's loss {@code ρ(s) = k² ln(1 + s/k²)} over squared whitened distances; with an infinite scale plain least squares.
 *
 * <p>The logarithm of a product is the sum of the logarithms, so that one is taken for many observations instead of for each: it
 * would be half of the time of an evaluation.
 */
final class CauchyLoss {
  /** One more factor, at most 1e100 as no ball is 1e48 standard deviations away, does not overflow. */
  private static final double FLUSH = 1e200;

  private double squaredScale;
  private double inverse;
  private double product;
  private double sum;

  /** Begins again. */
  void reset(double scale) {
    squaredScale = scale * scale;
    inverse = 1 / squaredScale;
    product = 1;
    sum = 0;
  }

  /** Adds one observation; returns its weight in iteratively reweighted least squares, the derivative of ρ. */
  double add(double squared) {
    if (inverse == 0) {
      sum += squared;
      return 1;
    }
    double factor = 1 + squared * inverse;
    product *= factor;
    if (product > FLUSH) {
      sum += squaredScale * Math.log(product);
      product = 1;
    }
    return 1 / factor;
  }

  /** What was added up. */
  double sum() {
    return product == 1 ? sum : sum + squaredScale * Math.log(product);
  }
}
