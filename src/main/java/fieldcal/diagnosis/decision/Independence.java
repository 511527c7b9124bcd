package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;

/**
 * Whether the values that a random effect has in each kick follow from the kick: from its speed, its direction, its place or its time. Then they are no kicker's doing, which differs by chance, but a law that is missing: a
 * friction that depends on the direction looks like spin.
 */
final class Independence {
  /** Chance of calling independent values a law. */
  private static final double CHANCE = 1e-4;

  /** A regression needs that many kicks more than it has numbers. */
  private static final int SPARE = 4;

  private Independence() {}

  static boolean isLaw(FittedModel model, int component) {
    Component c = model.model().components().get(component);
    int random = model.model().random().indexOf(c);
    int n = model.kickCount();
    double[] values = new double[n];
    double[][] kick = new double[n][];
    double[][] heading = new double[n][];
    for (int k = 0; k < n; k++) {
      double[] own = model.solution().own(k);
      KickRecord record = model.kick(k).record();
      values[k] = own[record.timeIndex() + 1 + random];
      double speed = Math.hypot(own[2], own[3]);
      double angle = Math.atan2(own[3], own[2]);
      double t = own[record.timeIndex()];
      kick[k] = new double[] {speed, own[0], own[1], t};
      heading[k] =
          new double[] {
            Math.cos(angle),
            Math.sin(angle),
            Math.cos(2 * angle),
            Math.sin(2 * angle),
            Math.cos(4 * angle),
            Math.sin(4 * angle)
          };
    }
    return explains(kick, values) || explains(heading, values);
  }

  private static boolean explains(double[][] regressors, double[] values) {
    int n = values.length;
    int p = regressors[0].length;
    if (n < p + 1 + SPARE) {
      return false;
    }
    try {
      OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
      regression.newSampleData(values, regressors);
      double total = regression.calculateTotalSumOfSquares();
      double left = regression.calculateResidualSumOfSquares();
      double f = (total - left) / p / (left / (n - p - 1));
      return f > new FDistribution(null, p, n - p - 1.0).inverseCumulativeProbability(1 - CHANCE);
    } catch (MathIllegalArgumentException e) {
      // Kicks that do not differ in one of these do not determine it.
      return false;
    }
  }
}
