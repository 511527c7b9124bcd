package fieldcal.fit.joint;

/**
 * A magnitude that differs from kick to kick: normally distributed about a mean, which is one of the global parameters, with one scatter for all kicks. The scatter is estimated by maximising the restricted
 * likelihood (Patterson and Thompson 1971; by EM: each kick's squared distance from the mean, the variance that its data leave, and what the mean's own error hides), so that a few kicks do not make it look small.
 *
 * @param mean index of the mean among the global parameters
 * @param scatter standard deviation at which the estimation starts
 * @param smallest scatter that is told from none
 * @param largest scatter that may be answered
 */
public record RandomEffect(int mean, double scatter, double smallest, double largest) {

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when they are not in order
   */
  public RandomEffect {
    if (!(smallest > 0 && smallest <= scatter && scatter <= largest)) {
      throw new IllegalArgumentException(
          "scatter " + scatter + " must lie between " + smallest + " and " + largest);
    }
  }

  /**
   * The same with another start.
   *
   * @param start standard deviation at which the estimation starts
   * @return the changed copy
   */
  public RandomEffect withScatter(double start) {
    return new RandomEffect(mean, start, smallest, largest);
  }
}
