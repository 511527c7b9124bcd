package fieldcal.simulation.physics;

/**
 * Another ball lies on the field from some time on. A ball that is moving then is not exchanged: the next kick is the first of the other one.
 *
 * @param roll relative change of the rolling deceleration (–)
 * @param slide relative change of the sliding friction (–)
 * @param at session time of the change, s
 */
public record BallChange(double roll, double slide, double at) implements ExtraLaw {
  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a change would leave no friction, or the time is not finite
   */
  public BallChange {
    Check.range("roll", roll, -0.95, 10);
    Check.range("slide", slide, -0.95, 10);
    Check.finite("at", at);
  }

  @Override
  public double slidingFactor(BallMoment moment) {
    return isKickedBefore(moment) ? 1 : 1 + slide;
  }

  @Override
  public double rollingFactor(BallMoment moment) {
    return isKickedBefore(moment) ? 1 : 1 + roll;
  }

  private boolean isKickedBefore(BallMoment moment) {
    return moment.sessionTime() - moment.sinceKick() < at;
  }
}
