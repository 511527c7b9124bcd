package fieldcal.fit;

/**
 * By how much the variances of what a kick determines are larger than the noise of its cameras alone makes them.
 *
 * <p>What a model does not explain is alike in detections that follow each other, so it does not average out as noise does, and its part of the mean square says too little. Sums over blocks of ever more detections show it: under white
 * noise their mean square grows as the length of the blocks; where residuals are alike it grows faster, until the blocks are longer than what is alike in them (blocking, Flyvbjerg and Petersen 1989). The factor is the largest such growth,
 * as far as it is certain by one standard error, and at least that of the mean square.
 */
final class VarianceFactor {
  /** So many blocks of two axes show a mean square to 0.3 of it. */
  private static final int FEWEST_BLOCKS = 12;

  private VarianceFactor() {}

  /**
   * The factor of a fit.
   *
   * @param data what was fitted, by time
   * @param rx residuals, m
   * @param ry residuals, m
   * @param used which detections were fitted
   * @param reducedChiSquare of the fit
   * @return at least the reduced chi-square, and at least what the floor of the cameras' noise leaves ({@link CameraNoise#FLOOR}), since no model is right to less
   */
  static double of(
      FlightData data, double[] rx, double[] ry, boolean[] used, double reducedChiSquare) {
    int n = 0;
    double floor = 0;
    double[] r1 = new double[data.size];
    double[] r2 = new double[data.size];
    for (int i = 0; i < data.size; i++) {
      if (used[i]) {
        r1[n] = data.w11[i] * rx[i];
        r2[n++] = data.w21[i] * rx[i] + data.w22[i] * ry[i];
        floor += data.floor[i];
      }
    }
    double factor = Math.max(reducedChiSquare, floor / Math.max(1, n));
    for (int length = 2; n / length >= FEWEST_BLOCKS; length *= 2) {
      int blocks = n / length;
      double squares = 0;
      for (int from = 0; from < blocks * length; from += length) {
        double s1 = 0;
        double s2 = 0;
        for (int i = from; i < from + length; i++) {
          s1 += r1[i];
          s2 += r2[i];
        }
        squares += s1 * s1 + s2 * s2;
      }
      double growth = squares / (2.0 * blocks * length);
      double error = 1 / Math.sqrt(blocks);
      factor = Math.max(factor, growth / (1 + error));
    }
    return factor;
  }
}
