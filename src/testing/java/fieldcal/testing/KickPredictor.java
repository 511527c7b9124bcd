package fieldcal.testing;

import fieldcal.ball.BallState;

/** Predicts where a kicked ball will be: a team's own code under test. */
@FunctionalInterface
public interface KickPredictor {
  /**
   * Where the ball will be on the ground.
   *
   * @param kicked the ball right after the kick, m and m/s, in vision's field frame; {@code vz} is 0 for flat kicks
   * @param seconds how much later, s
   * @return x and y, m
   */
  double[] after(BallState kicked, double seconds);
}
