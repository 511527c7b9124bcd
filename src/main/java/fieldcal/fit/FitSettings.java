package fieldcal.fit;

/**
 * How a kick is fitted.
 *
 * @param seed of the random search; the same seed and data give the same fit
 * @param searchEvaluations how often CMA-ES may evaluate a kick's objective, at least 50
 * @param searchObservations how many observations CMA-ES uses, at least 20: it only has to come near the right minimum
 * @param outlierDistance an observation that is more robust standard deviations away in the plane is left out of the last fit, at least 3 (–)
 * @param lossScale scale of Cauchy's loss before that, in standard deviations, positive
 */
public record FitSettings(
    long seed,
    int searchEvaluations,
    int searchObservations,
    double outlierDistance,
    double lossScale) {

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is out of its range or NaN
   */
  public FitSettings {
    if (searchEvaluations < 50 || searchObservations < 20) {
      throw new IllegalArgumentException(
          "search needs at least 50 evaluations of 20 observations, not "
              + searchEvaluations
              + " of "
              + searchObservations);
    }
    if (!(outlierDistance >= 3) || !(lossScale > 0)) {
      throw new IllegalArgumentException(
          "outlierDistance "
              + outlierDistance
              + " (at least 3), lossScale "
              + lossScale
              + " (positive)");
    }
  }

  /**
   * Settings measured to reach the Cramér–Rao bound: a Gaussian observation has a chance of 4·10⁻⁵ to be 4.5 standard deviations
   * away in the plane, so that leaving those out costs nothing; 2.4 is the scale at which Cauchy's loss has 95 % efficiency.
   *
   * @return the defaults
   */
  public static FitSettings defaults() {
    return new FitSettings(20260101L, 350, 72, 4.5, 2.4);
  }

  /**
   * The same with another seed, for fits that differ in their random search only.
   *
   * @param newSeed any number
   * @return the changed copy
   */
  public FitSettings withSeed(long newSeed) {
    return new FitSettings(
        newSeed, searchEvaluations, searchObservations, outlierDistance, lossScale);
  }
}
