package fieldcal.fit;

import java.util.Locale;

/**
 * How a fit went.
 *
 * @param observations how many detections the kick has
 * @param used how many took part in the last fit
 * @param lackOfFit how many of those the model does not explain, see {@link Screening.Verdict#LACK_OF_FIT}
 * @param rmsMm residual per axis in the ground plane over those, mm
 * @param chiSquare sum of their squared whitened residuals (–), about {@code degreesOfFreedom} where model and noise are right
 * @param degreesOfFreedom twice the used observations minus the free unknowns
 * @param varianceFactor by how much the variances of the estimates are larger than the cameras' noise alone makes them: the reduced chi-square, but no less than {@link CameraNoise#FLOOR} leaves
 * @param robustScale how many times larger than the cameras' noise a typical residual is (–), from the median
 * @param flights number of flights of a chip, 0 for a flat kick
 * @param evaluations how often the objective was evaluated, an evaluation with derivatives counted once
 * @param iterations steps of the last Levenberg–Marquardt run
 * @param stop why that stopped
 * @param seed of the global search
 */
public record FitStatistics(
    int observations,
    int used,
    int lackOfFit,
    double rmsMm,
    double chiSquare,
    int degreesOfFreedom,
    double varianceFactor,
    double robustScale,
    int flights,
    int evaluations,
    int iterations,
    String stop,
    long seed) {

  /** A model explains a kick when its residuals are at most this many times the noise; no other model can then explain it much better. */
  public static final double EXPLAINED_SCALE = 1.5;

  /** When more than this share of the detections is off the path, false ones alone do not explain that: good cameras report less than 1 % of them. */
  private static final double FEW_UNEXPLAINED = 0.03;

  static FitStatistics none(long seed) {
    return new FitStatistics(
        0, 0, 0, Double.NaN, Double.NaN, 0, Double.NaN, Double.NaN, 0, 0, 0, "not fitted", seed);
  }

  /**
   * Reduced chi-square; near 1 when model and noise are right.
   *
   * @return chi-square per degree of freedom
   */
  public double reducedChiSquare() {
    return chiSquare / degreesOfFreedom;
  }

  /**
   * Whether the model explains nearly all that was seen: few detections are far from the path, whether or not they count as outliers.
   *
   * @return true when more than 97 % of the detections are on the path and the residuals, the typical ones and their mean square, are at most 1.5 times the cameras' noise
   */
  public boolean explained() {
    return explained(
        robustScale, reducedChiSquare(), observations - used + lackOfFit, observations);
  }

  /** The same from a typical residual, the reduced chi-square, and how many of all observations are off the path. */
  static boolean explained(double robustScale, double reducedChiSquare, int off, int observations) {
    return robustScale < EXPLAINED_SCALE
        && reducedChiSquare < EXPLAINED_SCALE * EXPLAINED_SCALE
        && off < FEW_UNEXPLAINED * observations;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%.2f mm RMS, %d of %d observations%s, chi²/dof %.2f, %d evaluations, %s after %d steps,"
            + " seed %d",
        rmsMm,
        used,
        observations,
        lackOfFit == 0 ? "" : " (" + lackOfFit + " not explained)",
        reducedChiSquare(),
        evaluations,
        stop,
        iterations,
        seed);
  }
}
