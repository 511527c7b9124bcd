package fieldcal.simulation.physics;

/**
 * The ball as a body.
 *
 * @param mass kg
 * @param radius m
 * @param inertiaFactor β in I = β·m·r²: 0.4 for a solid sphere, 2/3 for a thin shell
 * @param slidingInertiaFactor the factor with which the friction of the carpet turns a sliding ball: β, or another value where the carpet resists or helps the turning; without spin at the kick a ball rolls at 1/(1 + this) of its kick speed
 */
public record Ball(double mass, double radius, double inertiaFactor, double slidingInertiaFactor) {

  /** A golf ball as the league's rules describe it: 46 g, 43 mm in diameter, solid. */
  public static final Ball GOLF_BALL = new Ball(0.046, 0.0215, 0.4, 0.4);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is not positive, implausibly small or large, or NaN
   */
  public Ball {
    Check.range("mass", mass, 1e-3, 10);
    Check.range("radius", radius, 1e-3, 1);
    Check.range("inertiaFactor", inertiaFactor, 1e-3, 10);
    Check.range("slidingInertiaFactor", slidingInertiaFactor, 1e-3, 10);
  }

  /**
   * The same ball with another mass distribution, on a carpet that neither resists nor helps its turning.
   *
   * @param newInertiaFactor β
   * @return the changed ball
   */
  public Ball withInertiaFactor(double newInertiaFactor) {
    return new Ball(mass, radius, newInertiaFactor, newInertiaFactor);
  }

  /**
   * The same ball on a carpet on which it begins to roll earlier or later.
   *
   * @param kSwitch speed at which rolling begins over the kick speed of a ball without spin, 0.1 … 0.99
   * @return the changed ball
   * @throws IllegalArgumentException when it is out of range
   */
  public Ball withKSwitch(double kSwitch) {
    Check.range("kSwitch", kSwitch, 0.1, 0.99);
    return new Ball(mass, radius, inertiaFactor, 1 / kSwitch - 1);
  }

  /**
   * Speed at which rolling begins over the kick speed of a ball without spin.
   *
   * @return 0 … 1
   */
  public double kSwitch() {
    return 1 / (1 + slidingInertiaFactor);
  }
}
