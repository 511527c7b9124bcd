package fieldcal.effect;

/**
 * How the ball moves at the instant for which an effect is asked. Field frame, SI units. A working object of the integrator: valid during the
 * call only.
 */
public final class BallMotion {
  double x;
  double y;
  double vx;
  double vy;
  double vz;
  double spinX;
  double spinY;
  double slipX;
  double slipY;
  double sessionTime;
  double airX;
  double airY;
  boolean flying;
  boolean sliding;
  double timeSinceKick;
  double kickX;
  double kickY;
  int hop;

  BallMotion() {}

  /**
   * Position.
   *
   * @return x, m
   */
  public double x() {
    return x;
  }

  /**
   * Position.
   *
   * @return y, m
   */
  public double y() {
    return y;
  }

  /**
   * Velocity.
   *
   * @return along x, m/s
   */
  public double vx() {
    return vx;
  }

  /**
   * Velocity.
   *
   * @return along y, m/s
   */
  public double vy() {
    return vy;
  }

  /**
   * Velocity.
   *
   * @return upwards, m/s
   */
  public double vz() {
    return vz;
  }

  /**
   * Spin as the velocity at which a ball with this spin rolls without slip, r·ω_y.
   *
   * @return along x, m/s
   */
  public double spinX() {
    return spinX;
  }

  /**
   * Spin as the velocity at which a ball with this spin rolls without slip, −r·ω_x.
   *
   * @return along y, m/s
   */
  public double spinY() {
    return spinY;
  }

  /**
   * Velocity of the air.
   *
   * @return along x, m/s
   */
  public double airX() {
    return airX;
  }

  /**
   * Velocity of the air.
   *
   * @return along y, m/s
   */
  public double airY() {
    return airY;
  }

  /**
   * Speed at which the ball's lowest point slips over the carpet.
   *
   * @return |v − s| over the ground, m/s; 0 = rolls
   */
  public double slip() {
    double x = vx - spinX;
    double y = vy - spinY;
    return Math.sqrt(x * x + y * y);
  }

  /**
   * Direction in which the ball's lowest point slips, while it slides on the carpet.
   *
   * @return rad, 0 = along x, counter-clockwise
   */
  public double slipHeading() {
    return Math.atan2(slipY, slipX);
  }

  /**
   * Time since the beginning of the session.
   *
   * @return session time, s
   */
  public double sessionTime() {
    return sessionTime;
  }

  /**
   * Time since the kick.
   *
   * @return s
   */
  public double timeSinceKick() {
    return timeSinceKick;
  }

  /**
   * Straight-line distance over the ground from the place of the kick: how far the ball has come, as kicks are straight.
   *
   * @return m
   */
  public double distanceFromKick() {
    double dx = x - kickX;
    double dy = y - kickY;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /**
   * Which impact this is.
   *
   * @return 1 for the first impact of a chip; on the carpet and in flight the number of impacts so far
   */
  public int hop() {
    return hop;
  }

  /**
   * Whether the ball slides on the carpet.
   *
   * @return false when it rolls or flies
   */
  public boolean isSliding() {
    return sliding;
  }

  /**
   * Whether the ball is in the air.
   *
   * @return false on the carpet
   */
  public boolean isFlying() {
    return flying;
  }

  /**
   * Speed, the vertical part included.
   *
   * @return m/s
   */
  public double speed() {
    return Math.sqrt(vx * vx + vy * vy + vz * vz);
  }

  /**
   * Speed over the ground.
   *
   * @return m/s
   */
  public double groundSpeed() {
    return Math.sqrt(vx * vx + vy * vy);
  }

  /**
   * Spin about the rolling axis in units of rolling spin v/r.
   *
   * @return 1 = rolls, negative = backspin; 0 at standstill
   */
  public double spinFraction() {
    double squared = vx * vx + vy * vy;
    return squared == 0 ? 0 : (spinX * vx + spinY * vy) / squared;
  }
}
