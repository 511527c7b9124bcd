package fieldcal.ball;

import java.util.List;

/**
 * How a ball moves over the carpet: it slides until its surface no longer slips, then it rolls until it rests.
 *
 * <p>Both accelerations act against the motion and do not depend on the speed. A ball kicked without spin slides until its speed has fallen to the fraction {@code kSwitch} of the kick speed. For a ball with the moment of inertia {@code β·m·r²} the friction that
 * takes {@code Δv} from its speed gives it the rolling speed {@code Δv/β}; the two meet at {@code v = v_kick/(1 + β)}, hence
 * {@code kSwitch = 1/(1 + β)} (Coulomb friction on a sphere; G. G. Coriolis, Théorie mathématique des effets du jeu de billard,
 * 1835: 5/7 for a solid ball).
 *
 * @param accSlide acceleration along the direction of travel while sliding, m/s², negative
 * @param accRoll acceleration along the direction of travel while rolling, m/s², negative
 * @param kSwitch speed at the start of rolling as a fraction of the speed of a kick without spin, above 0 and below 1
 */
public record FlatModel(double accSlide, double accRoll, double kSwitch) {

  private static final String MATCHES =
      "ten matches of 2026, Immortals-Robotics/Simulator docs/calibration";
  private static final FlatModel TYPICAL = new FlatModel(-3.3, -0.28, 0.66);

  /** An acceleration's scale is at least this share of it: a search that spreads its starts by 0.7 scales then covers a published value that is 15 % off, whatever its size. */
  private static final double LEAST_SCALE = 0.25;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when an acceleration is not negative or {@code kSwitch} is not between 0 and 1
   */
  public FlatModel {
    Checks.negative("accSlide", accSlide);
    Checks.negative("accRoll", accRoll);
    Checks.between("kSwitch", kSwitch, 0, 1);
  }

  /**
   * A golf ball on the carpets of 2026: the mean of ten matches (Immortals-Robotics/Simulator, {@code docs/calibration}).
   * Carpets differ by a quarter in {@code accRoll}: a start for an estimate, no substitute for one.
   *
   * @return the typical model
   */
  public static FlatModel typical() {
    return TYPICAL;
  }

  /**
   * The model of a ball whose moment of inertia is known.
   *
   * @param accSlide acceleration while sliding, m/s², negative
   * @param accRoll acceleration while rolling, m/s², negative
   * @param inertiaFactor {@code β} of the moment of inertia {@code β·m·r²}, positive: 0.4 for a solid ball, 0.67 for a hollow one
   * @return the model
   * @throws IllegalArgumentException when a number is out of its range
   */
  public static FlatModel fromInertia(double accSlide, double accRoll, double inertiaFactor) {
    return new FlatModel(
        accSlide, accRoll, 1 / (1 + Checks.positive("inertiaFactor", inertiaFactor)));
  }

  /**
   * The inertia factor that {@code kSwitch} stands for.
   *
   * @return {@code β = 1/kSwitch − 1}
   */
  public double inertiaFactor() {
    return 1 / kSwitch - 1;
  }

  /**
   * The numbers as parameters, in the order of the record. The bounds are chosen several times wider than the carpets known so
   * far. A simulator needs more of the sliding deceleration: grSim's friction has a coefficient of 1 along each axis of the
   * field, so that its ball slides with up to √2·g = 13.9 m/s² along a diagonal, and with its rolling friction up to 14.6 m/s².
   *
   * @return accSlide, accRoll, kSwitch
   */
  public List<Parameter> parameters() {
    return List.of(
        new Parameter("accSlide", "m/s²", accSlide, scale(accSlide, 1), -20, -0.5, true, MATCHES),
        new Parameter("accRoll", "m/s²", accRoll, scale(accRoll, 0.1), -2, -0.02, true, MATCHES),
        new Parameter("kSwitch", "", kSwitch, 0.1, 0.3, 0.95, true, MATCHES));
  }

  /** The scale of an acceleration: that of the carpets known so far, and more where the ball slows down much faster. */
  private static double scale(double acceleration, double onCarpets) {
    return Math.max(onCarpets, LEAST_SCALE * -acceleration);
  }

  /**
   * A model with these numbers.
   *
   * @param values in the order of {@link #parameters()}
   * @return the model
   * @throws IllegalArgumentException when there are not three, or one is out of its range
   */
  public FlatModel withParameters(double... values) {
    Checks.length("values", values, 3);
    return new FlatModel(values[0], values[1], values[2]);
  }

  /**
   * How far a kick without spin goes.
   *
   * @param kickSpeed speed of the kick, m/s, not negative
   * @return the distance from the kick to where the ball rests, m
   * @throws IllegalArgumentException when the speed is negative or not finite
   */
  public double restDistance(double kickSpeed) {
    Checks.notNegative("kickSpeed", kickSpeed);
    return kickSpeed * kickSpeed * restDistancePerSquaredSpeed();
  }

  /**
   * How fast to kick, without spin, so that the ball arrives with a given speed. The answer is unique: a faster kick is faster everywhere.
   *
   * @param distance from the kick, m, not negative
   * @param arrivalSpeed wanted speed there, m/s, not negative; 0 = the ball comes to rest there
   * @return the speed of the kick, m/s
   * @throws IllegalArgumentException when a number is negative or not finite
   */
  public double kickSpeedToArrive(double distance, double arrivalSpeed) {
    Checks.notNegative("distance", distance);
    Checks.notNegative("arrivalSpeed", arrivalSpeed);
    // Arrives rolling: the distance that is left there, v²/(2|accRoll|), is the rest distance less
    // the given one.
    double left = arrivalSpeed * arrivalSpeed / (-2 * accRoll);
    double rolling = Math.sqrt((distance + left) / restDistancePerSquaredSpeed());
    if (arrivalSpeed <= kSwitch * rolling) {
      return rolling;
    }
    return Math.sqrt(arrivalSpeed * arrivalSpeed - 2 * accSlide * distance);
  }

  private double restDistancePerSquaredSpeed() {
    return (kSwitch * kSwitch - 1) / (2 * accSlide) - kSwitch * kSwitch / (2 * accRoll);
  }
}
