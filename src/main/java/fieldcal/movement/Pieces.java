package fieldcal.movement;

import java.util.Arrays;

/**
 * Cuts a stretch of a robot's path into pieces of constant acceleration: the cut with the least sum of squared residuals plus a penalty per piece, found exactly by dynamic programming over a
 * grid of {@link #CELL}.
 *
 * <p>Each piece is a parabola of its own, with one constant for each camera, so that cameras may disagree about where the robot is. With the sums of powers up to each edge of a cell, a piece's residual needs only one 2×2 system.
 */
final class Pieces {
  /** The shortest piece that can be distinguished from noise, s. */
  static final double SHORTEST_TOLD = 0.12;

  /** Distance of possible knots, s. */
  static final double CELL = SHORTEST_TOLD / 3;

  static final int MAX_CELLS = 150;

  /** Least length of a piece that is to be measured, in cells. */
  private static final int SHORTEST = 2;

  /**
   * Penalty of one more piece in units of the noise's variance, for one and for two dimensions. Six numbers of a parabola in the plane take 6 on average out of noise alone, and 99.99 % of the time less than 28; three numbers
   * less than 21 (χ²).
   */
  private static final double[] PRICES = {21, 28};

  /** Sums over the detections of a camera before each cell edge. */
  private final double[][][] sums = new double[Stretch.CAMERAS][MAX_CELLS + 1][PathSums.SUMS];

  private final double[] best = new double[MAX_CELLS + 1];
  private final int[] from = new int[MAX_CELLS + 1];
  private final double[] knots = new double[MAX_CELLS + 1];

  /** Edges at which the last piece may begin, in their order. */
  private final int[] candidate = new int[MAX_CELLS + 1];

  /** Of each such edge: what is reached with a last piece from there on, without its penalty; and the last edge at which it may end. */
  private final double[] reached = new double[MAX_CELLS + 1];

  private final int[] lastEnd = new int[MAX_CELLS + 1];
  private final boolean plane;
  private final double price;
  private int candidates;
  private int count;
  private int cameras;

  /** Cuts paths of one or two dimensions; in one dimension, y must be 0. */
  Pieces(int dimensions) {
    plane = dimensions == 2;
    price = PRICES[dimensions - 1];
  }

  /** Number of pieces; piece i lasts from {@code knot(i)} to {@code knot(i + 1)}. */
  int count() {
    return count;
  }

  /** Penalty of one more piece, in variances of the noise. */
  double price() {
    return price;
  }

  /** Relative time of a knot, s. */
  double knot(int i) {
    return knots[i];
  }

  /** Cuts a stretch. */
  void cut(Stretch stretch, double variance) {
    int cells = Math.min(MAX_CELLS, (int) Math.ceil(stretch.span() / CELL + 1e-9));
    count = 0;
    if (cells < 1) {
      return;
    }
    accumulate(stretch, cells);
    best[0] = 0;
    candidates = 0;
    for (int to = 1; to <= cells; to++) {
      candidate[candidates++] = to - 1;
      lastEnd[to - 1] = cells;
      findBest(to, cells, variance);
      dropBeaten(to);
    }
    for (int at = cells; at > 0; at = from[at]) {
      count++;
    }
    int i = count;
    knots[i] = cells * CELL;
    for (int at = cells; at > 0; at = from[at]) {
      knots[--i] = from[at] * CELL;
    }
  }

  /** The best cut of all cells before an edge. */
  private void findBest(int to, int cells, double variance) {
    best[to] = Double.POSITIVE_INFINITY;
    for (int k = 0; k < candidates; k++) {
      int start = candidate[k];
      reached[start] = best[start];
      boolean tooShort = to - start < SHORTEST && start > 0 && to < cells;
      if (tooShort || best[start] >= best[to]) {
        continue;
      }
      reached[start] += residual(start, to) / variance;
      if (reached[start] + price < best[to]) {
        best[to] = reached[start] + price;
        from[to] = start;
      }
    }
  }

  /**
   * Drops the starts of pieces that no longer matter: if the best cut up to here costs no more than one whose last piece begins there and lasts until here, then a piece that goes on from there costs no less than one that begins here, since two parabolas fit no worse than one
   * (pruned exact linear time, Killick, Fearnhead and Eckley 2012). One that begins here may end only {@link #SHORTEST} cells later, so until then both are kept.
   */
  private void dropBeaten(int to) {
    int kept = 0;
    for (int k = 0; k < candidates; k++) {
      int start = candidate[k];
      if (reached[start] >= best[to]) {
        lastEnd[start] = Math.min(lastEnd[start], to + SHORTEST - 1);
      }
      if (lastEnd[start] > to) {
        candidate[kept++] = start;
      }
    }
    candidates = kept;
  }

  private void accumulate(Stretch s, int cells) {
    cameras = s.cameras();
    for (int c = 0; c < cameras; c++) {
      Arrays.fill(sums[c][0], 0);
    }
    int i = 0;
    for (int cell = 1; cell <= cells; cell++) {
      for (int c = 0; c < cameras; c++) {
        System.arraycopy(sums[c][cell - 1], 0, sums[c][cell], 0, PathSums.SUMS);
      }
      double end = cell == cells ? Double.POSITIVE_INFINITY : cell * CELL;
      for (; i < s.size() && s.t[i] < end; i++) {
        PathSums.add(sums[s.camera[i]][cell], 0, s.t[i], s.x[i], s.y[i]);
      }
    }
  }

  /** Sum of squared residuals of the best parabola over cells [start, to), in m². */
  double residual(int start, int to) {
    double s11 = 0;
    double s12 = 0;
    double s22 = 0;
    double bx1 = 0;
    double bx2 = 0;
    double by1 = 0;
    double by2 = 0;
    double rest = 0;
    for (int c = 0; c < cameras; c++) {
      double[] a = sums[c][start];
      double[] b = sums[c][to];
      double n = b[0] - a[0];
      if (n < 2) {
        continue; // one detection is explained by its camera's own constant
      }
      double perDetection = 1 / n;
      double t1 = b[1] - a[1];
      double t2 = b[2] - a[2];
      double m1 = t1 * perDetection;
      double m2 = t2 * perDetection;
      s11 += t2 - t1 * m1;
      s12 += b[3] - a[3] - t1 * m2;
      s22 += b[4] - a[4] - t2 * m2;
      double x0 = b[5] - a[5];
      bx1 += b[6] - a[6] - x0 * m1;
      bx2 += b[7] - a[7] - x0 * m2;
      rest += b[8] - a[8] - x0 * x0 * perDetection;
      if (plane) {
        double y0 = b[9] - a[9];
        by1 += b[10] - a[10] - y0 * m1;
        by2 += b[11] - a[11] - y0 * m2;
        rest += b[12] - a[12] - y0 * y0 * perDetection;
      }
    }
    double determinant = s11 * s22 - s12 * s12;
    if (s11 <= 0) {
      return Math.max(0, rest);
    }
    if (determinant <= 1e-9 * s11 * s22) {
      return Math.max(0, rest - (bx1 * bx1 + by1 * by1) / s11);
    }
    double explained =
        s22 * (bx1 * bx1 + by1 * by1)
            - 2 * s12 * (bx1 * bx2 + by1 * by2)
            + s11 * (bx2 * bx2 + by2 * by2);
    return Math.max(0, rest - explained / determinant);
  }
}
