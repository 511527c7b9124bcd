package fieldcal.fit.joint;

/**
 * Derivatives of what one kick predicts, by its own parameters and by shared ones, at one point. Their products are made once, so that the equations for residuals nearby cost no more than one product with each column. Immutable.
 */
final class KickColumns {
  private final double[][] own;
  private final double[][] shared;
  private final double weight;
  private final KickBlock products;

  /**
   * @param own one column per own parameter; taken over
   * @param shared one column per shared parameter; taken over
   * @param rows their length
   * @param weight of the kick's residuals
   */
  KickColumns(double[][] own, double[][] shared, int rows, double weight) {
    this.own = own;
    this.shared = shared;
    this.weight = weight;
    products = new KickBlock(own.length, shared.length);
    products.addProducts(own, shared, rows, weight);
  }

  /** The equations for these residuals, observed minus predicted, without what is known of the own parameters. */
  KickBlock equations(double[] residuals) {
    KickBlock block = new KickBlock(products);
    block.addResiduals(own, shared, residuals, weight);
    return block;
  }
}
