package fieldcal.ball;

import java.util.List;
import java.util.OptionalDouble;

/**
 * How a chipped ball flies, bounces and rolls out: parabolas under gravity without drag; at each impact the horizontal velocity
 * shrinks to a fraction of itself and the vertical one is reversed and shrinks; a hop whose apex would lie below {@code lowestHop} does not take place: the ball rolls instead.
 *
 * <p>The model of the league's geometry message ({@code SSL_BallModelChipFixedLoss}).
 *
 * @param dampingXyFirstHop horizontal velocity after the first impact as a fraction of that before, positive
 * @param dampingXyOtherHops the same at each later impact, positive
 * @param dampingZ vertical velocity after each impact as a fraction of that before, above 0 and below 1
 * @param accRoll acceleration along the direction of travel while rolling, m/s², negative
 * @param lowestHop apex of the lowest hop that takes place, m, positive: {@link #MIN_HOP_HEIGHT} in the league's models; physics engines let a ball hop lower
 */
public record ChipModel(
    double dampingXyFirstHop,
    double dampingXyOtherHops,
    double dampingZ,
    double accRoll,
    double lowestHop) {

  /**
   * A hop with a lower apex than this counts as rolling in the league's models, m. The limit of TIGERs Mannheim, from whom the model comes (Sumatra,
   * {@code BallParameters}: 10 mm).
   */
  public static final double MIN_HOP_HEIGHT = 0.01;

  /** Where physics engines end hopping, m: grSim below 0.1 m/s, that is v²/(2g). */
  public static final double ENGINE_MIN_HOP_HEIGHT = 5e-4;

  /**
   * More flights than this are not followed. A real ball makes a handful; chosen so that a {@code dampingZ} close to 1 does not
   * hang a solver.
   */
  public static final int MAX_FLIGHTS = 100;

  private static final String MATCHES =
      "ten matches of 2026, Immortals-Robotics/Simulator docs/calibration";
  private static final ChipModel TYPICAL = new ChipModel(0.70, 0.87, 0.47, -0.28);

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a damping is not positive, {@code dampingZ} not below 1, the acceleration not negative or the lowest hop not positive
   */
  public ChipModel {
    Checks.positive("dampingXyFirstHop", dampingXyFirstHop);
    Checks.positive("dampingXyOtherHops", dampingXyOtherHops);
    Checks.between("dampingZ", dampingZ, 0, 1);
    Checks.negative("accRoll", accRoll);
    Checks.positive("lowestHop", lowestHop);
  }

  /**
   * A model whose hops end as the league's do.
   *
   * @param dampingXyFirstHop horizontal velocity after the first impact as a fraction of that before, positive
   * @param dampingXyOtherHops the same at each later impact, positive
   * @param dampingZ vertical velocity after each impact as a fraction of that before, above 0 and below 1
   * @param accRoll acceleration along the direction of travel while rolling, m/s², negative
   * @throws IllegalArgumentException when a damping is not positive, {@code dampingZ} not below 1 or the acceleration not negative
   */
  public ChipModel(
      double dampingXyFirstHop, double dampingXyOtherHops, double dampingZ, double accRoll) {
    this(dampingXyFirstHop, dampingXyOtherHops, dampingZ, accRoll, MIN_HOP_HEIGHT);
  }

  /**
   * The same with another lowest hop.
   *
   * @param height of its apex, m, positive
   * @return the changed copy
   * @throws IllegalArgumentException when it is not positive
   */
  public ChipModel withLowestHop(double height) {
    return new ChipModel(dampingXyFirstHop, dampingXyOtherHops, dampingZ, accRoll, height);
  }

  /**
   * A golf ball on the carpets of 2026: the mean of ten matches (Immortals-Robotics/Simulator, {@code docs/calibration}).
   *
   * @return the typical model
   */
  public static ChipModel typical() {
    return TYPICAL;
  }

  /**
   * The numbers that are estimated as parameters, in the order of the record. The bounds are chosen wide; a horizontal damping slightly above 1 is
   * possible when topspin from an earlier bounce pushes the ball forward.
   *
   * @return dampingXyFirstHop, dampingXyOtherHops, dampingZ, accRoll
   */
  public List<Parameter> parameters() {
    return List.of(
        new Parameter("dampingXyFirstHop", "", dampingXyFirstHop, 0.1, 0.2, 1.1, true, MATCHES),
        new Parameter("dampingXyOtherHops", "", dampingXyOtherHops, 0.1, 0.3, 1.2, true, MATCHES),
        new Parameter("dampingZ", "", dampingZ, 0.1, 0.1, 0.9, true, MATCHES),
        new Parameter("accRoll", "m/s²", accRoll, 0.1, -2, -0.02, true, MATCHES));
  }

  /**
   * A model with these numbers.
   *
   * @param values in the order of {@link #parameters()}
   * @return the model
   * @throws IllegalArgumentException when there are not four, or one is out of its range
   */
  public ChipModel withParameters(double... values) {
    Checks.length("values", values, 4);
    return new ChipModel(values[0], values[1], values[2], values[3], lowestHop);
  }

  /**
   * How fast to chip so that a given landing is at a given distance. Each flight's length grows with the square of the kick speed.
   *
   * @param distance distance over the ground from the kick, m, not negative
   * @param elevation angle between the kick and the ground, rad, above 0 and below π/2
   * @param landing which landing: 1 = the first
   * @return the speed of the kick (the length of its velocity, vertical part included), m/s; empty when a ball of that speed
   *     rolls before that landing, its hops being lower than the lowest
   * @throws IllegalArgumentException when a number is out of its range
   */
  public OptionalDouble kickSpeedToLand(double distance, double elevation, int landing) {
    Checks.notNegative("distance", distance);
    Checks.between("elevation", elevation, 0, Math.PI / 2);
    Checks.between("landing", landing, 1, MAX_FLIGHTS);
    double flights = 0;
    double relativeLength = 1;
    for (int i = 0; i < landing; i++) {
      flights += relativeLength;
      relativeLength *= dampingZ * dampingXyAtImpact(i + 1);
    }
    double speed = Math.sqrt(distance * Gravity.ACCELERATION / (Math.sin(2 * elevation) * flights));
    boolean lands = ChipTrajectory.flightsByRule(this, speed * Math.sin(elevation)) >= landing;
    return lands ? OptionalDouble.of(speed) : OptionalDouble.empty();
  }

  /** The fraction of the horizontal velocity that an impact leaves; 1 = the first impact. */
  double dampingXyAtImpact(int impact) {
    return impact == 1 ? dampingXyFirstHop : dampingXyOtherHops;
  }
}
