package fieldcal.vision;

import java.util.Objects;

/**
 * A curved line painted on the field.
 *
 * @param name the arc's name in the league's geometry, such as {@code CenterCircle}
 * @param x centre, m
 * @param y centre, m
 * @param radius to the middle of the paint, m
 * @param startAngle rad, counter-clockwise from x
 * @param endAngle rad, counter-clockwise from the start
 * @param thickness width of the paint, m
 */
public record FieldArc(
    String name,
    double x,
    double y,
    double radius,
    double startAngle,
    double endAngle,
    double thickness) {

  /**
   * Checks the name. {@inheritDoc}
   *
   * @throws NullPointerException if the name is null
   */
  public FieldArc {
    Objects.requireNonNull(name, "name");
  }
}
