package fieldcal.gamelog;

import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;

/**
 * One camera's noise, from balls that lie still: the median over many short stretches of the scatter within each.
 *
 * <p>A stretch is {@value #BLOCK} detections in a row of the same ball. It counts if the mean of its second half differs from that of its
 * first by no more than noise explains; the noise in that test is taken from successive differences, which slow motion does not touch. The median over the stretches does not depend on the few in which the ball was covered or nudged.
 */
final class RestingBallNoise {
  private static final int BLOCK = 16;
  private static final int HALF_BLOCK = BLOCK / 2;

  /** Two detections farther apart are not of the same resting ball, m: above ten times the worst cameras' noise. */
  private static final double SAME_BALL = 0.03;

  /** A ball that was hidden for longer may have been moved, s. */
  private static final double MAX_PAUSE = 0.3;

  /** How many standard deviations the halves' means may differ; 2 keeps 95 % of the resting stretches per axis. */
  private static final double MAX_DRIFT = 2;

  /** The mean variance of both axes has a χ² distribution of 2·(BLOCK − 1) degrees of freedom, whose median is this part of its mean (Wilson and Hilferty). */
  private static final double MEDIAN_TO_MEAN = Math.pow(1 - 2 / (9.0 * 2 * (BLOCK - 1)), 3);

  private final double[] xs = new double[BLOCK];
  private final double[] ys = new double[BLOCK];
  private final QuantileSketch variances = new QuantileSketch(1e-12, 1e-2);
  private int count;
  private double lastTime;

  void add(VisionFrame frame) {
    if (count > 0 && Math.abs(frame.captureTime() - lastTime) > MAX_PAUSE) {
      count = 0;
    }
    BallDetection ball = count == 0 ? first(frame) : nearest(frame);
    if (ball == null) {
      return;
    }
    xs[count] = ball.x();
    ys[count] = ball.y();
    count++;
    lastTime = frame.captureTime();
    if (count == BLOCK) {
      finish();
      count = 0;
    }
  }

  /** Standard deviation per axis, m; NaN without a stretch. */
  double standardDeviation() {
    return Math.sqrt(variances.quantile(0.5) / MEDIAN_TO_MEAN);
  }

  long blocks() {
    return variances.total();
  }

  private static BallDetection first(VisionFrame frame) {
    return frame.balls().isEmpty() ? null : frame.balls().get(0);
  }

  private BallDetection nearest(VisionFrame frame) {
    BallDetection best = null;
    double bestDistance = SAME_BALL;
    for (BallDetection ball : frame.balls()) {
      double distance = Math.hypot(ball.x() - xs[count - 1], ball.y() - ys[count - 1]);
      if (distance < bestDistance) {
        best = ball;
        bestDistance = distance;
      }
    }
    return best;
  }

  private void finish() {
    if (isStill(xs) && isStill(ys)) {
      variances.add((variance(xs) + variance(ys)) / 2);
    }
  }

  private static boolean isStill(double[] values) {
    double squares = 0;
    for (int i = 1; i < BLOCK; i++) {
      squares += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
    }
    double sigma = Math.sqrt(squares / (2 * (BLOCK - 1)));
    double drift = mean(values, HALF_BLOCK, BLOCK) - mean(values, 0, HALF_BLOCK);
    return Math.abs(drift) <= MAX_DRIFT * sigma * Math.sqrt(2.0 / HALF_BLOCK);
  }

  private static double variance(double[] values) {
    double mean = mean(values, 0, BLOCK);
    double squares = 0;
    for (double value : values) {
      squares += (value - mean) * (value - mean);
    }
    return squares / (BLOCK - 1);
  }

  private static double mean(double[] values, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++) {
      sum += values[i];
    }
    return sum / (to - from);
  }
}
