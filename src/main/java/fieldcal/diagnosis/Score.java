package fieldcal.diagnosis;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * What a score test says of an effect: by how much chi-square would fall, where its coordinates would be, and what that is worth as evidence, all in the linear approximation.
 *
 * @param chart the effect
 * @param perKick whether its magnitude differs from kick to kick
 * @param gain decrease of chi-square
 * @param evidence logarithm of the Bayes factor
 * @param coordinates estimate, in the chart's coordinates
 * @param scatter estimate of the scatter from kick to kick
 */
record Score(
    Chart chart,
    boolean perKick,
    double gain,
    double evidence,
    double[] coordinates,
    double scatter) {

  /** Information below this, per squared scale, is none. */
  private static final double NOTHING = 1e-6;

  static Score of(Chart chart, RealMatrix information, RealVector score) {
    int m = chart.size();
    RealMatrix prior = new Array2DRowRealMatrix(m, m);
    double logPrior = 0;
    for (int j = 0; j < m; j++) {
      double e = chart.scale(j) / chart.expected(j);
      prior.setEntry(j, j, e * e);
      logPrior += 2 * Math.log(e);
    }
    double trace = information.getTrace();
    if (!(trace > NOTHING)) {
      return new Score(chart, false, 0, Double.NEGATIVE_INFINITY, new double[m], 0);
    }
    RealMatrix a = information.add(prior);
    CholeskyDecomposition factor = new CholeskyDecomposition(symmetric(a), 1e-6, 0);
    RealVector estimate = factor.getSolver().solve(score);
    double gain =
        2 * estimate.dotProduct(score) - estimate.dotProduct(information.operate(estimate));
    double logDeterminant = 0;
    for (int j = 0; j < m; j++) {
      logDeterminant += 2 * Math.log(factor.getL().getEntry(j, j));
    }
    double evidence = 0.5 * estimate.dotProduct(score) - 0.5 * (logDeterminant - logPrior);
    double[] coordinates = estimate.toArray();
    for (int j = 0; j < m; j++) {
      coordinates[j] *= chart.scale(j);
    }
    return new Score(chart, false, gain, evidence, coordinates, 0);
  }

  static RealMatrix symmetric(RealMatrix m) {
    return m.add(m.transpose()).scalarMultiply(0.5);
  }

  /** Each kick's magnitude is Gaussian about zero with a scatter that is chosen for the largest evidence. */
  static Score ofRandom(Chart chart, double[] information, double[] score) {
    double best = 0;
    double bestScatter = 0;
    double bestGain = 0;
    for (double scatter = 0.02; scatter < 20; scatter *= 1.25) {
      double evidence = 0;
      double gain = 0;
      for (int k = 0; k < score.length; k++) {
        double precision = information[k] + 1 / (scatter * scatter);
        double pull = score[k] * score[k] / precision;
        evidence += 0.5 * pull - 0.5 * Math.log(1 + scatter * scatter * information[k]);
        gain += pull;
      }
      if (evidence > best) {
        best = evidence;
        bestScatter = scatter;
        bestGain = gain;
      }
    }
    return new Score(
        chart, true, bestGain, best, new double[1], Math.max(0.02, bestScatter) * chart.scale(0));
  }
}
