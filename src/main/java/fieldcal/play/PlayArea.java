package fieldcal.play;

import fieldcal.vision.FieldGeometry;

/**
 * Where robots and ball may be.
 *
 * @param length of the field along x, m
 * @param width of the field along y, m
 * @param margin how far outside the lines a robot's centre may get, m
 * @param goalWidth between the posts, m; robots keep out of the goals
 */
public record PlayArea(double length, double width, double margin, double goalWidth) {
  /** Radius of a robot and of the ball, m (rules of the league). */
  static final double ROBOT_RADIUS = 0.09;

  static final double BALL_RADIUS = 0.0215;

  /** From a robot's centre to a ball at its dribbler, m: 75 mm to the dribbler, as in the league's robots, and the ball's radius. */
  static final double AT_DRIBBLER = 0.0965;

  /** No robot is sent nearer than this to the edge of the area, m: it may overshoot a little, and cameras are slightly wrong. */
  static final double RESERVE = 0.04;

  /** Free carpet around a goal that robots leave alone, m. */
  private static final double GOAL_CLEARANCE = 0.12;

  /**
   * Checks the sizes. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the length or width is not in [2, 50] m, the margin not in [0, 1] m, the goal width negative, or a value NaN
   */
  public PlayArea {
    if (!(length >= 2 && width >= 2 && length <= 50 && width <= 50)) {
      throw new IllegalArgumentException(
          "field must be 2 to 50 m long and wide, but is " + length + " x " + width);
    }
    if (!(margin >= 0 && margin <= 1)) {
      throw new IllegalArgumentException("margin must lie in [0, 1] m, but is " + margin);
    }
    if (!(goalWidth >= 0)) {
      throw new IllegalArgumentException("goal width must not be negative, but is " + goalWidth);
    }
  }

  /**
   * The area of a published field: robots stay 0.1 m away from the outer edge of the boundary, but at most 0.2 m outside the lines.
   *
   * @param geometry the field
   * @return the area
   */
  public static PlayArea of(FieldGeometry geometry) {
    double margin = Math.max(0, Math.min(0.2, geometry.boundaryWidth() - 0.1));
    return new PlayArea(geometry.length(), geometry.width(), margin, geometry.goalWidth());
  }

  /**
   * How far a robot's centre at a place is from leaving the area.
   *
   * @param x m
   * @param y m
   * @return distance, m; negative outside
   */
  public double clearance(double x, double y) {
    return Math.min(length / 2 + margin - Math.abs(x), width / 2 + margin - Math.abs(y));
  }

  /** Whether a robot's centre may be there. */
  boolean free(double x, double y) {
    return clearance(x, y) >= RESERVE && !inGoal(x, y, ROBOT_RADIUS + 0.01);
  }

  /** Whether something of a radius there touches a goal or is in it. */
  boolean inGoal(double x, double y, double radius) {
    return goalWidth > 0
        && Math.abs(x) > length / 2 - radius
        && Math.abs(y) < goalWidth / 2 + radius;
  }

  /** Whether a robot can get at a ball there. */
  boolean reachable(double x, double y) {
    return clearance(x, y) > -0.06 && !inGoal(x, y, GOAL_CLEARANCE);
  }

  /** Whether a ball there is clearly outside the lines. */
  boolean outside(double x, double y) {
    return Math.abs(x) > length / 2 + 0.1 || Math.abs(y) > width / 2 + 0.1;
  }

  /** Whether a ball there is within the lines. */
  boolean within(double x, double y) {
    return Math.abs(x) <= length / 2 && Math.abs(y) <= width / 2;
  }

  /** The nearest x at which a ball can well be kicked: inside the lines. */
  double placingX(double x) {
    double most = length / 2 - 0.25;
    return Math.max(-most, Math.min(most, x));
  }

  /** The nearest such y. */
  double placingY(double y) {
    double most = width / 2 - 0.25;
    return Math.max(-most, Math.min(most, y));
  }

  double clampX(double x) {
    double most = length / 2 + margin - RESERVE;
    return Math.max(-most, Math.min(most, x));
  }

  double clampY(double y) {
    double most = width / 2 + margin - RESERVE;
    return Math.max(-most, Math.min(most, y));
  }
}
