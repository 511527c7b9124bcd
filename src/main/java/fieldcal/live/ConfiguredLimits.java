package fieldcal.live;

/**
 * What the robots of a team are configured to do, to be compared with what they do.
 *
 * @param velocity highest speed, m/s; NaN when it is not to be compared
 * @param acceleration strongest speeding up, m/s², positive; NaN when it is not to be compared
 * @param braking strongest slowing down, m/s², positive; NaN when it is not to be compared
 */
public record ConfiguredLimits(double velocity, double acceleration, double braking) {

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one that is known is not positive and finite
   */
  public ConfiguredLimits {
    for (double v : new double[] {velocity, acceleration, braking}) {
      if (v <= 0 || Double.isInfinite(v)) {
        throw new IllegalArgumentException("a limit must be positive and finite, but is " + v);
      }
    }
  }
}
