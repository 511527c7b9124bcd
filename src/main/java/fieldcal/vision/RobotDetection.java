package fieldcal.vision;

import java.util.Objects;

/**
 * A robot in one image.
 *
 * @param id team and number
 * @param x position of the pattern's centre in the field frame, m
 * @param y position of the pattern's centre in the field frame, m
 * @param orientation direction of the front, rad, counter-clockwise from x; NaN when absent
 * @param confidence 0 … 1 as reported; 1 when absent
 * @param height height of the pattern that vision assumes, m; NaN when absent
 */
public record RobotDetection(
    RobotId id, double x, double y, double orientation, double confidence, double height) {

  /**
   * Checks the id. {@inheritDoc}
   *
   * @throws NullPointerException if the id is null
   */
  public RobotDetection {
    Objects.requireNonNull(id, "id");
  }
}
