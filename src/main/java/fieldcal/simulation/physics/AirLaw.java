package fieldcal.simulation.physics;

/**
 * What the air does. Drag a = −½ρ·c_d·πr²·|v|·v/m, v relative to the air, and, of a spinning ball, lift a = ½ρ·πr³·c_l·(ω×v)/m, that is a lift coefficient of c_l·r|ω|/|v|.
 *
 * @param dragCoefficient c_d (–), 0 = no drag; a golf ball at SSL speeds has about 0.45
 * @param liftCoefficient c_l (–), 0 = no Magnus force
 * @param density ρ, kg/m³
 * @param spinDecay relative loss of spin in flight, 1/s
 * @param windX velocity of the air, on which drag depends, m/s
 * @param windY velocity of the air, m/s
 */
public record AirLaw(
    double dragCoefficient,
    double liftCoefficient,
    double density,
    double spinDecay,
    double windX,
    double windY) {

  /** Density of air at 20 °C and about 200 m above the sea, kg/m³ (the value that DESIGN fixes). */
  public static final double STANDARD_DENSITY = 1.2;

  /** No air. */
  public static final AirLaw NONE = new AirLaw(0, 0, STANDARD_DENSITY, 0);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is out of any physical range
   */
  public AirLaw {
    Check.range("dragCoefficient", dragCoefficient, -5, 5);
    Check.range("liftCoefficient", liftCoefficient, -5, 5);
    Check.range("density", density, 0, 10);
    Check.range("spinDecay", spinDecay, 0, 100);
    Check.range("windX", windX, -50, 50);
    Check.range("windY", windY, -50, 50);
  }

  /**
   * Air that stands still.
   *
   * @param dragCoefficient c_d (–)
   * @param liftCoefficient c_l (–)
   * @param density ρ, kg/m³
   * @param spinDecay relative loss of spin in flight, 1/s
   * @throws IllegalArgumentException when a value is out of any physical range
   */
  public AirLaw(double dragCoefficient, double liftCoefficient, double density, double spinDecay) {
    this(dragCoefficient, liftCoefficient, density, spinDecay, 0, 0);
  }

  /**
   * Another drag.
   *
   * @param coefficient c_d (–)
   * @return the changed law
   */
  public AirLaw withDrag(double coefficient) {
    return new AirLaw(coefficient, liftCoefficient, density, spinDecay, windX, windY);
  }

  /**
   * Another Magnus force.
   *
   * @param coefficient c_l (–)
   * @return the changed law
   */
  public AirLaw withLift(double coefficient) {
    return new AirLaw(dragCoefficient, coefficient, density, spinDecay, windX, windY);
  }

  /**
   * Moving air: drag acts on the velocity relative to it.
   *
   * @param x m/s
   * @param y m/s
   * @return the changed law
   */
  public AirLaw withWind(double x, double y) {
    return new AirLaw(dragCoefficient, liftCoefficient, density, spinDecay, x, y);
  }
}
