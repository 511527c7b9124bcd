package fieldcal.live;

import java.util.Comparator;

/**
 * What one kick says of one parameter.
 *
 * @param time when the ball was kicked, Unix time, s: samples of several matches are pooled
 * @param value in the parameter's unit
 * @param standardError of the value, positive
 * @param possiblySpinning whether spin from a dribbler may have changed it, see {@link BallParameter#spinSensitive}
 */
public record BallSample(
    double time, double value, double standardError, boolean possiblySpinning) {
  /** By time; those of one moment by value and error, so that any order of adding gives the same. */
  static final Comparator<BallSample> BY_TIME =
      Comparator.comparingDouble(BallSample::time)
          .thenComparingDouble(BallSample::value)
          .thenComparingDouble(BallSample::standardError);

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite, or the error is not positive
   */
  public BallSample {
    if (!Double.isFinite(time) || !Double.isFinite(value)) {
      throw new IllegalArgumentException("time and value must be finite: " + time + ", " + value);
    }
    if (!(standardError > 0) || Double.isInfinite(standardError)) {
      throw new IllegalArgumentException("standard error must be positive: " + standardError);
    }
  }
}
