package fieldcal.fit;

/**
 * One way to explain a kick: a path with a number of flights, and where its unknowns ended up.
 *
 * @param flights of a chip; 0 of a flat kick
 * @param flight the observations that were looked at
 * @param theta the unknowns there; belongs to this minimum
 * @param cost what is left there, under the loss that it was looked for with
 * @param equations the normal equations there
 */
record Minimum(
    int flights, FlightProblem flight, double[] theta, double cost, NormalEquations equations) {

  /** The cost with the penalty of a number of flights that contradicts the 10 mm rule. */
  double priced() {
    return flights == 0 ? cost : FlightLayout.pricedCost(theta, flights, cost);
  }
}
