package fieldcal.app.report;

/**
 * The fitted trajectory, sampled; columns of equal length. Some 100 samples make a smooth line; a chip wants a sample
 * at each landing. The arrays are the report's own: do not change them.
 *
 * @param t time since the kick, s
 * @param x position, m
 * @param y position, m
 * @param z height, m; 0 on the ground
 * @param speed over the ground, m/s
 */
public record FittedPath(
    @Rounded(4) double[] t,
    @Rounded(4) double[] x,
    @Rounded(4) double[] y,
    @Rounded(4) double[] z,
    @Rounded(4) double[] speed) {

  /** No trajectory. */
  public static final FittedPath NONE =
      new FittedPath(new double[0], new double[0], new double[0], new double[0], new double[0]);

  /**
   * Copies the arrays.
   *
   * @throws IllegalArgumentException if the lengths differ
   */
  public FittedPath {
    Columns.requireLength("x", t.length, x.length);
    Columns.requireLength("y", t.length, y.length);
    Columns.requireLength("z", t.length, z.length);
    Columns.requireLength("speed", t.length, speed.length);
    t = t.clone();
    x = x.clone();
    y = y.clone();
    z = z.clone();
    speed = speed.clone();
  }
}
