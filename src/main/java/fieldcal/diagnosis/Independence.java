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
  private static final double CHANCE = 1e-3;

  /** And it must explain that share of the variance. */
  private static final double SHARE = 0.5;

  /** A kick whose magnitude is nearer to the mean than that, in scatters, does not tell its own: a chip's spin, for instance, hardly shows. */
  private static final double UNTOLD = 0.02;

  private Independence() {}

  /** Whether a kick's own magnitude of a random effect follows from one of the kick's other properties. */
  static boolean isLaw(HypothesisFitter fitter, FittedHypothesis at, Chart chart) {
    int j = at.hypothesis().random().indexOf(chart);
    double mean = at.shared()[at.offset(chart)];
    List<Integer> telling = new ArrayList<>();
    for (int k = 0; k < fitter.kicks.size(); k++) {
      if (Math.abs(magnitude(fitter, at, k, j) - mean) > UNTOLD * at.scatter()[j]) {
        telling.add(k);
      }
    }
    int n = telling.size();
    double[] magnitude = new double[n];
    double[][] speed = new double[n][];
    double[][] direction = new double[n][];
    double[][] when = new double[n][];
    for (int i = 0; i < n; i++) {
      int k = telling.get(i);
      double[] own = at.own().get(k);
      magnitude[i] = magnitude(fitter, at, k, j);
      double v = Math.hypot(own[2], own[3]);
      // What is proportional to speed or to its inverse shows with these two.
      speed[i] = new double[] {v, v * v};
      direction[i] = new double[] {own[2] / v, own[3] / v};
      when[i] = new double[] {fitter.kicks.get(k).kick.time() - fitter.sessionStart};
    }
    List<double[][]> laws = new ArrayList<>(List.of(speed, direction, when));
    return laws.stream().anyMatch(law -> follows(magnitude, law));
  }

  private static double magnitude(HypothesisFitter fitter, FittedHypothesis at, int kick, int j) {
    return at.own().get(kick)[fitter.kicks.get(kick).start.length + j];
  }

  private static boolean follows(double[] y, double[][] x) {
    int n = y.length;
    int p = x[0].length;
    if (n < p + 3) {
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
