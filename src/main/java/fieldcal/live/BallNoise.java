package fieldcal.live;

import fieldcal.fit.CameraNoise;
import fieldcal.movement.Histogram;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;

/**
 * Noise of one camera's ball, from three detections in a row: how far the middle one lies from the line between the others. A ball that rests, slides or rolls hardly bends its path within 30 ms (a sliding ball by 0.3 mm at
 * 75 Hz, a chip by 0.9 mm), and kicks and bounces hardly change the median. So it is known within seconds, also where no ball rests before a kick. Constant memory.
 */
final class BallNoise {
  /** Longest time between detections in a row, s; in a longer one a detection may be missing: two and a half frames at 75 Hz. */
  private static final double LONGEST_STEP = 0.033;

  /** No ball flies faster, m/s; a detection farther away is another ball. */
  private static final double FASTEST = 10;

  /** With fewer triples the noise is more than 10 % uncertain. */
  private static final int FEWEST = 50;

  /** Of two Gaussian deviations with the variance 1, the sum of squares has the median 2 ln 2. */
  private static final double MEDIAN_OF_SQUARES = 2 * Math.log(2);

  /** Squares are counted in logarithms, in bins of one per cent from (0.01 mm)² on, m². */
  private static final double SMALLEST = 1e-10;

  private final Histogram squares = new Histogram(0.01, 1600);
  private final double[] t = new double[2];
  private final double[] x = new double[2];
  private final double[] y = new double[2];
  private int known;

  /** Takes a frame; only those with one ball count. */
  void accept(VisionFrame frame) {
    if (frame.balls().size() != 1) {
      known = 0;
      return;
    }
    BallDetection ball = frame.balls().get(0);
    double time = frame.captureTime();
    if (known > 0 && !follows(time, ball)) {
      known = 0;
    }
    if (known == 2) {
      count(time, ball);
    }
    t[0] = t[1];
    x[0] = x[1];
    y[0] = y[1];
    t[1] = time;
    x[1] = ball.x();
    y[1] = ball.y();
    known = Math.min(2, known + 1);
  }

  private boolean follows(double time, BallDetection ball) {
    double step = time - t[1];
    double distance = Math.hypot(ball.x() - x[1], ball.y() - y[1]);
    return step > 0 && step < LONGEST_STEP && distance < FASTEST * LONGEST_STEP;
  }

  private void count(double time, BallDetection ball) {
    double share = (t[1] - t[0]) / (time - t[0]);
    double dx = x[1] - x[0] - share * (ball.x() - x[0]);
    double dy = y[1] - y[0] - share * (ball.y() - y[0]);
    double variance = 1 + share * share + (1 - share) * (1 - share);
    double square = (dx * dx + dy * dy) / variance;
    squares.add(Math.log(Math.max(square, SMALLEST) / SMALLEST));
  }

  /** The clock has restarted: the next detection is on the new clock. */
  void restart() {
    known = 0;
  }

  /** Standard deviation of one coordinate, at least {@link CameraNoise#FLOOR}, m; NaN with too few detections. */
  double noise() {
    if (squares.samples() < FEWEST) {
      return Double.NaN;
    }
    double median = SMALLEST * Math.exp(squares.percentile(0.5));
    return Math.max(CameraNoise.FLOOR, Math.sqrt(median / MEDIAN_OF_SQUARES));
  }
}
