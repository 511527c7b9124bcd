package fieldcal.movement;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

/**
 * Manoeuvres of one kind, driven or turned, counted in cells of acceleration, its relative error, speed, and direction against the robot's front. Cells are so fine that the limit loses nothing. They count in integers, so
 * that tables merge exactly and in any order. Only cells that hold something take room.
 */
final class ManoeuvreTable {
  /** Width of a class of accelerations, as a logarithm: half a per cent, which adds 0.15 % to the scatter of a manoeuvre. */
  private static final double LOG_STEP = 0.005;

  /** Manoeuvres with larger relative errors determine no limit; … */
  private static final double WORST_ERROR = 0.2;

  /** … those below are not distinguished. */
  private static final double BEST_ERROR = 0.002;

  /** Classes of relative errors, each a quarter larger than the one before. */
  private static final double ERROR_STEP = Math.log(1.25);

  private static final int ERROR_CLASSES =
      1 + (int) Math.ceil(Math.log(WORST_ERROR / BEST_ERROR) / ERROR_STEP);

  private static final int SPEEDS = 64;

  /** Classes of 5° of the direction against the front; one more for those of unknown direction. */
  private static final int DIRECTIONS = 72;

  private static final double DIRECTION_STEP = 2 * Math.PI / DIRECTIONS;

  /** Standard error of a direction that is known to its class, rad: values are spread evenly over it. */
  static final double DIRECTION_ERROR = DIRECTION_STEP / Math.sqrt(12);

  private final Scale scale;
  private final TreeMap<Integer, Integer> cells = new TreeMap<>();
  private long samples;

  /**
   * What is counted.
   *
   * @param weakest less is a correction, not a manoeuvre
   * @param strongest nothing is stronger
   * @param speedStep width of a class of speeds
   */
  record Scale(double weakest, double strongest, double speedStep) {
    /** Of driving, m/s² and m/s. */
    static final Scale DRIVING = new Scale(0.3, 25, 0.125);

    /** Of turning, rad/s² and rad/s. */
    static final Scale TURNING = new Scale(3, 500, 1);

    /** Standard error of a speed that is known to its class. */
    double speedError() {
      return speedStep / Math.sqrt(12);
    }

    private int classes() {
      return 1 + (int) (Math.log(strongest / weakest) / LOG_STEP);
    }
  }

  ManoeuvreTable(Scale scale) {
    this.scale = scale;
  }

  /** What the limit search reads: one row per cell that holds something. */
  record Columns(
      double[] acceleration, double[] error, double[] speed, double[] direction, double[] count) {

    /** Size of the sine of the direction. */
    double[] sine() {
      return Arrays.stream(direction).map(phi -> Math.abs(Math.sin(phi))).toArray();
    }

    /** For what depends on neither speed nor direction: neighbouring rows that differ only in these become one, without speed and direction. Equal rows that are no neighbours remain: that only costs time. */
    Columns merged() {
      int n = count.length;
      double[] a = new double[n];
      double[] e = new double[n];
      double[] c = new double[n];
      int kept = 0;
      for (int i = 0; i < n; i++) {
        boolean same = kept > 0 && acceleration[i] == a[kept - 1] && error[i] == e[kept - 1];
        if (same) {
          c[kept - 1] += count[i];
        } else {
          a[kept] = acceleration[i];
          e[kept] = error[i];
          c[kept] = count[i];
          kept++;
        }
      }
      double[] unknown = new double[kept];
      Arrays.fill(unknown, Double.NaN);
      return new Columns(
          Arrays.copyOf(a, kept), Arrays.copyOf(e, kept), unknown, unknown, Arrays.copyOf(c, kept));
    }

    /** What the accelerations would be without factors that are known; NaN where a factor is. */
    Columns without(double[] factor) {
      double[] a = acceleration.clone();
      double[] e = error.clone();
      for (int i = 0; i < a.length; i++) {
        a[i] /= factor[i];
        e[i] /= factor[i];
      }
      return new Columns(a, e, speed, direction, count);
    }

    /** The same where a factor is known only to a relative standard error, which adds to that of each manoeuvre. */
    Columns without(double[] factor, double[] blur) {
      Columns sharp = without(factor);
      double[] e = sharp.error.clone();
      for (int i = 0; i < e.length; i++) {
        e[i] = Math.hypot(e[i], blur[i] * sharp.acceleration[i]);
      }
      return new Columns(sharp.acceleration, e, speed, direction, count);
    }
  }

  /**
   * Counts a manoeuvre.
   *
   * @param direction of the acceleration against the front, rad, positive to the left; NaN when unknown
   * @return false when it is too weak or too uncertain to count
   */
  boolean add(double acceleration, double error, double speed, double direction) {
    double relative = error / acceleration;
    boolean manoeuvre = acceleration >= scale.weakest() && acceleration < scale.strongest();
    if (!manoeuvre || !(relative <= WORST_ERROR)) {
      return false;
    }
    int a = (int) (Math.log(acceleration / scale.weakest()) / LOG_STEP);
    int e = (int) Math.max(0, Math.ceil(Math.log(relative / BEST_ERROR) / ERROR_STEP));
    int v = (int) Math.min(SPEEDS - 1, speed / scale.speedStep());
    int s =
        Double.isFinite(direction)
            ? Math.floorMod((int) Math.floor(direction / DIRECTION_STEP), DIRECTIONS)
            : DIRECTIONS;
    int key = ((a * ERROR_CLASSES + e) * SPEEDS + v) * (DIRECTIONS + 1) + s;
    cells.merge(key, 1, Integer::sum);
    samples++;
    return true;
  }

  void merge(ManoeuvreTable other) {
    other.cells.forEach((key, count) -> cells.merge(key, count, Integer::sum));
    samples += other.samples;
  }

  /** Reports each cell that is not empty, with its acceleration and its speed. */
  void cells(MovementCells.Sink sink) {
    Columns columns = columns();
    int i = 0;
    for (Map.Entry<Integer, Integer> cell : cells.entrySet()) {
      sink.cell(cell.getKey(), columns.acceleration[i], columns.speed[i], cell.getValue());
      i++;
    }
  }

  /** Adds what {@link #cells} reported; false when there is no such cell. */
  boolean addCell(int cell, long count) {
    int all = scale.classes() * ERROR_CLASSES * SPEEDS * (DIRECTIONS + 1);
    if (cell < 0 || cell >= all || count < 0 || count > Integer.MAX_VALUE) {
      return false;
    }
    cells.merge(cell, (int) count, Math::addExact);
    samples += count;
    return true;
  }

  long samples() {
    return samples;
  }

  /** All cells, in the order of their acceleration. */
  Columns columns() {
    int n = cells.size();
    Columns c =
        new Columns(new double[n], new double[n], new double[n], new double[n], new double[n]);
    int i = 0;
    for (Map.Entry<Integer, Integer> cell : cells.entrySet()) {
      int key = cell.getKey();
      int s = key % (DIRECTIONS + 1);
      key /= DIRECTIONS + 1;
      int v = key % SPEEDS;
      key /= SPEEDS;
      int e = key % ERROR_CLASSES;
      int a = key / ERROR_CLASSES;
      c.acceleration[i] = scale.weakest() * Math.exp((a + 0.5) * LOG_STEP);
      c.error[i] = BEST_ERROR * Math.exp((e - 0.5) * ERROR_STEP) * c.acceleration[i];
      c.speed[i] = (v + 0.5) * scale.speedStep();
      c.direction[i] = s == DIRECTIONS ? Double.NaN : (s + 0.5) * DIRECTION_STEP;
      c.count[i] = cell.getValue();
      i++;
    }
    return c;
  }
}
