package fieldcal.simulation.physics;

/**
 * Where two pieces of carpet meet: a straight line that takes speed from a ball on the ground and turns its path.
 *
 * @param loss share of the speed across the line that a crossing takes (–), −0.9 to 0.9
 * @param turn of the path at each crossing, counter-clockwise, rad
 * @param normal direction perpendicular to the line in the field frame, rad, 0 = along x, counter-clockwise
 * @param distance of the line from the field's centre along the normal, m
 */
public record Seam(double loss, double turn, double normal, double distance) {
  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is not finite or the loss is not in [-0.9, 0.9]
   */
  public Seam {
    Check.range("loss", loss, -0.9, 0.9);
    Check.finite("turn", turn);
    Check.finite("normal", normal);
    Check.finite("distance", distance);
  }

  /** On which side of the line a place is. */
  boolean beyond(double x, double y) {
    return x * Math.cos(normal) + y * Math.sin(normal) > distance;
  }

  /** Changes the horizontal velocity of a state as a crossing does. */
  void cross(double[] state) {
    double nx = Math.cos(normal);
    double ny = Math.sin(normal);
    double lost = loss * (state[3] * nx + state[4] * ny);
    double vx = state[3] - lost * nx;
    double vy = state[4] - lost * ny;
    double cos = Math.cos(turn);
    double sin = Math.sin(turn);
    state[3] = cos * vx - sin * vy;
    state[4] = sin * vx + cos * vy;
  }
}
