package fieldcal.diagnosis.model;

/**
 * How much a kick counts while a model does not explain it yet. The weights are those of iteratively reweighted least squares (Holland and Welsch 1977) for a loss that is bounded, or grows with the logarithm, the root or the whole of what is left of a kick:
 * the logarithm hardly hears kicks that are far from explained, the last hears little else. None is the best for every recording, since which causes are found first decides where the equations are made linear next.
 */
public enum Weighing {
  /** A bounded loss (Geman and McClure 1987): kicks that are not explained are not heard. Such a fit says which kicks stand out; it would not find what only a few kicks show. */
  EXPLAINED_ONLY(2),
  /** The logarithm: kicks that are nearly explained decide. */
  EXPLAINED_FIRST(1),
  /** The root: between the two. */
  BETWEEN(0.5),
  /** The whole: all kicks alike, as in a final fit. */
  ALIKE(0);

  private final double power;

  Weighing(double power) {
    this.power = power;
  }

  /**
   * Weights of a model's kicks.
   *
   * @param model fitted to the kicks
   * @return for each kick at most 1
   */
  public double[] of(FittedModel model) {
    double[] weights = new double[model.kickCount()];
    for (int k = 0; k < weights.length; k++) {
      weights[k] = Math.pow(Math.max(1, model.reduced(k)), -power);
    }
    return weights;
  }
}
