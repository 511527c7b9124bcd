package fieldcal.simulation;

import fieldcal.vision.FieldArc;
import fieldcal.vision.FieldLine;
import java.util.List;

/**
 * The simulated field.
 *
 * @param length along x, m
 * @param width along y, m
 * @param boundary width of the strip outside the lines, m
 * @param goalWidth width of the goals along y, m
 * @param goalDepth depth of the goals along x, m
 */
public record FieldSize(
    double length, double width, double boundary, double goalWidth, double goalDepth) {

  /** Width of the painted lines, m. */
  private static final double PAINT = 0.01;

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

  /**
   * The painted lines with the league's names.
   *
   * @return touch, goal, halfway and centre lines, and penalty areas (0.15 of the length deep and 0.4 of the width wide)
   */
  List<FieldLine> lines() {
    double x = length / 2;
    double y = width / 2;
    double depth = 0.15 * length;
    double half = 0.2 * width;
    return List.of(
        line("TopTouchLine", -x, y, x, y),
        line("BottomTouchLine", -x, -y, x, -y),
        line("LeftGoalLine", -x, -y, -x, y),
        line("RightGoalLine", x, -y, x, y),
        line("HalfwayLine", 0, -y, 0, y),
        line("CenterLine", -x, 0, x, 0),
        line("LeftPenaltyStretch", depth - x, -half, depth - x, half),
        line("RightPenaltyStretch", x - depth, -half, x - depth, half),
        line("LeftFieldLeftPenaltyStretch", -x, -half, depth - x, -half),
        line("LeftFieldRightPenaltyStretch", -x, half, depth - x, half),
        line("RightFieldLeftPenaltyStretch", x, half, x - depth, half),
        line("RightFieldRightPenaltyStretch", x, -half, x - depth, -half));
  }

  /** The centre circle. */
  List<FieldArc> arcs() {
    return List.of(new FieldArc("CenterCircle", 0, 0, 0.5, 0, 2 * Math.PI, PAINT));
  }

  private static FieldLine line(String name, double x1, double y1, double x2, double y2) {
    return new FieldLine(name, x1, y1, x2, y2, PAINT);
  }
}
