package fieldcal.ball;

/**
 * Where a ball is and how fast it moves, at one instant, in the field frame (origin at the centre, x to the goal, y left, z up).
 *
 * @param x position, m
 * @param y position, m
 * @param z height of the ball's lowest point above the carpet, m; 0 when it lies or rolls
 * @param vx velocity, m/s
 * @param vy velocity, m/s
 * @param vz velocity, m/s
 */
public record BallState(double x, double y, double z, double vx, double vy, double vz) {

  /**
   * Speed over the ground.
   *
   * @return the length of the horizontal velocity, m/s
   */
  public double groundSpeed() {
    return Math.hypot(vx, vy);
  }
}
