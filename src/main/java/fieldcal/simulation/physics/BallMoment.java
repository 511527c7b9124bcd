package fieldcal.simulation.physics;

/** What an {@link ExtraLaw} may depend on: where the ball is, how it moves, and since when. Reused from step to step: read it, do not keep it. For one thread. */
public final class BallMoment {
  double x;
  double y;
  double vx;
  double vy;
  double vz;
  double slip;
  double slipX;
  double slipY;
  double sessionTime;
  double sinceKick;
  double path;
  double distance;
  int hop;

  BallMoment() {}

  /**
   * Position.
   *
   * @return x in the field frame, m
   */
  public double x() {
    return x;
  }

  /**
   * Position.
   *
   * @return y in the field frame, m
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
   * Velocity; at an impact, the one before it.
   *
   * @return upwards, m/s
   */
  public double vz() {
    return vz;
  }

  /**
   * Horizontal speed.
   *
   * @return m/s
   */
  public double groundSpeed() {
    return Math.hypot(vx, vy);
  }

  /**
   * Direction of travel.
   *
   * @return rad, 0 = along x, counter-clockwise; 0 at standstill
   */
  public double heading() {
    return Math.atan2(vy, vx);
  }

  /**
   * Direction in which the contact point slips.
   *
   * @return rad, 0 = along x, counter-clockwise; 0 when rolling
   */
  public double slipHeading() {
    return Math.atan2(slipY, slipX);
  }

  /**
   * Speed at which the contact point slips.
   *
   * @return m/s, 0 when rolling
   */
  public double slip() {
    return slip;
  }

  /**
   * Session time.
   *
   * @return s
   */
  public double sessionTime() {
    return sessionTime;
  }

  /**
   * Time since the ball was launched last.
   *
   * @return s
   */
  public double sinceKick() {
    return sinceKick;
  }

  /**
   * Way on the carpet since the ball was launched last.
   *
   * @return m
   */
  public double path() {
    return path;
  }

  /**
   * Straight distance over the ground from where the ball was launched last.
   *
   * @return m
   */
  public double distanceFromKick() {
    return distance;
  }

  /**
   * Number of the next impact since the ball was launched last; at an impact, its own number.
   *
   * @return 1 = the first
   */
  public int hop() {
    return hop;
  }
}
