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

  /** More than what logarithm and exponential round. */
  private static final double ROUNDING = 1 + 1e-9;

  private double squaredScale;
  private double inverse;
  private double product;
  private double sum;
  private double limit;

  /** From this product on the sum is above the limit. */
  private double limitingProduct;

  /** Starts a new sum. */
  void reset(double scale) {
    reset(scale, Double.POSITIVE_INFINITY);
  }

  /** Starts a new sum, to find out whether it stays below a limit. */
  void reset(double scale, double limit) {
    squaredScale = scale * scale;
    inverse = 1 / squaredScale;
    product = 1;
    sum = 0;
    this.limit = limit;
    findLimitingProduct();
  }

  private void findLimitingProduct() {
    limitingProduct =
        limit < Double.POSITIVE_INFINITY ? ROUNDING * Math.exp((limit - sum) * inverse) : limit;
  }

  /** Whether the sum is above the limit for certain; never without a limit, nor for plain least squares. */
  boolean isAbove() {
    return product > limitingProduct;
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
      findLimitingProduct();
    }
    return 1 / factor;
  }

  /** The sum so far. */
  double sum() {
    return product == 1 ? sum : sum + squaredScale * Math.log(product);
  }
}
