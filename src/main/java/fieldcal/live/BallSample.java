package fieldcal.live;

import java.util.Comparator;

/**
 * One parameter as one kick determines it.
 *
 * @param time when the ball was kicked, Unix time, s: samples of several matches are pooled
 * @param value in the parameter's unit
 * @param standardError of the value, in the same unit, positive
 * @param possiblySpinning whether spin from a dribbler may have changed it, see {@link BallParameter#spinSensitive}
 * @param speed mean speed of the ball while it showed the parameter, m/s; NaN where it is not known, or where it is not expected to matter ({@link BallParameter#speedSensitive})
 */
public record BallSample(
    double time, double value, double standardError, boolean possiblySpinning, double speed) {
  /** By time; those of one moment by value and error, so that any order of adding gives the same. */
  static final Comparator<BallSample> BY_TIME =
      Comparator.comparingDouble(BallSample::time)
          .thenComparingDouble(BallSample::value)
          .thenComparingDouble(BallSample::standardError);

  /**
   * A sample of a ball of unknown speed.
   *
   * @param time Unix time, s
   * @param value in the parameter's unit
   * @param standardError of the value, positive
   * @param possiblySpinning whether spin may have changed it
   */
  public BallSample(double time, double value, double standardError, boolean possiblySpinning) {
    this(time, value, standardError, possiblySpinning, Double.NaN);
  }

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite but for an unknown speed, the error is not positive, or the speed negative
   */
  public BallSample {
    if (!Double.isFinite(time) || !Double.isFinite(value)) {
      throw new IllegalArgumentException("time and value must be finite: " + time + ", " + value);
    }
    if (!(standardError > 0) || Double.isInfinite(standardError)) {
      throw new IllegalArgumentException("standard error must be positive: " + standardError);
    }
    if (speed < 0 || Double.isInfinite(speed)) {
      throw new IllegalArgumentException("speed must be finite, 0 or more: " + speed);
    }
  }
}
