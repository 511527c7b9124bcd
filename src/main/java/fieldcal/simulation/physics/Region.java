package fieldcal.simulation.physics;

/**
 * A rectangle of the field, such as a worn part of the carpet or the view of a camera.
 *
 * @param x0 smallest x, m
 * @param x1 largest x, m
 * @param y0 smallest y, m
 * @param y1 largest y, m
 */
public record Region(double x0, double x1, double y0, double y1) {

  /** No rectangle: nowhere, or no limit of a view. */
  public static final Region NONE = new Region(0, 0, 0, 0);

  /**
   * Checks the order. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a bound is not finite or the upper one lies below the lower one
   */
  public Region {
    Check.finite("x0", x0);
    Check.finite("y0", y0);
    Check.range("x1", x1, x0, Double.MAX_VALUE);
    Check.range("y1", y1, y0, Double.MAX_VALUE);
  }

  /**
   * Whether a place is inside.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @return false on the edge
   */
  public boolean contains(double x, double y) {
    return x > x0 && x < x1 && y > y0 && y < y1;
  }
}
