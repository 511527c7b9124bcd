package fieldcal.vision;

import java.util.Objects;

/**
 * A straight line painted on the field, from centre line to centre line.
 *
 * @param name the line's name in the league's geometry, such as {@code TopTouchLine}
 * @param x1 start, m
 * @param y1 start, m
 * @param x2 end, m
 * @param y2 end, m
 * @param thickness width of the paint, m
 */
public record FieldLine(String name, double x1, double y1, double x2, double y2, double thickness) {

  /**
   * Checks the name. {@inheritDoc}
   *
   * @throws NullPointerException if the name is null
   */
  public FieldLine {
    Objects.requireNonNull(name, "name");
  }
}
