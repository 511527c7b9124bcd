package fieldcal.simulation.physics;

import java.util.Arrays;

/** The state of the simulated ball. Mutable, for one thread. */
public final class BallBody {
  /** Position (m; z is the lowest point's height), velocity (m/s), spin (rad/s). */
  final double[] state = new double[9];

  /** The part of the spin about x and y that a ball launched without spin would not have, rad/s. */
  final double[] givenSpin = new double[2];

  /** What impacts have made of the given spin so far: the part of the velocity that a ball launched without spin would not have, m/s. */
  final double[] gainedVelocity = new double[2];

  private MotionPhase phase = MotionPhase.RESTING;
  private int impacts;
  private double launchTime = Double.NaN;
  private double launchX;
  private double launchY;
  private double path;

  /** A ball at rest at the field's centre. */
  public BallBody() {}

  /**
   * Lays the ball down at rest.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   */
  public void place(double x, double y) {
    Check.finite("x", x);
    Check.finite("y", y);
    Arrays.fill(state, 0);
    state[0] = x;
    state[1] = y;
    Arrays.fill(givenSpin, 0);
    phase = MotionPhase.RESTING;
    begin();
  }

  private void begin() {
    Arrays.fill(gainedVelocity, 0);
    impacts = 0;
    launchTime = Double.NaN;
    launchX = state[0];
    launchY = state[1];
    path = 0;
  }

  /**
   * Gives the ball a new velocity and spin where it is, as a kick or a collision does.
   *
   * @param vx velocity along x, m/s
   * @param vy velocity along y, m/s
   * @param vz m/s, above 0 the ball flies
   * @param spinX angular velocity about x, rad/s
   * @param spinY angular velocity about y, rad/s
   * @param spinZ angular velocity about z, rad/s
   */
  public void launch(double vx, double vy, double vz, double spinX, double spinY, double spinZ) {
    double[] values = {vx, vy, vz, spinX, spinY, spinZ};
    for (int i = 0; i < values.length; i++) {
      Check.finite("velocity or spin", values[i]);
      state[3 + i] = values[i];
    }
    givenSpin[0] = spinX;
    givenSpin[1] = spinY;
    begin();
    if (vz > 0 || state[2] > 0) {
      phase = MotionPhase.FLYING;
    } else {
      state[5] = 0;
      phase = MotionPhase.SLIDING;
    }
  }

  /**
   * Kicks the ball with a spin given in units of rolling spin v/r, v = horizontal speed.
   *
   * @param vx velocity along x, m/s
   * @param vy velocity along y, m/s
   * @param vz velocity upwards, m/s
   * @param rollFraction spin about the rolling axis: 1 rolls, negative is backspin
   * @param sideFraction spin about the direction of travel
   * @param radius of the ball, m
   */
  public void kick(
      double vx, double vy, double vz, double rollFraction, double sideFraction, double radius) {
    launch(
        vx,
        vy,
        vz,
        (-vy * rollFraction + vx * sideFraction) / radius,
        (vx * rollFraction + vy * sideFraction) / radius,
        0);
  }

  /**
   * Position.
   *
   * @return x in the field frame, m
   */
  public double x() {
    return state[0];
  }

  /**
   * Position.
   *
   * @return y in the field frame, m
   */
  public double y() {
    return state[1];
  }

  /**
   * Height of the lowest point above the carpet.
   *
   * @return m
   */
  public double z() {
    return state[2];
  }

  /**
   * Velocity.
   *
   * @return along x, m/s
   */
  public double vx() {
    return state[3];
  }

  /**
   * Velocity.
   *
   * @return along y, m/s
   */
  public double vy() {
    return state[4];
  }

  /**
   * Velocity.
   *
   * @return upwards, m/s
   */
  public double vz() {
    return state[5];
  }

  /**
   * Spin about x.
   *
   * @return rad/s
   */
  public double spinX() {
    return state[6];
  }

  /**
   * Spin about y.
   *
   * @return rad/s
   */
  public double spinY() {
    return state[7];
  }

  /**
   * Spin about z.
   *
   * @return rad/s
   */
  public double spinZ() {
    return state[8];
  }

  /**
   * Horizontal speed.
   *
   * @return m/s
   */
  public double groundSpeed() {
    return Math.hypot(state[3], state[4]);
  }

  /**
   * How it moves.
   *
   * @return the phase
   */
  public MotionPhase phase() {
    return phase;
  }

  /**
   * Impacts on the carpet since the last launch.
   *
   * @return the count
   */
  public int impacts() {
    return impacts;
  }

  /** Session time of the launch, s; the first time asked for is it. */
  double launchTime(double now) {
    if (Double.isNaN(launchTime)) {
      launchTime = now;
    }
    return launchTime;
  }

  /** Where it was launched, x in the field frame, m. */
  double launchX() {
    return launchX;
  }

  /** Where it was launched, y in the field frame, m. */
  double launchY() {
    return launchY;
  }

  /** Way on the carpet since the launch, m. */
  double path() {
    return path;
  }

  void addPath(double way) {
    path += way;
  }

  void setPhase(MotionPhase next) {
    phase = next;
  }

  void countImpact() {
    impacts++;
  }
}
