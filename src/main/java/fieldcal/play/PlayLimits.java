package fieldcal.play;

/**
 * How fast the robots drive and how long the play waits.
 *
 * @param driveSpeed fastest drive, m/s
 * @param carrySpeed fastest drive with the ball at the dribbler, m/s
 * @param creepSpeed speed of the last drive up to the ball, m/s
 * @param braking deceleration to plan with, m/s², positive; less than what the robots can reach
 * @param clearance between our robots and any other, edge to edge, m
 * @param receiverDistance farthest that the receiver stands from the ball, m; infinite = at its end of the line
 * @param settle how long the ball lies still before it is kicked, s: its resting place pins the kick
 * @param flightTimeout longest time for which a kicked ball is left alone, s
 * @param patience longest wait for something to get better (robot gone, no vision, ball out of reach), s
 * @param stall longest time without any kick, waits left out, s
 * @param maxAttempts most failed kicks in a row
 */
public record PlayLimits(
    double driveSpeed,
    double carrySpeed,
    double creepSpeed,
    double braking,
    double clearance,
    double receiverDistance,
    double settle,
    double flightTimeout,
    double patience,
    double stall,
    int maxAttempts) {

  /** Limits that usual robots reach without effort. */
  public static final PlayLimits DEFAULT =
      new PlayLimits(2.5, 1.2, 0.3, 2.0, 0.06, Double.POSITIVE_INFINITY, 0.6, 15, 60, 120, 10);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is not positive or NaN
   */
  public PlayLimits {
    double[] positive = {
      driveSpeed,
      carrySpeed,
      creepSpeed,
      braking,
      clearance,
      receiverDistance,
      settle,
      flightTimeout,
      patience,
      stall,
      maxAttempts
    };
    for (double value : positive) {
      if (!(value > 0)) {
        throw new IllegalArgumentException("a limit of the play must be positive, not " + value);
      }
    }
  }

  /**
   * The same limits with slower or faster driving.
   *
   * @param speed fastest drive, m/s
   * @return the changed limits; carrying is at most that fast
   * @throws IllegalArgumentException when the speed is not positive or NaN
   */
  public PlayLimits withDriveSpeed(double speed) {
    return new PlayLimits(
        speed,
        Math.min(carrySpeed, speed),
        creepSpeed,
        braking,
        clearance,
        receiverDistance,
        settle,
        flightTimeout,
        patience,
        stall,
        maxAttempts);
  }

  /**
   * The same limits with another place of the receiver.
   *
   * @param distance farthest from the ball, m
   * @return the changed limits
   */
  public PlayLimits withReceiverDistance(double distance) {
    return new PlayLimits(
        driveSpeed,
        carrySpeed,
        creepSpeed,
        braking,
        clearance,
        distance,
        settle,
        flightTimeout,
        patience,
        stall,
        maxAttempts);
  }

  /**
   * The same limits with other waits.
   *
   * @param seconds longest wait for something to get better, s
   * @param withoutKick longest time without any kick, s
   * @return the changed limits
   */
  public PlayLimits withPatience(double seconds, double withoutKick) {
    return new PlayLimits(
        driveSpeed,
        carrySpeed,
        creepSpeed,
        braking,
        clearance,
        receiverDistance,
        settle,
        flightTimeout,
        seconds,
        withoutKick,
        maxAttempts);
  }
}
