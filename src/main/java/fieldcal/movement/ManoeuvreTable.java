package fieldcal.movement;

import java.util.Map;
import java.util.TreeMap;

/**
 * Manoeuvres of one kind, counted in cells of acceleration, its relative error, speed, and direction against the robot's front. Cells are fine enough that nothing is lost for the limit, and integers, so
 * that tables merge exactly and in any order. Only cells that hold something take room.
 */
final class ManoeuvreTable {
  /** Less is a correction, not a manoeuvre, m/s². */
  static final double WEAKEST = 0.3;

  private static final double STRONGEST = 25;

  /** Half a per cent: bins add 0.15 % to the scatter of a manoeuvre. */
  private static final double LOG_STEP = 0.005;

  /** Relative errors beyond say nothing; … */
  private static final double WORST_ERROR = 0.2;

  /** … those below are not told apart. */
  private static final double BEST_ERROR = 0.002;

  /** Classes of relative errors, each a quarter larger than the one before. */
  private static final double ERROR_STEP = Math.log(1.25);

  private static final int ERROR_CLASSES =
      1 + (int) Math.ceil(Math.log(WORST_ERROR / BEST_ERROR) / ERROR_STEP);

  private static final double SPEED_STEP = 0.125;
  private static final int SPEEDS = 64;
  private static final int DIRECTIONS = 10;

  private final TreeMap<Integer, Integer> cells = new TreeMap<>();
  private long samples;

  /** What the limit search reads: one row per cell that holds something. */
  record Columns(
      double[] acceleration, double[] error, double[] speed, double[] sine2, double[] count) {

    /** What the accelerations would be along the front, if they are smaller aside by a known coefficient; NaN where the direction is unknown. */
    Columns alongFront(double coefficient) {
      double[] a = acceleration.clone();
      double[] e = error.clone();
      for (int i = 0; i < a.length; i++) {
        double part = 1 - coefficient * sine2[i];
        a[i] /= part;
        e[i] /= part;
      }
      return new Columns(a, e, speed, sine2, count);
    }
  }

  /**
   * Counts a manoeuvre.
   *
   * @param sine2 squared sine of the angle between acceleration and front; NaN when unknown
   * @return false when it is too weak or too uncertain to say anything
   */
  boolean add(double acceleration, double error, double speed, double sine2) {
    double relative = error / acceleration;
    if (!(acceleration >= WEAKEST && acceleration < STRONGEST) || !(relative <= WORST_ERROR)) {
      return false;
    }
    int a = (int) (Math.log(acceleration / WEAKEST) / LOG_STEP);
    int e = (int) Math.max(0, Math.ceil(Math.log(relative / BEST_ERROR) / ERROR_STEP));
    int v = (int) Math.min(SPEEDS - 1, speed / SPEED_STEP);
    int s = sine2 >= 0 ? (int) Math.min(DIRECTIONS - 1, sine2 * DIRECTIONS) : DIRECTIONS;
    int key = ((a * ERROR_CLASSES + e) * SPEEDS + v) * (DIRECTIONS + 1) + s;
    cells.merge(key, 1, Integer::sum);
    samples++;
    return true;
  }

  void merge(ManoeuvreTable other) {
    other.cells.forEach((key, count) -> cells.merge(key, count, Integer::sum));
    samples += other.samples;
  }

  /** Tells each cell that holds something, with its acceleration and its speed. */
  void cells(MovementCells.Sink sink) {
    Columns columns = columns();
    int i = 0;
    for (Map.Entry<Integer, Integer> cell : cells.entrySet()) {
      sink.cell(cell.getKey(), columns.acceleration[i], columns.speed[i], cell.getValue());
      i++;
    }
  }

  /** Adds what {@link #cells} told; false when there is no such cell. */
  boolean addCell(int cell, long count) {
    int strongest = (int) (Math.log(STRONGEST / WEAKEST) / LOG_STEP);
    int all = (strongest + 1) * ERROR_CLASSES * SPEEDS * (DIRECTIONS + 1);
    if (cell < 0 || cell >= all || count < 0 || count > Integer.MAX_VALUE) {
      return false;
    }
    cells.merge(cell, (int) count, Math::addExact);
    samples += count;
    return true;
  }

  void clear() {
    cells.clear();
    samples = 0;
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
      c.acceleration[i] = WEAKEST * Math.exp((a + 0.5) * LOG_STEP);
      c.error[i] = BEST_ERROR * Math.exp((e - 0.5) * ERROR_STEP) * c.acceleration[i];
      c.speed[i] = (v + 0.5) * SPEED_STEP;
      c.sine2[i] = s == DIRECTIONS ? Double.NaN : (s + 0.5) / DIRECTIONS;
      c.count[i] = cell.getValue();
      i++;
    }
    return c;
  }
}
