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
   * Friction across the slip, as a part of the sliding friction without any other law.
   *
   * @param moment where and how the ball moves
   * @return positive pulls to the left of the slip; 0 = no change
   */
  default double slidingAcross(BallMoment moment) {
    return 0;
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
   * What is added to the factor of the rolling deceleration, for parts of one law that do not multiply.
   *
   * @param moment where and how the ball moves
   * @return 0 = no change; where the sum of all is below −1, nothing brakes
   */
  default double rollingChange(BallMoment moment) {
    return 0;
  }

  /**
   * The part of the rolling resistance whose torque also opposes the turning of a ball that still slides.
   *
   * @param moment where and how the ball moves
   * @return 0 = none, 1 = all of it
   */
  default double resistedTurning(BallMoment moment) {
    return 0;
  }

  /**
   * Velocity of the air beside the wind that is the same everywhere, for the drag.
   *
   * @param moment where and how the ball moves
   * @param air x and y, m/s; add to it
   */
  default void flow(BallMoment moment, double[] air) {}

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

  /**
   * Acceleration along the path of a ball on the carpet; of a rolling ball all of it, not a part as of a force. It never drives a rolling ball.
   *
   * @param moment where and how the ball moves
   * @return m/s², positive makes the ball faster
   */
  default double alongPath(BallMoment moment) {
    return 0;
  }

  /**
   * Acceleration across the path of a ball on the carpet.
   *
   * @param moment where and how the ball moves
   * @return m/s², positive turns the path to the left
   */
  default double acrossPath(BallMoment moment) {
    return 0;
  }

  /**
   * What is added to the vertical restitution e_z of an impact.
   *
   * @param moment right before the impact
   * @return 0 = no change
   */
  default double restitutionChange(BallMoment moment) {
    return 0;
  }

  /**
   * What is added to the fraction of the velocity along the carpet that an impact leaves.
   *
   * @param moment right before the impact
   * @return 0 = no change
   */
  default double alongChange(BallMoment moment) {
    return 0;
  }

  /**
   * By how much an impact turns the path.
   *
   * @param moment right before the impact
   * @return rad, positive to the left
   */
  default double turn(BallMoment moment) {
    return 0;
  }
}
