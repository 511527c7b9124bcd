package fieldcal.play;

import fieldcal.vision.FieldGeometry;

/**
 * A line to kick along: each robot has one of its ends.
 *
 * @param x0 end of the first robot, m
 * @param y0 end of the first robot, m
 * @param x1 end of the second robot, m
 * @param y1 end of the second robot, m
 */
public record PlayLine(double x0, double y0, double x1, double y1) {

  /**
   * Checks that it is a line. {@inheritDoc}
   *
   * @throws IllegalArgumentException when it is shorter than 1.5 m or not finite
   */
  public PlayLine {
    double length = Math.hypot(x1 - x0, y1 - y0);
    if (!(length >= 1.5 && length < 100)) {
      throw new IllegalArgumentException(
          "a line to kick along must be at least 1.5 m long, but is " + length);
    }
  }

  /** Which part of the field is used. */
  public enum Half {
    /** All of it. */
    WHOLE,
    /** The half at negative x. */
    NEGATIVE,
    /** The half at positive x. */
    POSITIVE
  }

  /**
   * A diagonal for flat kicks.
   *
   * @param geometry the field
   * @param half which part of it
   * @param mirrored the other diagonal, ends swapped
   * @return the line; its ends are an eighth of the length and a sixth of the width inside the lines
   */
  public static PlayLine diagonal(FieldGeometry geometry, Half half, boolean mirrored) {
    double centre =
        switch (half) {
          case WHOLE -> 0;
          case NEGATIVE -> -geometry.length() / 4;
          case POSITIVE -> geometry.length() / 4;
        };
    double dx = (half == Half.WHOLE ? 0.38 : 0.19) * geometry.length();
    double dy = 0.34 * geometry.width();
    return mirrored
        ? new PlayLine(centre + dx, -dy, centre - dx, dy)
        : new PlayLine(centre - dx, -dy, centre + dx, dy);
  }

  /**
   * A line for chips, parallel to the half-way line.
   *
   * @param geometry the field
   * @param x where it crosses the x axis, m: cameras should overlap there; 0 is the half-way line
   * @param swapped whether the robots have changed ends
   * @return the line
   */
  public static PlayLine across(FieldGeometry geometry, double x, boolean swapped) {
    double dy = (swapped ? -0.39 : 0.39) * geometry.width();
    return new PlayLine(x, -dy, x, dy);
  }

  /**
   * Its length.
   *
   * @return m
   */
  public double length() {
    return Math.hypot(x1 - x0, y1 - y0);
  }

  double x(int end) {
    return end == 0 ? x0 : x1;
  }

  double y(int end) {
    return end == 0 ? y0 : y1;
  }

  /** Distance of a point from the line, m. */
  double aside(double x, double y) {
    return Math.abs((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) / length();
  }
}
