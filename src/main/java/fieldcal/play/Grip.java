package fieldcal.play;

/**
 * How a robot drives so that it keeps the ball at its dribbler. How well a dribbler holds is not known beforehand: each loss makes its robot drive more gently.
 *
 * @param speed fastest, m/s
 * @param acceleration up and down, m/s²
 * @param turn fastest, rad/s
 * @param gentle whether it pushes the ball rather than pulls it, and does not turn with it more than it must
 */
record Grip(double speed, double acceleration, double turn, boolean gentle) {
  /** Part of the usual speed after 0, 1, 2 … losses. */
  private static final double[] SPEEDS = {1, 0.5, 0.3, 0.2};

  /** Accelerations without and after each loss, m/s²: a ball that the foam presses onto the carpet follows the first; the last is the deceleration of a rolling ball. */
  private static final double[] ACCELERATIONS = {1.5, 0.7, 0.4, 0.25};

  /** Rates of turning without and after each loss, rad/s: a ball 0.1 m ahead of the centre then needs 3.6, 0.4, 0.2 and 0.1 m/s² to stay. */
  private static final double[] TURNS = {6, 2, 1.4, 1};

  /**
   * The grip after losses of the ball.
   *
   * @param losses number of all losses
   * @param atSpeed number of losses that show that it was too fast: all of them for a robot that pulls. A ball that is pushed straight ahead follows at any speed, as long as its robot neither brakes nor turns
   *     much; to it only the losses of pushed balls show that
   * @param limits of the play
   */
  static Grip after(int losses, int atSpeed, PlayLimits limits) {
    int i = Math.min(losses, SPEEDS.length - 1);
    double speed = SPEEDS[Math.min(atSpeed, i)] * limits.carrySpeed();
    return new Grip(speed, ACCELERATIONS[i], TURNS[i], losses > 0);
  }
}
