package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Area;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.FrictionZone;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A rectangle of the field in which all friction, sliding and rolling, is multiplied by 1 + change while the ball's centre is within. Impacts and drag do not change. Files write its bounds as one value, {@code region}: [x0,x1,y0,y1].
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

  /** Into how many parts along x and y a search cuts the arena; chosen: a region of half the size of a part still overlaps it by a half. */
  private static final int[][] GRIDS = {{2, 1}, {1, 2}, {3, 1}, {1, 3}, {2, 2}, {3, 3}};

  /** Size of the area in front of a goal, as shares of the arena: a defence area of division A is 1.8 m of 12 m deep, and 3.6 m of 9 m wide. */
  private static final double GOAL_AREA_DEPTH = 0.15;

  private static final double GOAL_AREA_SIDE = 0.3;

  /** How far bounds on the arena's rim lie outside, m; chosen: a predicted ball gets a little farther than those seen. */
  private static final double MARGIN = 0.5;

  /** A chord shorter than this, m, is due to rounding after the ball has just left. */
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
    return "In one part of the field the carpet slows balls more or less than elsewhere.";
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

  /** Halves, thirds, quarters, the nine fields of a grid and the middles of the two ends, where goal areas are. */
  @Override
  public List<Effect> candidates(Arena arena) {
    List<Effect> regions = new ArrayList<>();
    for (int[] parts : GRIDS) {
      for (int i = 0; i < parts[0]; i++) {
        for (int j = 0; j < parts[1]; j++) {
          regions.add(
              between(
                  arena,
                  (double) i / parts[0],
                  (i + 1.0) / parts[0],
                  (double) j / parts[1],
                  (j + 1.0) / parts[1]));
        }
      }
    }
    regions.add(between(arena, 0, GOAL_AREA_DEPTH, GOAL_AREA_SIDE, 1 - GOAL_AREA_SIDE));
    regions.add(between(arena, 1 - GOAL_AREA_DEPTH, 1, GOAL_AREA_SIDE, 1 - GOAL_AREA_SIDE));
    return List.copyOf(regions);
  }

  /** Absent, over a part of where balls were seen; bounds on its rim lie beyond it. */
  private static WornRegion between(
      Arena arena, double fromX, double toX, double fromY, double toY) {
    double width = arena.x1() - arena.x0();
    double height = arena.y1() - arena.y0();
    return new WornRegion(
        0,
        arena.x0() + (fromX == 0 ? -MARGIN : fromX * width),
        toX == 1 ? arena.x1() + MARGIN : arena.x0() + toX * width,
        arena.y0() + (fromY == 0 ? -MARGIN : fromY * height),
        toY == 1 ? arena.y1() + MARGIN : arena.y0() + toY * height);
  }

  @Override
  public List<String> places() {
    return List.of("region_x0", "region_x1", "region_y0", "region_y1");
  }

  @Override
  public Optional<Area> reach() {
    return Optional.of(new Area(x0, x1, y0, y1));
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
