package fieldcal.effect;

import fieldcal.effect.MotionEffect.FrictionZone;

/** Where the last piece of a path crosses the edge of a zone, or a line. */
final class ZoneEdge {
  /** Zones are looked for along chords of at most this duration, s: what lies between chord and path is less than a tenth of a millimetre wide. */
  private static final double CHORD = 0.1;

  private static final double TINY = 1e-12;

  private ZoneEdge() {}

  /** Time into the path's last piece at which an edge is met, by bisection; infinite when none is. */
  static double timeInto(Path path, FrictionZone zone, boolean within, double step) {
    int chords = 1 + (int) (step / CHORD);
    double x0 = path.lastPosition(0, 0);
    double y0 = path.lastPosition(1, 0);
    for (int j = 0; j < chords; j++) {
      double next = (j + 1.0) / chords;
      double x1 = path.lastPosition(0, next);
      double y1 = path.lastPosition(1, next);
      double share = zone.otherSide(within, x0, y0, x1, y1);
      if (share <= 1) {
        double before = (double) j / chords;
        double after = share < 1 ? shareAtChord(path, share, before, next) : next;
        while ((after - before) * step > TINY) {
          double middle = 0.5 * (before + after);
          if (zone.contains(path.lastPosition(0, middle), path.lastPosition(1, middle)) == within) {
            before = middle;
          } else {
            after = middle;
          }
        }
        return after * step;
      }
      x0 = x1;
      y0 = y1;
    }
    return Double.POSITIVE_INFINITY;
  }

  /** Time into the path's last piece at which a line is crossed, by bisection; infinite when it is not. */
  static double timeOver(Path path, MotionEffects effects, int line, boolean beyond, double step) {
    int chords = 1 + (int) (step / CHORD);
    for (int j = 1; j <= chords; j++) {
      double after = (double) j / chords;
      if (isBeyond(path, effects, line, after) != beyond) {
        double before = (j - 1.0) / chords;
        while ((after - before) * step > TINY) {
          double middle = 0.5 * (before + after);
          if (isBeyond(path, effects, line, middle) == beyond) {
            before = middle;
          } else {
            after = middle;
          }
        }
        return after * step;
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  private static boolean isBeyond(Path path, MotionEffects effects, int line, double share) {
    return effects.isBeyond(line, path.lastPosition(0, share), path.lastPosition(1, share));
  }

  /** The share of the path's last piece at which a ball has made a share of the way along a chord. */
  private static double shareAtChord(Path path, double share, double from, double to) {
    double x0 = path.lastPosition(0, from);
    double y0 = path.lastPosition(1, from);
    double dx = path.lastPosition(0, to) - x0;
    double dy = path.lastPosition(1, to) - y0;
    double wanted = share * (dx * dx + dy * dy);
    double low = from;
    double high = to;
    while (high - low > TINY) {
      double s = 0.5 * (low + high);
      if (dx * (path.lastPosition(0, s) - x0) + dy * (path.lastPosition(1, s) - y0) < wanted) {
        low = s;
      } else {
        high = s;
      }
    }
    return high;
  }
}
