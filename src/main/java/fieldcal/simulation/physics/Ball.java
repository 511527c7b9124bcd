package fieldcal.simulation.physics;

/**
 * The ball as a body.
 *
 * @param mass kg
 * @param radius m
 * @param inertiaFactor β in I = β·m·r²: 0.4 for a solid sphere, 2/3 for a thin shell; without spin at the kick a ball rolls at 1/(1+β) of its kick speed
 */
public record Ball(double mass, double radius, double inertiaFactor) {

  /** A golf ball as the league's rules describe it: 46 g, 43 mm in diameter, solid. */
  public static final Ball GOLF_BALL = new Ball(0.046, 0.0215, 0.4);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is not positive (or NaN)
   */
  public Ball {
    Check.range("mass", mass, 1e-3, 10);
    Check.range("radius", radius, 1e-3, 1);
    Check.range("inertiaFactor", inertiaFactor, 1e-3, 10);
  }

  /**
   * The same ball with another mass distribution.
   *
   * @param newInertiaFactor β
   * @return the changed ball
   */
  public Ball withInertiaFactor(double newInertiaFactor) {
    return new Ball(mass, radius, newInertiaFactor);
  }
}
