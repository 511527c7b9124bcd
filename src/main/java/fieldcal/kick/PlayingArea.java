package fieldcal.kick;

import fieldcal.vision.FieldGeometry;

/** The field within its lines, as far as known. */
final class PlayingArea {
  /** A ball has left when all of it is over the line: half its diameter, m. */
  private static final double BALL_RADIUS = 0.0215;

  private double halfLength = Double.POSITIVE_INFINITY;
  private double halfWidth = Double.POSITIVE_INFINITY;

  void update(FieldGeometry geometry) {
    halfLength = geometry.length() / 2;
    halfWidth = geometry.width() / 2;
  }

  /** How far a ball is beyond the lines, m; zero or negative inside. */
  double outside(double x, double y) {
    return Math.max(Math.abs(x) - halfLength, Math.abs(y) - halfWidth) - BALL_RADIUS;
  }
}
