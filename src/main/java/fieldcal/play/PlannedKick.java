package fieldcal.play;

/**
 * A kick that is wanted.
 *
 * @param speed of the ball along its path, m/s
 * @param elevation above the carpet, rad; 0 = flat
 * @param otherLine whether it goes along the plan's second line, with the robots' ends swapped
 */
public record PlannedKick(double speed, double elevation, boolean otherLine) {

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the speed is not in [0.5, 10] m/s or the elevation not in [0, 1.4] rad (or NaN)
   */
  public PlannedKick {
    if (!(speed >= 0.5 && speed <= 10)) {
      throw new IllegalArgumentException("kick speed must lie in [0.5, 10] m/s, but is " + speed);
    }
    if (!(elevation >= 0 && elevation <= 1.4)) {
      throw new IllegalArgumentException("elevation must lie in [0, 1.4] rad, but is " + elevation);
    }
  }

  /**
   * Whether the ball is to fly.
   *
   * @return true for a chip
   */
  public boolean chip() {
    return elevation > 0;
  }
}
