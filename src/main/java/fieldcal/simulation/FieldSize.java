package fieldcal.simulation;

/**
 * The simulated field.
 *
 * @param length along x, m
 * @param width along y, m
 * @param boundary width of the strip outside the lines, m
 * @param goalWidth m
 * @param goalDepth m
 */
public record FieldSize(
    double length, double width, double boundary, double goalWidth, double goalDepth) {

  /** Division A of the league's rules. */
  public static final FieldSize DIVISION_A = new FieldSize(12, 9, 0.3, 1.8, 0.18);

  /** Division B of the league's rules. */
  public static final FieldSize DIVISION_B = new FieldSize(9, 6, 0.3, 1.0, 0.18);

  /**
   * Checks the sizes. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is out of range or NaN
   */
  public FieldSize {
    if (!(length >= 2 && length <= 50 && width >= 2 && width <= 50)) {
      throw new IllegalArgumentException(
          "field must be 2 to 50 m long and wide, but is " + length + " x " + width);
    }
    if (!(boundary >= 0 && goalWidth >= 0 && goalDepth >= 0)) {
      throw new IllegalArgumentException(
          "boundary and goal must not be negative: "
              + boundary
              + ", "
              + goalWidth
              + ", "
              + goalDepth);
    }
  }
}
