package fieldcal.movement;

import java.util.Arrays;

/**
 * The detections of a part of a path, ordered by camera, with sums of powers up to each of them. So the sum of any product of polynomials of time over a run of detections of one camera takes the same time however many these are.
 *
 * <p>Structure of arrays, made once. For one thread.
 */
final class PathSums {
  /** n, t, t², t³, t⁴, x, xt, xt², x², y, yt, yt², y². */
  static final int SUMS = 13;

  /** Number of functions whose {@link #products} are formed: 1, t, t²/2, x, y. */
  static final int BASIS = 5;

  private static final int TIME = 3;

  /** Factors of the powers of t in the basis. */
  private static final double[] FACTOR = {1, 1, 0.5};

  private static final int POWERS = 5;
  private static final int X = 5;
  private static final int Y = 9;

  private final double[] t = new double[Stretch.CAPACITY];
  private final double[] x = new double[Stretch.CAPACITY];
  private final double[] y = new double[Stretch.CAPACITY];

  /** The sums before the first detection of each camera, and after each detection. */
  private final double[] sums = new double[(Stretch.CAPACITY + Stretch.CAMERAS) * SUMS];

  /** Where the detections of each camera begin. */
  private final int[] begin = new int[Stretch.CAMERAS + 1];

  private final int[] next = new int[Stretch.CAMERAS];
  private final double[] powers = new double[POWERS];
  private final double[] ofX = new double[TIME];
  private final double[] ofY = new double[TIME];
  private double origin;

  /** Reads detections [first, last) of a stretch. */
  void read(Stretch s, int first, int last) {
    Arrays.fill(begin, 0);
    for (int i = first; i < last; i++) {
      begin[s.camera[i] + 1]++;
    }
    for (int c = 0; c < Stretch.CAMERAS; c++) {
      begin[c + 1] += begin[c];
      next[c] = begin[c];
    }
    // Counted from the middle, so that the powers keep their digits.
    int middle = (first + last) / 2;
    origin = first < last ? s.t[middle] : 0;
    for (int i = first; i < last; i++) {
      int k = next[s.camera[i]]++;
      t[k] = s.t[i];
      x[k] = s.x[i] - s.x[middle];
      y[k] = s.y[i] - s.y[middle];
    }
    for (int c = 0; c < Stretch.CAMERAS; c++) {
      int row = row(c, begin[c]);
      Arrays.fill(sums, row, row + SUMS, 0);
      for (int k = begin[c]; k < begin[c + 1]; k++) {
        System.arraycopy(sums, row, sums, row + SUMS, SUMS);
        row += SUMS;
        add(sums, row, t[k] - origin, x[k], y[k]);
      }
    }
  }

  /** Adds a detection to {@link #SUMS} sums from a place on. */
  static void add(double[] sums, int at, double t, double x, double y) {
    double tt = t * t;
    sums[at]++;
    sums[at + 1] += t;
    sums[at + 2] += tt;
    sums[at + 3] += tt * t;
    sums[at + 4] += tt * tt;
    sums[at + 5] += x;
    sums[at + 6] += x * t;
    sums[at + 7] += x * tt;
    sums[at + 8] += x * x;
    sums[at + 9] += y;
    sums[at + 10] += y * t;
    sums[at + 11] += y * tt;
    sums[at + 12] += y * y;
  }

  private static int row(int camera, int detection) {
    return (detection + camera) * SUMS;
  }

  /** Where the detections of a camera begin; those of the next camera follow. */
  int begin(int camera) {
    return begin[camera];
  }

  /** Relative time of a detection, s. */
  double t(int i) {
    return t[i];
  }

  double x(int i) {
    return x[i];
  }

  double y(int i) {
    return y[i];
  }

  /** The first detection of a camera at or after a relative time; where those of the next camera begin if there is none. */
  int indexAt(int camera, double relative) {
    return Stretch.indexAt(t, begin[camera], begin[camera + 1], relative);
  }

  /**
   * Sums of the products of 1, t, t²/2, x and y over detections [from, to) of a camera.
   *
   * @param zero from which t is counted, as a relative time
   * @param products becomes {@link #BASIS} rows of products with 1, t and t²/2, and the squares of x and y on the diagonal
   */
  void products(int camera, int from, int to, double zero, double[][] products) {
    int a = row(camera, from);
    int b = row(camera, to);
    for (int k = 0; k < POWERS; k++) {
      powers[k] = sums[b + k] - sums[a + k];
    }
    for (int k = 0; k < TIME; k++) {
      ofX[k] = sums[b + X + k] - sums[a + X + k];
      ofY[k] = sums[b + Y + k] - sums[a + Y + k];
    }
    double shift = zero - origin;
    shift(powers, shift);
    shift(ofX, shift);
    shift(ofY, shift);
    for (int j = 0; j < TIME; j++) {
      for (int k = 0; k < TIME; k++) {
        products[j][k] = FACTOR[j] * FACTOR[k] * powers[j + k];
      }
      products[TIME][j] = FACTOR[j] * ofX[j];
      products[TIME + 1][j] = FACTOR[j] * ofY[j];
    }
    products[TIME][TIME] = sums[b + X + TIME] - sums[a + X + TIME];
    products[TIME + 1][TIME + 1] = sums[b + Y + TIME] - sums[a + Y + TIME];
  }

  /** Makes sums of w·tᵏ those of w·(t − shift)ᵏ: each pass takes one more factor t out for one of t − shift. */
  private static void shift(double[] sums, double shift) {
    for (int pass = 1; pass < sums.length; pass++) {
      for (int k = sums.length - 1; k >= pass; k--) {
        sums[k] -= shift * sums[k - 1];
      }
    }
  }
}
