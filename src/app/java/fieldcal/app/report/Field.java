package fieldcal.app.report;

import fieldcal.vision.FieldGeometry;

/**
 * The lines of the field, all in m; what is NaN is not drawn.
 *
 * @param length between the goal lines
 * @param width between the touch lines
 * @param boundary width of the strip around the lines
 * @param goalWidth inner width of a goal
 * @param goalDepth depth of a goal
 * @param penaltyAreaDepth along x
 * @param penaltyAreaWidth along y
 * @param centreCircleRadius radius
 */
public record Field(
    @Rounded(3) double length,
    @Rounded(3) double width,
    @Rounded(3) double boundary,
    @Rounded(3) double goalWidth,
    @Rounded(3) double goalDepth,
    @Rounded(3) double penaltyAreaDepth,
    @Rounded(3) double penaltyAreaWidth,
    @Rounded(3) double centreCircleRadius) {
  /** The rules' centre circle is one metre wide in all divisions. */
  private static final double CENTRE_CIRCLE = 0.5;

  /**
   * Checks that there is an area to draw.
   *
   * @throws IllegalArgumentException if length or width is not positive
   */
  public Field {
    if (!(length > 0 && width > 0)) {
      throw new IllegalArgumentException("field of " + length + " m × " + width + " m");
    }
  }

  /**
   * The field of a geometry packet.
   *
   * @param geometry as published
   * @return what reports draw of it
   */
  public static Field of(FieldGeometry geometry) {
    return new Field(
        geometry.length(),
        geometry.width(),
        geometry.boundaryWidth(),
        geometry.goalWidth(),
        geometry.goalDepth(),
        Double.NaN,
        Double.NaN,
        CENTRE_CIRCLE);
  }
}
