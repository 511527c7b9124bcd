package fieldcal.effect;

/**
 * The ball as a body.
 *
 * @param mass mass, kg, positive
 * @param radius radius, m, positive
 * @param inertiaFactor β in I = β·m·r². A force on a rolling ball accelerates it by 1/(1+β) of what it would do to a sliding one, because it must turn
 *     the ball, too. This is the body's own β; a fitted kSwitch, which also absorbs other causes, is deliberately not used for it
 */
public record BallBody(double mass, double radius, double inertiaFactor) {

  /** A golf ball as the league's rules describe it: 46 g, 43 mm in diameter; solid, so β = 2/5. */
  public static final BallBody GOLF_BALL = new BallBody(0.046, 0.0215, 0.4);

  /** Density of air, kg/m³: 20 °C at about 200 m above the sea; the value that the design fixes. */
  public static final double AIR_DENSITY = 1.2;

  /** ½ρπr²/m of a golf ball, 1/m: times a coefficient and the square of the speed it is an acceleration. */
  public static final double AIR_FACTOR =
      0.5 * AIR_DENSITY * Math.PI * GOLF_BALL.radius * GOLF_BALL.radius / GOLF_BALL.mass;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not positive and finite
   */
  public BallBody {
    if (!(mass > 0 && radius > 0 && inertiaFactor > 0)
        || !Double.isFinite(mass + radius + inertiaFactor)) {
      throw new IllegalArgumentException(
          "mass, radius and inertia factor must be positive, but are "
              + mass
              + ", "
              + radius
              + ", "
              + inertiaFactor);
    }
  }

  /**
   * The same ball with another distribution of its mass.
   *
   * @param beta the inertia factor, positive
   * @return the changed ball
   */
  public BallBody withInertiaFactor(double beta) {
    return new BallBody(mass, radius, beta);
  }
}
