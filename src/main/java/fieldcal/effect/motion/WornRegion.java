package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.FrictionZone;
import java.util.List;

/**
 * A rectangle in which all friction, sliding and rolling, is multiplied by 1 + change. Files write its bounds as one value, {@code region}: [x0,x1,y0,y1].
 *
 * @param change relative change of all friction within (–), 0 = none
 * @param x0 smallest x, m
 * @param x1 largest x, m
 * @param y0 smallest y, m
 * @param y1 largest y, m
 */
public record WornRegion(double change, double x0, double x1, double y0, double y1)
    implements FrictionZone {
  private static final String ID = "worn_region";

  /** A way within shorter than this, m, is a rounding error of having just left. */
  private static final double SHORTEST_CHORD = 1e-7;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public WornRegion {
    EffectParameters.requireFinite(ID, change, x0, x1, y0, y1);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "In one part of the field the carpet brakes more or less than elsewhere.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "change",
            "",
            change,
            0.05,
            -0.9,
            3,
            true,
            "chosen wide; a worn goal area shows some tenths"),
        EffectParameters.place("region_x0", "m", x0, -20, 20, "bound of the region"),
        EffectParameters.place("region_x1", "m", x1, -20, 20, "bound of the region"),
        EffectParameters.place("region_y0", "m", y0, -20, 20, "bound of the region"),
        EffectParameters.place("region_y1", "m", y1, -20, 20, "bound of the region"));
  }

  @Override
  public WornRegion withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 5);
    return new WornRegion(v[0], v[1], v[2], v[3], v[4]);
  }

  @Override
  public boolean isAbsent() {
    return change == 0;
  }

  @Override
  public double frictionFactor() {
    return 1 + change;
  }

  @Override
  public boolean contains(double x, double y) {
    return x > x0 && x < x1 && y > y0 && y < y1;
  }

  @Override
  public double otherSide(boolean inside, double fromX, double fromY, double toX, double toY) {
    if (inside) {
      return contains(toX, toY) ? Double.NaN : 1;
    }
    // The part of the way within both strips (clipping of Liang and Barsky).
    double dx = toX - fromX;
    double dy = toY - fromY;
    double enter = Math.max(0, Math.max(enters(fromX, dx, x0, x1), enters(fromY, dy, y0, y1)));
    double leave = Math.min(1, Math.min(leaves(fromX, dx, x0, x1), leaves(fromY, dy, y0, y1)));
    double chord = (leave - enter) * Math.sqrt(dx * dx + dy * dy);
    return chord > SHORTEST_CHORD ? 0.5 * (enter + leave) : Double.NaN;
  }

  private static double enters(double from, double d, double low, double high) {
    if (d == 0) {
      return from > low && from < high ? 0 : Double.POSITIVE_INFINITY;
    }
    return ((d > 0 ? low : high) - from) / d;
  }

  private static double leaves(double from, double d, double low, double high) {
    return d == 0 ? 1 : ((d > 0 ? high : low) - from) / d;
  }
}
