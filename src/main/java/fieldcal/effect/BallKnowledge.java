package fieldcal.effect;

/**
 * What is known of a parameter of the ball's own model before any data.
 *
 * @param parameter its name, as {@link fieldcal.ball.FlatModel#parameters} has it
 * @param mean expected value, in the parameter's unit
 * @param deviation standard deviation of what is expected, positive, in the parameter's unit
 */
public record BallKnowledge(String parameter, double mean, double deviation) {
  /**
   * How well the inertia factor of an unknown golf ball is known. A cover of a tenth of the radius that is 15 % lighter or heavier than the core changes it by 0.01 (core and cover as two solid spheres); twice that is
   * allowed for.
   */
  private static final double INERTIA_DEVIATION = 0.02;

  /**
   * kSwitch of a golf ball that is kicked without spin, 1/(1 + β), which mechanics gives whatever the carpet. With the spin estimated separately, kSwitch is this number; without, it takes up the mean of the spin, since
   * (1 − spin)·(1 − kSwitch) is all that flat kicks show.
   *
   * @return 0.714 ± 0.010
   */
  public static BallKnowledge mechanicalSwitch() {
    double rolling = 1 + BallBody.GOLF_BALL.inertiaFactor();
    return new BallKnowledge("kSwitch", 1 / rolling, INERTIA_DEVIATION / (rolling * rolling));
  }
}
