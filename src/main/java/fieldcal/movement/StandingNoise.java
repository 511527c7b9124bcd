package fieldcal.movement;

/** How detections of one robot that stands still scatter, for one camera: the deviation of each of sixteen from their mean. */
final class StandingNoise {
  private static final int GROUP = 16;

  /** The means of both halves of a standing robot's group agree to within this, m: four standard errors of a mean of eight detections with 3.5 mm of noise. */
  private static final double STANDS = 0.005;

  /** The mean variance of both coordinates has a χ² distribution of 2·(GROUP − 1) degrees of freedom, whose median is this part of its mean (Wilson and Hilferty 1931); of balls at rest the same holds in {@code gamelog}. */
  private static final double MEDIAN_TO_MEAN = Math.pow(1 - 2 / (9.0 * 2 * (GROUP - 1)), 3);

  private final double[] x = new double[GROUP];
  private final double[] y = new double[GROUP];
  private int n;

  void forget() {
    n = 0;
  }

  /** Takes a detection; a full group of a robot that stood is counted, in mm. */
  void add(double px, double py, Grid sink, Histogram squares) {
    x[n] = px;
    y[n] = py;
    if (++n < GROUP) {
      return;
    }
    n = 0;
    double firstX = mean(x, 0, GROUP / 2);
    double firstY = mean(y, 0, GROUP / 2);
    double secondX = mean(x, GROUP / 2, GROUP);
    double secondY = mean(y, GROUP / 2, GROUP);
    if (!(Math.hypot(firstX - secondX, firstY - secondY) < STANDS)) {
      return;
    }
    double meanX = 0.5 * (firstX + secondX);
    double meanY = 0.5 * (firstY + secondY);
    // The mean follows the detections a little.
    double scale = 1000 * Math.sqrt(GROUP / (GROUP - 1.0));
    double sum = 0;
    for (int i = 0; i < GROUP; i++) {
      double dx = scale * (x[i] - meanX);
      double dy = scale * (y[i] - meanY);
      sink.add(dx, dy, 1);
      sum += dx * dx + dy * dy;
    }
    squares.add(sum / (2 * GROUP));
  }

  /** Standard deviation of one coordinate, mm, from the median of what was counted: a few groups of robots that moved do not change it. NaN of none. */
  static double standardDeviation(Histogram squares) {
    return Math.sqrt(squares.percentile(0.5) / MEDIAN_TO_MEAN);
  }

  private static double mean(double[] values, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++) {
      sum += values[i];
    }
    return sum / (to - from);
  }
}
