package fieldcal.app.wording;

import java.util.ArrayList;
import java.util.List;

/** Directions and places as people on the field say them: by the goals, and by left and right for somebody who looks at the goal at +x. */
final class FieldWords {
  private static final double STRAIGHT = Math.toRadians(22.5);

  /** Shares of a shift that are smaller than this, or than two standard errors, are not said; chosen, mm. */
  private static final double SMALL_MM = 0.5;

  /** Sine of the angle up to which a line or a shift counts as parallel to a side of the field; chosen, 3°. */
  private static final double ALONG_A_SIDE = 0.05;

  private FieldWords() {}

  /**
   * A direction.
   *
   * @param angle rad, 0 = along x, counter-clockwise
   * @return for example "towards the +x goal (direction 3°)"
   */
  static String direction(double angle) {
    double a = Math.IEEEremainder(angle, 2 * Math.PI);
    boolean right = Math.abs(a) < Math.PI / 2 - STRAIGHT;
    boolean left = Math.abs(a) > Math.PI / 2 + STRAIGHT;
    boolean up = a > STRAIGHT && a < Math.PI - STRAIGHT;
    boolean down = a < -STRAIGHT && a > -Math.PI + STRAIGHT;
    String side = up ? "to the left (+y)" : down ? "to the right (−y)" : "";
    String goal = right ? "towards the +x goal" : left ? "towards the −x goal" : "";
    String words = goal.isEmpty() ? side : side.isEmpty() ? goal : goal + " and " + side;
    return words + ", direction " + Amount.decimals(Math.toDegrees(a), 0) + "°";
  }

  /**
   * A shift in the plane.
   *
   * @param x mm
   * @param y mm
   * @param errorX standard error, mm; NaN when unknown
   * @param errorY standard error, mm
   * @param too inserted behind the number, for example "too far "
   * @return for example "21 mm too far towards the +x goal and 3.1 mm too far to the right (−y)"
   */
  static String shift(double x, double y, double errorX, double errorY, String too) {
    List<String> parts = new ArrayList<>();
    boolean largerX = Math.abs(x) >= Math.abs(y);
    // What does not change the direction is not worth a reader's time.
    double small = ALONG_A_SIDE * Math.max(Math.abs(x), Math.abs(y));
    if (largerX || isWorthSaying(x, errorX, small)) {
      parts.add(millimetres(x) + too + (x < 0 ? "towards the −x goal" : "towards the +x goal"));
    }
    if (!largerX || isWorthSaying(y, errorY, small)) {
      parts.add(millimetres(y) + too + (y < 0 ? "to the right (−y)" : "to the left (+y)"));
    }
    return String.join(" and ", parts);
  }

  /**
   * A rectangle of the field.
   *
   * @param x0 smallest x, m
   * @param x1 largest x, m
   * @param y0 smallest y, m
   * @param y1 largest y, m
   * @return for example "Between x = 2 and 4.5 m and y = −1 and 1 m, on the side of the +x goal,"
   */
  static String region(double x0, double x1, double y0, double y1) {
    double x = (x0 + x1) / 2;
    double y = (y0 + y1) / 2;
    List<String> where = new ArrayList<>();
    if (Math.abs(x) > (x1 - x0) / 4) {
      where.add(x > 0 ? "on the side of the +x goal" : "on the side of the −x goal");
    }
    if (Math.abs(y) > (y1 - y0) / 4) {
      where.add(y > 0 ? "on the left (+y)" : "on the right (−y)");
    }
    return "between x = "
        + metres(x0)
        + " and "
        + metres(x1)
        + " m and y = "
        + metres(y0)
        + " and "
        + metres(y1)
        + " m"
        + (where.isEmpty() ? "" : ", " + String.join(", ", where) + ",");
  }

  /**
   * A straight line on the field.
   *
   * @param normal direction across it, rad
   * @param distance from the field's centre along the normal, m
   * @return for example "at x = −2 m" or "1.5 m from the centre in direction 45°"
   */
  static String line(double normal, double distance) {
    double cos = Math.cos(normal);
    double sin = Math.sin(normal);
    if (Math.abs(sin) < ALONG_A_SIDE) {
      return "at x = " + metres(distance * Math.signum(cos)) + " m";
    }
    if (Math.abs(cos) < ALONG_A_SIDE) {
      return "at y = " + metres(distance * Math.signum(sin)) + " m";
    }
    double towards = normal + (distance < 0 ? Math.PI : 0);
    double degrees = Math.toDegrees(Math.IEEEremainder(towards, 2 * Math.PI));
    return metres(Math.abs(distance))
        + " m from the centre in direction "
        + Amount.decimals(degrees, 0)
        + "°";
  }

  private static boolean isWorthSaying(double value, double error, double small) {
    return Math.abs(value) >= Math.max(SMALL_MM, small) && !(Math.abs(value) < 2 * error);
  }

  private static String millimetres(double value) {
    return Amount.of(Math.abs(value)) + " mm ";
  }

  private static String metres(double value) {
    return Amount.decimals(value, 2).replaceAll("\\.?0+$", "");
  }
}
