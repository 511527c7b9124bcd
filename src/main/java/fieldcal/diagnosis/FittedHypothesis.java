package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import java.util.List;

/**
 * A hypothesis whose unknowns were fitted to all kicks.
 *
 * @param hypothesis what acts
 * @param shared values of the shared unknowns
 * @param own each kick's own values
 * @param flights each kick's number of flights
 * @param scatter of each random effect
 * @param chiSquare sum of squared whitened residuals
 * @param cost chi-square with what is known beforehand
 * @param residuals how many residuals there are, two per observation
 * @param logEvidence logarithm of the marginal likelihood (Laplace's approximation), up to a constant that depends on the kicks only
 * @param covariance of the shared unknowns; zero for those that are held
 * @param converged whether the last step was too small to matter
 */
record FittedHypothesis(
    Hypothesis hypothesis,
    double[] shared,
    List<double[]> own,
    int[] flights,
    double[] scatter,
    double chiSquare,
    double cost,
    int residuals,
    double logEvidence,
    double[][] covariance,
    boolean converged) {

  /** Where the coordinates of a chart begin among the shared unknowns. */
  int offset(Chart chart) {
    int k = SharedUnknowns.MODEL;
    for (Chart c : hypothesis.charts()) {
      if (c == chart) {
        return k;
      }
      k += c.size();
    }
    throw new IllegalArgumentException(chart + " is no part of " + hypothesis);
  }

  Effect effect(Chart chart) {
    return chart.effect(shared, offset(chart));
  }

  /** Scatter from kick to kick, 0 for an effect that is the same for all. */
  double scatter(Chart chart) {
    int j = hypothesis.random().indexOf(chart);
    return j < 0 ? 0 : scatter[j];
  }
}
