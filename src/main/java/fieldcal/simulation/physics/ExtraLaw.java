package fieldcal.simulation.physics;

/** Something that changes the ball's laws beside {@link GroundLaw}, {@link ImpactLaw} and {@link AirLaw}. Implementations are immutable and must be smooth over 1 cm and 1 ms, which the integrator steps over. */
public interface ExtraLaw {

  /**
   * What sliding friction is multiplied by.
   *
   * @param moment where and how the ball moves
   * @return 1 = no change; negative values count as 0
   */
  default double slidingFactor(BallMoment moment) {
    return 1;
  }

  /**
   * What rolling deceleration is multiplied by.
   *
   * @param moment where and how the ball moves
   * @return 1 = no change; negative values count as 0
   */
  default double rollingFactor(BallMoment moment) {
    return 1;
  }

  /**
   * What the vertical restitution e_z of an impact is multiplied by.
   *
   * @param moment right before the impact
   * @return 1 = no change
   */
  default double restitutionFactor(BallMoment moment) {
    return 1;
  }

  /**
   * What the velocity along the carpet is multiplied by after an impact, beside the impact's own law.
   *
   * @param moment right before the impact
   * @return 1 = no change
   */
  default double alongFactor(BallMoment moment) {
    return 1;
  }

  /**
   * A horizontal force per mass, on the ground (where a rolling ball takes 1/(1+β) of it) and in flight.
   *
   * @param moment where and how the ball moves
   * @param acceleration x and y, m/s²; add to it
   */
  default void push(BallMoment moment, double[] acceleration) {}
}
