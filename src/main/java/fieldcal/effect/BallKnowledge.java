package fieldcal.effect;

/**
 * What is known of a parameter of the ball's own model before any data.
 *
 * @param parameter its name, as {@link fieldcal.ball.FlatModel#parameters} has it
 * @param mean expected value, in the parameter's unit
 * @param deviation standard deviation of what is expected, positive, in the parameter's unit
 */
public record BallKnowledge(String parameter, double mean, double deviation) {
  /** Inertia factor of a solid ball, 2/5, and of a hollow one, 2/3: all others lie between them (any textbook of mechanics). */
  private static final double SOLID = 0.4;

  private static final double HOLLOW = 2.0 / 3;

  /**
   * kSwitch of a ball that is kicked without spin, 1/(1 + β) for an inertia factor β between that of a solid and that of a hollow ball: as if uniform between the two. With spin told apart kSwitch is this number of mechanics; without, it
   * takes up the mean of the spin, since (1 − spin)·(1 − kSwitch) is all that flat kicks show.
   *
   * @return 0.657 ± 0.033
   */
  public static BallKnowledge mechanicalSwitch() {
    double solid = 1 / (1 + SOLID);
    double hollow = 1 / (1 + HOLLOW);
    return new BallKnowledge("kSwitch", 0.5 * (solid + hollow), (solid - hollow) / Math.sqrt(12));
  }
}
