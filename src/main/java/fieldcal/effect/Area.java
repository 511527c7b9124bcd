package fieldcal.effect;

/**
 * A rectangle of the field, its sides along the axes. Immutable.
 *
 * @param x0 smallest x, m
 * @param x1 largest x, m
 * @param y0 smallest y, m
 * @param y1 largest y, m
 */
public record Area(double x0, double x1, double y0, double y1) {
  /**
   * The smallest rectangle around two.
   *
   * @param other another one
   * @return the smallest rectangle that contains both
   */
  public Area and(Area other) {
    return new Area(
        Math.min(x0, other.x0),
        Math.max(x1, other.x1),
        Math.min(y0, other.y0),
        Math.max(y1, other.y1));
  }

  /**
   * Whether it is near to the rectangle around two places.
   *
   * @param ax x of one, m
   * @param ay y of one, m
   * @param bx x of the other, m
   * @param by y of the other, m
   * @param margin distance that still counts, m
   * @return false only where the straight line between both stays farther off
   */
  public boolean isNear(double ax, double ay, double bx, double by, double margin) {
    return Math.min(ax, bx) < x1 + margin
        && Math.max(ax, bx) > x0 - margin
        && Math.min(ay, by) < y1 + margin
        && Math.max(ay, by) > y0 - margin;
  }
}
