package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Area;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.Mosaic;
import fieldcal.effect.MotionEffect.FrictionZone;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

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

  /** Side of a tile of the places at which a search begins, m; chosen: a region of half this size still explains a quarter of what it does there, and the search then moves its bounds. */
  private static final double TILE = 1;

  /** Most tiles along a side. */
  private static final int MOST_TILES = 12;

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

  /** All rectangles of tiles, but for the one that contains everything: there the friction is the ball's own. */
  @Override
  public Optional<Mosaic> mosaic(Arena arena) {
    double[] x = cuts(arena.x0(), arena.x1(), x0, x1);
    double[] y = cuts(arena.y0(), arena.y1(), y0, y1);
    int columns = x.length - 1;
    int rows = y.length - 1;
    List<Effect> tiles = new ArrayList<>();
    List<Mosaic.Piece> pieces = new ArrayList<>();
    for (int i = 0; i < columns; i++) {
      for (int j = 0; j < rows; j++) {
        tiles.add(new WornRegion(0, x[i], x[i + 1], y[j], y[j + 1]));
        for (int k = i + 1; k <= columns; k++) {
          for (int l = j + 1; l <= rows; l++) {
            if (k - i < columns || l - j < rows) {
              pieces.add(
                  new Mosaic.Piece(
                      new WornRegion(0, x[i], x[k], y[j], y[l]), tilesOf(i, k, j, l, rows)));
            }
          }
        }
      }
    }
    return Optional.of(new Mosaic(tiles, pieces));
  }

  @Override
  public WornRegion within(Arena arena) {
    return new WornRegion(
        change,
        Math.max(x0, arena.x0() - MARGIN),
        Math.min(x1, arena.x1() + MARGIN),
        Math.max(y0, arena.y0() - MARGIN),
        Math.min(y1, arena.y1() + MARGIN));
  }

  /** Bounds of tiles, ascending: the given ones where they lie within, tiles of equal width between these, and the rim, which lies farther out. */
  private static double[] cuts(double from, double to, double... given) {
    int parts = (int) Math.max(2, Math.min(MOST_TILES, Math.round((to - from) / TILE)));
    double width = (to - from) / parts;
    double[] inner = Arrays.stream(given).filter(g -> g > from && g < to).distinct().toArray();
    DoubleStream even =
        IntStream.range(1, parts)
            .mapToDouble(i -> from + i * width)
            .filter(c -> Arrays.stream(inner).noneMatch(g -> Math.abs(g - c) < width / 2));
    DoubleStream all = DoubleStream.concat(Arrays.stream(inner), even);
    return DoubleStream.concat(DoubleStream.of(from - MARGIN, to + MARGIN), all).sorted().toArray();
  }

  private static List<Integer> tilesOf(int fromX, int toX, int fromY, int toY, int rows) {
    List<Integer> tiles = new ArrayList<>();
    for (int i = fromX; i < toX; i++) {
      for (int j = fromY; j < toY; j++) {
        tiles.add(i * rows + j);
      }
    }
    return tiles;
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
