package fieldcal.diagnosis;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;

/**
 * Whether what differs from kick to kick does so by chance, as a kicker's luck does. If it follows from how fast, where to or when the ball was kicked, it is another cause that only looks like spin.
 */
final class Independence {
  /** Chance of calling luck a law. */
  private static final double CHANCE = 1e-4;

  /** And it must explain that share of the variance. */
  private static final double SHARE = 0.5;

  private Independence() {}

  /** Whether a kick's own magnitude of a random effect follows from one of the kick's other properties. */
  static boolean isLaw(HypothesisFitter fitter, FittedHypothesis at, Chart chart) {
    int j = at.hypothesis().random().indexOf(chart);
    int n = fitter.kicks.size();
    double[] magnitude = new double[n];
    double[][] speed = new double[n][];
    double[][] direction = new double[n][];
    double[][] when = new double[n][];
    for (int k = 0; k < n; k++) {
      double[] own = at.own().get(k);
      KickData data = fitter.kicks.get(k);
      magnitude[k] = own[data.start.length + j];
      double v = Math.hypot(own[2], own[3]);
      // What is proportional to speed or to its inverse shows with these two.
      speed[k] = new double[] {v, v * v};
      direction[k] = new double[] {own[2] / v, own[3] / v};
      when[k] = new double[] {data.kick.time() - fitter.sessionStart};
    }
    List<double[][]> laws = new ArrayList<>(List.of(speed, direction, when));
    return laws.stream().anyMatch(law -> follows(magnitude, law));
  }

  private static boolean follows(double[] y, double[][] x) {
    int n = y.length;
    int p = x[0].length;
    if (n < p + 4) {
      return false;
    }
    OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
    regression.newSampleData(y, x);
    double share;
    try {
      share = regression.calculateRSquared();
    } catch (org.apache.commons.math3.linear.SingularMatrixException allAlike) {
      return false;
    }
    double f = share / p / ((1 - share) / (n - p - 1));
    return share > SHARE
        && 1 - new FDistribution(null, p, n - p - 1).cumulativeProbability(f) < CHANCE;
  }
}
