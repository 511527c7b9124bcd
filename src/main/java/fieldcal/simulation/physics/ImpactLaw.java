package fieldcal.simulation.physics;

/**
 * What happens when a flying ball meets the carpet. Upward: v_z' = −e_z·v_z, with e_z·(1 − speedSlope·(|v_z| − 1.5 m/s)), kept between 0 and 0.99. Along the carpet: see {@link Tangential}.
 * A ball whose next hop would stay below {@code minHopHeight} stays on the ground.
 *
 * @param dampingZFirstHop e_z of the first impact after a kick (–)
 * @param dampingZOtherHops e_z of later impacts (–)
 * @param speedSlope s/m, 0 = e_z does not depend on speed
 * @param tangential what happens along the carpet
 * @param spinCoupling the tangential restitution changes by −spinCoupling per unit of spin fraction, (–)
 * @param minHopHeight lowest apex that still counts as a hop, m
 */
public record ImpactLaw(
    double dampingZFirstHop,
    double dampingZOtherHops,
    double speedSlope,
    Tangential tangential,
    double spinCoupling,
    double minHopHeight) {

  /** Speed at which {@code speedSlope} changes nothing, m/s (the value that DESIGN fixes). */
  public static final double REFERENCE_SPEED = 1.5;

  /** A ball that keeps more of its vertical speed would bounce for ever: e_z is at most this (–), also where an effect raises it. */
  static final double LARGEST_DAMPING_Z = 0.99;

  /** Lowest hop of the league's models, m. */
  public static final double LEAGUE_MIN_HOP_HEIGHT = 0.01;

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is out of range
   */
  public ImpactLaw {
    Check.range("dampingZFirstHop", dampingZFirstHop, 0, 0.95);
    Check.range("dampingZOtherHops", dampingZOtherHops, 0, 0.95);
    Check.range("speedSlope", speedSlope, -0.5, 0.5);
    Check.range("spinCoupling", spinCoupling, -2, 2);
    // Below 0.1 mm a hop would be shorter than a few integration steps.
    Check.range("minHopHeight", minHopHeight, 1e-4, 1);
  }

  /** What an impact does to the velocity along the carpet and to the spin. */
  public sealed interface Tangential permits FixedLoss, Contact {}

  /**
   * Ideal: v_xy' = e·v_xy of a ball that was kicked without spin; the lost momentum turns the ball, at most until it rolls; a ball that stays down rolls at once. Spin given with the kick adds a velocity u and a surface velocity w at the contact point, which obey
   * the contact law with the share that gives e_xy1 to a ball without spin: u' = u − (1 − e_xy1)·(u − w) and w' = w + (1 − e_xy1)·(u − w)/β, as far as Coulomb friction of the impact, μ·(1+e_z)·|v_z| with the carpet's μ, allows.
   *
   * @param firstHop e at the first impact after a kick (–)
   * @param otherHops e at later impacts (–)
   */
  public record FixedLoss(double firstHop, double otherHops) implements Tangential {
    /**
     * Checks the ranges. {@inheritDoc}
     *
     * @throws IllegalArgumentException when a value is not in [0, 1.5]
     */
    public FixedLoss {
      Check.range("firstHop", firstHop, 0, 1.5);
      Check.range("otherHops", otherHops, 0, 1.5);
    }
  }

  /**
   * Contact: the slip u of the contact point becomes −e_t·u, as far as Coulomb friction of the impact, μ·(1+e_z)·|v_z|, can do it (Cross, Am. J. Phys. 70, 1093 (2002)).
   *
   * @param restitution e_t (–): −1 without friction, 0 the contact point sticks, 1 a super ball
   * @param friction μ during the impact (–)
   * @param loss share of the velocity along the carpet that is lost in addition (–)
   * @param spinLoss share of the spin that is lost in addition (–)
   * @param rolling rolling resistance of the impact (–): a torque of (1 + β)·rolling times the normal force and the radius that opposes the spin, so that a rolling ball loses rolling·(1 + e_z)·|v_z| of speed and spin
   */
  public record Contact(
      double restitution, double friction, double loss, double spinLoss, double rolling)
      implements Tangential {
    /**
     * An impact without loss of spin and rolling resistance.
     *
     * @param restitution e_t (–)
     * @param friction μ during the impact (–)
     * @param loss share of the velocity along the carpet that is lost in addition (–)
     */
    public Contact(double restitution, double friction, double loss) {
      this(restitution, friction, loss, 0, 0);
    }

    /**
     * Checks the ranges. {@inheritDoc}
     *
     * @throws IllegalArgumentException when a value is out of range
     */
    public Contact {
      Check.range("restitution", restitution, -1, 1);
      Check.range("friction", friction, 0, 5);
      // A fitted loss may be a little below none.
      Check.range("loss", loss, -0.1, 1);
      Check.range("spinLoss", spinLoss, -0.1, 1);
      Check.range("rolling", rolling, -0.05, 1);
    }
  }

  /**
   * The league's law with one e_z.
   *
   * @param dampingXyFirstHop e_xy1 (–)
   * @param dampingXyOtherHops e_xy (–)
   * @param dampingZ e_z (–)
   * @return the law
   */
  public static ImpactLaw fixedLoss(
      double dampingXyFirstHop, double dampingXyOtherHops, double dampingZ) {
    return new ImpactLaw(
        dampingZ,
        dampingZ,
        0,
        new FixedLoss(dampingXyFirstHop, dampingXyOtherHops),
        0,
        LEAGUE_MIN_HOP_HEIGHT);
  }

  /**
   * Lets e_z depend on the speed of the impact.
   *
   * @param slope s/m
   * @return the changed law
   */
  public ImpactLaw withSpeedSlope(double slope) {
    return new ImpactLaw(
        dampingZFirstHop, dampingZOtherHops, slope, tangential, spinCoupling, minHopHeight);
  }

  /**
   * Couples the bounce to the spin.
   *
   * @param coefficient (–)
   * @return the changed law
   */
  public ImpactLaw withSpinCoupling(double coefficient) {
    return new ImpactLaw(
        dampingZFirstHop, dampingZOtherHops, speedSlope, tangential, coefficient, minHopHeight);
  }

  /**
   * Another behaviour along the carpet.
   *
   * @param law what happens along the carpet
   * @return the changed law
   */
  public ImpactLaw withTangential(Tangential law) {
    return new ImpactLaw(
        dampingZFirstHop, dampingZOtherHops, speedSlope, law, spinCoupling, minHopHeight);
  }

  /**
   * Another end of the bouncing.
   *
   * @param height lowest apex that still counts as a hop, m
   * @return the changed law
   */
  public ImpactLaw withMinHopHeight(double height) {
    return new ImpactLaw(
        dampingZFirstHop, dampingZOtherHops, speedSlope, tangential, spinCoupling, height);
  }

  /** e_z of an impact. */
  double dampingZ(boolean first, double impactSpeed) {
    double base = first ? dampingZFirstHop : dampingZOtherHops;
    double scaled = base * (1 - speedSlope * (impactSpeed - REFERENCE_SPEED));
    return limited(scaled);
  }

  /** e_z between 0 and the largest one. */
  static double limited(double dampingZ) {
    return Math.max(0, Math.min(LARGEST_DAMPING_Z, dampingZ));
  }
}
