package fieldcal.fit;

import java.util.Arrays;

/** Scale of two-dimensional residuals that outliers hardly move. */
final class RobustScale {
  private RobustScale() {}

  /**
   * Standard deviation per component from the median of squared distances: of a two-dimensional Gaussian that median is 2 ln 2
   * variances.
   */
  static double ofSquaredDistances(double[] squared) {
    double[] sorted = squared.clone();
    Arrays.sort(sorted);
    return Math.sqrt(sorted[sorted.length / 2] / (2 * Math.log(2)));
  }
}
