package fieldcal.ball;

import java.util.OptionalDouble;

/**
 * The path of a ball after one kick: where it is at any time, and the questions an AI asks about it.
 *
 * <p>Field frame and SI units as in {@link BallState}; times are seconds on the caller's clock. Before the kick the ball rests
 * at the place of the kick; at the kick time it already moves; after the rest time it lies where it stopped. All distances are
 * lengths of the path over the ground, beginning at the kick, so they never shrink, even when backspin pulls the ball back; for
 * a path without side spin that does not turn around they are also distances along the straight line. Implementations are
 * immutable and safe for use by many threads.
 */
public interface BallTrajectory {

  /**
   * When the path begins.
   *
   * @return the time of the kick, s; of a path continued from a state, the time of that state
   */
  double kickTime();

  /**
   * When the ball comes to rest.
   *
   * @return the time from which on it lies still, s
   */
  double restTime();

  /**
   * Where the ball is and how fast.
   *
   * @param t time, s; may be infinite
   * @return the state; at an impact the one after it
   * @throws IllegalArgumentException when {@code t} is NaN
   */
  BallState stateAt(double t);

  /**
   * Where the ball is. Does not allocate.
   *
   * @param t time, s; may be infinite
   * @param xyz receives x, y and z, m; at least three elements
   * @throws IllegalArgumentException when {@code t} is NaN
   */
  void positionAt(double t, double[] xyz);

  /**
   * What the ball is doing.
   *
   * @param t time, s; may be infinite
   * @return the phase; where two phases meet, the later one
   * @throws IllegalArgumentException when {@code t} is NaN
   */
  Phase phaseAt(double t);

  /**
   * How far the ball has come.
   *
   * @param t time, s; may be infinite
   * @return length of the path over the ground since the kick, m
   * @throws IllegalArgumentException when {@code t} is NaN
   */
  double distanceAt(double t);

  /**
   * When the ball has covered a distance, in the air or on the carpet.
   *
   * @param distance length of the path over the ground since the kick, m, not negative
   * @return the first such time, s; empty when the ball comes to rest before that
   * @throws IllegalArgumentException when {@code distance} is negative or not finite
   */
  OptionalDouble timeAtDistance(double distance);

  /**
   * How fast the ball is when it has covered a distance.
   *
   * @param distance length of the path over the ground since the kick, m, not negative
   * @return speed over the ground, m/s; empty when the ball comes to rest before that
   * @throws IllegalArgumentException when {@code distance} is negative or not finite
   */
  OptionalDouble speedAtDistance(double distance);

  /**
   * How far the ball comes.
   *
   * @return length of the whole path over the ground, m
   */
  default double restDistance() {
    return distanceAt(restTime());
  }
}
