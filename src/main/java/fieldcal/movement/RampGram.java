package fieldcal.movement;

import java.util.Arrays;

/**
 * Sums of the products of the functions of time that a {@link RampFit} consists of, and of the positions that they are to explain, over the detections of all cameras; a constant for each camera is projected out.
 *
 * <p>Within the width of a corner the functions are cubic, and detections are added one by one. Between the corners they are of second degree, and come from {@link PathSums} at once. For one thread.
 */
final class RampGram {
  // Functions that are zero before the first knot come after the others, and those that are zero
  // before the second knot come last.
  static final int X = 0;
  static final int Y = 1;
  static final int T = 2;
  static final int T2 = 3; // t²/2
  static final int Q1 = 4; // (t−τ1)²/2, rounded
  static final int R1 = 5; // minus its derivative by the knot
  static final int K1 = 6; // its derivative by the rounding
  static final int Q2 = 7;
  static final int R2 = 8;
  static final int K2 = 9;
  static final int ALL = 10;

  private final PathSums path = new PathSums();
  private final double[][] gram = new double[ALL][ALL];
  private final double[] sums = new double[ALL];
  private final double[] f = new double[ALL];

  /** The functions between the corners as sums of 1, t and t²/2. */
  private final double[][] polynomial = new double[ALL][3];

  private final double[][] products = new double[PathSums.BASIS][PathSums.BASIS];
  private final double[] withBasis = new double[PathSums.BASIS];
  private Corner first;
  private Corner second;
  private int cameras;
  private int samples;

  /**
   * Where the acceleration changes.
   *
   * @param knot relative time, s
   * @param width time in which it changes evenly, s
   * @param more by how much its rounding exceeds that of the width, s²
   */
  record Corner(double knot, double width, double more) {
    double begin() {
      return knot - 0.5 * width;
    }

    double end() {
      return knot + 0.5 * width;
    }
  }

  RampGram() {
    polynomial[T][1] = 1;
    polynomial[T2][2] = 1;
  }

  /** Takes detections [begin, end) of a stretch. */
  void read(Stretch s, int begin, int end) {
    path.read(s, begin, end);
    samples = end - begin;
    cameras = 0;
    for (int c = 0; c < Stretch.CAMERAS; c++) {
      cameras += path.begin(c + 1) > path.begin(c) ? 1 : 0;
    }
  }

  /** Detections. */
  int samples() {
    return samples;
  }

  /** Cameras that have some of them. */
  int cameras() {
    return cameras;
  }

  /** Sum of the products of two functions or coordinates; not of x with y. */
  double get(int j, int k) {
    return j < k ? gram[k][j] : gram[j][k];
  }

  /** Sums up with the corners at new places. */
  void accumulate(Corner atFirst, Corner atSecond) {
    first = atFirst;
    second = atSecond;
    double between = second.knot - first.knot;
    corner(Q1, 0, first);
    corner(Q2, between, second);
    for (double[] row : gram) {
      Arrays.fill(row, 0);
    }
    for (int c = 0; c < Stretch.CAMERAS; c++) {
      int n = path.begin(c + 1) - path.begin(c);
      if (n > 0) {
        Arrays.fill(sums, 0);
        add(c);
        for (int j = 0; j < ALL; j++) {
          for (int k = 0; k <= j; k++) {
            gram[j][k] -= sums[j] * sums[k] / n;
          }
        }
      }
    }
  }

  /** The polynomials after a corner that lies the given time after the first knot. */
  private void corner(int q, double later, Corner corner) {
    polynomial[q][0] = 0.5 * later * later + corner.width * corner.width / 24 + corner.more;
    polynomial[q][1] = -later;
    polynomial[q][2] = 1;
    polynomial[q + 1][0] = -later;
    polynomial[q + 1][1] = 1;
    polynomial[q + 2][0] = 1;
  }

  private void add(int camera) {
    int begin1 = path.indexAt(camera, first.begin());
    int begin2 = Math.max(begin1, path.indexAt(camera, second.begin()));
    int end1 = path.indexAt(camera, first.end());
    int end2 = Math.max(end1, path.indexAt(camera, second.end()));
    addRun(camera, path.begin(camera), begin1, Q1);
    addEach(begin1, Math.min(end1, begin2), Q2);
    addRun(camera, end1, begin2, Q2);
    addEach(begin2, end2, ALL);
    addRun(camera, Math.max(begin2, end2), path.begin(camera + 1), ALL);
  }

  /** Adds detections between corners; only the first {@code active} functions are not zero there. */
  private void addRun(int camera, int from, int to, int active) {
    if (from >= to) {
      return;
    }
    path.products(camera, from, to, first.knot, products);
    sums[X] += products[3][0];
    sums[Y] += products[4][0];
    gram[X][X] += products[3][3];
    gram[Y][Y] += products[4][4];
    for (int j = T; j < active; j++) {
      double[] p = polynomial[j];
      for (int k = 0; k < PathSums.BASIS; k++) {
        double[] row = products[k];
        withBasis[k] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
      }
      sums[j] += withBasis[0];
      double[] row = gram[j];
      row[X] += withBasis[3];
      row[Y] += withBasis[4];
      for (int k = T; k <= j; k++) {
        double[] q = polynomial[k];
        row[k] += withBasis[0] * q[0] + withBasis[1] * q[1] + withBasis[2] * q[2];
      }
    }
  }

  /** Adds detections within corners. */
  private void addEach(int from, int to, int active) {
    for (int i = from; i < to; i++) {
      double t = path.t(i) - first.knot;
      f[X] = path.x(i);
      f[Y] = path.y(i);
      f[T] = t;
      f[T2] = 0.5 * t * t;
      within(Q1, t, first);
      if (active > Q2) {
        within(Q2, path.t(i) - second.knot, second);
      }
      for (int j = 0; j < active; j++) {
        double value = f[j];
        double[] row = gram[j];
        sums[j] += value;
        for (int k = 0; k <= j; k++) {
          row[k] += value * f[k];
        }
      }
    }
  }

  /** The three functions of a corner: over its width the acceleration changes evenly; the part of the rounding that exceeds this is a step spread over the same time. */
  private void within(int q, double after, Corner corner) {
    double width = corner.width;
    double more = corner.more;
    double into = after + 0.5 * width;
    if (into < width) {
      f[q] = into * into * into / (6 * width) + more * into / width;
      f[q + 1] = 0.5 * into * into / width + more / width;
      f[q + 2] = into / width;
    } else {
      f[q] = 0.5 * after * after + width * width / 24 + more;
      f[q + 1] = after;
      f[q + 2] = 1;
    }
  }
}
