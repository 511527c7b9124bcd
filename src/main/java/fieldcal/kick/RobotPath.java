package fieldcal.kick;

import fieldcal.vision.RobotId;

/**
 * Where one camera saw one robot in the last third of a second: a ring, since a kick is noticed a tenth of a second late and a contact is judged afterwards.
 *
 * <p>Two robots that swap their numbers for some frames make the path jump; nothing is interpolated across a jump, so a place is always one where some robot stood.
 */
final class RobotPath {
  /** A robot that was not seen for longer may be anywhere, s. */
  private static final double FORGET = 0.6;

  /** No robot is faster: more is a swapped number, m/s. */
  private static final double MAX_SPEED = 6;

  /** Within this time before and after, a robot's velocity hardly changes, s. */
  private static final double SMOOTH = 0.1;

  /** Fewer detections give no velocity. */
  private static final int FEWEST = 4;

  /** A metre plus what a robot drives in the time that is remembered, m. */
  private static final double WIDE = 3;

  private static final int CAPACITY = 32;

  private final RobotId robot;
  private final double[] time = new double[CAPACITY];
  private final double[] x = new double[CAPACITY];
  private final double[] y = new double[CAPACITY];
  private final double[] orientation = new double[CAPACITY];
  private final LineFit line = new LineFit();
  private int count;

  RobotPath(RobotId robot) {
    this.robot = robot;
  }

  RobotId robot() {
    return robot;
  }

  void add(double t, double px, double py, double front) {
    int i = count++ % CAPACITY;
    if (count == 2 * CAPACITY) {
      // The ring is full either way; a running number would overflow within a season.
      count = CAPACITY;
    }
    time[i] = t;
    x[i] = px;
    y[i] = py;
    orientation[i] = front;
  }

  private int slot(int age) {
    return Math.floorMod(count - 1 - age, CAPACITY);
  }

  private int size() {
    return Math.min(count, CAPACITY);
  }

  /** The detection nearest in time to {@code t}; −1 when that is too long ago. */
  private int nearest(double t) {
    int age = 0;
    while (age + 1 < size() && Math.abs(time[slot(age + 1)] - t) <= Math.abs(time[slot(age)] - t)) {
      age++;
    }
    return count > 0 && Math.abs(time[slot(age)] - t) < FORGET ? age : -1;
  }

  /** A quick check of whether the robot can have been within a metre of a place lately. */
  boolean mayHaveBeenNear(double px, double py) {
    int i = slot(0);
    return Math.abs(px - x[i]) < WIDE && Math.abs(py - y[i]) < WIDE;
  }

  /** Whether it was seen around a time often enough to know where it was and how fast it moved: not at the edge of the camera's view, not long ago. */
  boolean knows(double t) {
    int age = nearest(t);
    if (age < 0 || Math.abs(time[slot(age)] - t) > SMOOTH) {
      return false;
    }
    collect(age, t);
    return line.count() >= FEWEST;
  }

  /** Where its front pointed at a time, rad; NaN when vision does not report it. Ask {@link #at} first. */
  double orientation(double t) {
    int age = nearest(t);
    return age < 0 ? Double.NaN : orientation[slot(age)];
  }

  /**
   * Place and velocity at a time.
   *
   * @param t s
   * @param state gets x, y (m), vx, vy (m/s)
   * @return false when the robot was not seen around that time
   */
  boolean at(double t, double[] state) {
    int age = nearest(t);
    if (age < 0) {
      return false;
    }
    int seen = slot(age);
    collect(age, t);
    boolean moves = line.count() >= FEWEST && line.solve();
    state[2] = moves ? line.vx() : 0;
    state[3] = moves ? line.vy() : 0;
    double ahead = Math.max(-SMOOTH, Math.min(SMOOTH, t - time[seen]));
    state[0] = x[seen] + state[2] * ahead;
    state[1] = y[seen] + state[3] * ahead;
    return true;
  }

  /** What was seen around a time without a jump in between. */
  private void collect(int nearest, double t) {
    int seen = slot(nearest);
    line.clear(time[seen]);
    line.add(time[seen], x[seen], y[seen]);
    for (int a = nearest + 1; a < size() && joined(a, a - 1) && t - time[slot(a)] < SMOOTH; a++) {
      line.add(time[slot(a)], x[slot(a)], y[slot(a)]);
    }
    for (int a = nearest - 1; a >= 0 && joined(a + 1, a) && time[slot(a)] - t < SMOOTH; a--) {
      line.add(time[slot(a)], x[slot(a)], y[slot(a)]);
    }
  }

  /** Whether a robot can have driven from one detection to the next. */
  private boolean joined(int older, int newer) {
    int a = slot(older);
    int b = slot(newer);
    double dt = time[b] - time[a];
    double dx = x[b] - x[a];
    double dy = y[b] - y[a];
    double most = Math.max(0, 0.03 + MAX_SPEED * dt);
    return dt < FORGET && dx * dx + dy * dy < most * most;
  }
}
