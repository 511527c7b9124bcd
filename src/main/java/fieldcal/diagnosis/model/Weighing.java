package fieldcal.diagnosis.model;

/**
 * How much a kick counts while a model does not explain it yet. The weights are those of iteratively reweighted least squares (Holland and Welsch 1977) for a loss that is bounded, or grows with the logarithm, the root, or the first power of a kick's reduced chi-square.
 * With the logarithm, kicks that are far from explained hardly count; with the first power, they dominate. None is the best for every recording, since the causes that are found first decide where the equations are linearized next.
 */
public enum Weighing {
  /** A bounded loss (Geman and McClure 1987): kicks that are not explained hardly count. Such a fit shows which kicks stand out; it would not find what only a few kicks show. */
  EXPLAINED_ONLY(2),
  /** The logarithm: kicks that are nearly explained decide. */
  EXPLAINED_FIRST(1),
  /** The root: between the two. */
  BETWEEN(0.5),
  /** The first power: equal weights, as in a final fit. */
  ALIKE(0);

  private final double power;

  Weighing(double power) {
    this.power = power;
  }

  /**
   * Weights of a model's kicks.
   *
   * @param model fitted to the kicks
   * @return one weight for each kick, above 0 and at most 1
   */
  public double[] of(FittedModel model) {
    double[] weights = new double[model.kickCount()];
    for (int k = 0; k < weights.length; k++) {
      weights[k] = Math.pow(Math.max(1, model.reduced(k)), -power);
    }
    return weights;
  }
}
