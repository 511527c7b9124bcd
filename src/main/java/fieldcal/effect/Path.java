package fieldcal.effect;

import fieldcal.ball.Phase;
import java.util.Arrays;

/**
 * The pieces of an integrated path, in columns. In each piece a coordinate is a polynomial of fifth degree in the elapsed share of the piece that has
 * the integrator's position, velocity and acceleration at both ends (quintic Hermite interpolation): exact for constant acceleration. Filled
 * by the integrator, not changed afterwards.
 */
final class Path {
  private static final int PER_AXIS = 6;
  private static final int STRIDE = 3 * PER_AXIS;

  /** Longest piece over which Simpson's rule integrates the speed at once, s. */
  private static final double PANEL = 0.1;

  private static final int PANELS_AT_TURN = 64;

  private int count;
  private double[] start;
  private double[] duration;
  private double[] coefficients;
  private Phase[] phases;

  /** Lengths before each piece, m; computed when first asked for, because fits never do. Threads that compute them at the same time get the same. */
  private volatile double[] ways;

  Path(int capacity) {
    start = new double[capacity];
    duration = new double[capacity];
    phases = new Phase[capacity];
    coefficients = new double[capacity * STRIDE];
  }

  /** Adds a piece; states are x, y, z, vx, vy, vz and so on, rates their derivatives. */
  void add(
      Phase phase,
      double at,
      double h,
      double[] from,
      double[] rate0,
      double[] to,
      double[] rate1) {
    if (count == start.length) {
      grow();
    }
    start[count] = at;
    duration[count] = h;
    phases[count] = phase;
    // On the carpet nothing is asked of the height.
    int axes = phase == Phase.FLYING ? 3 : 2;
    double half = 0.5 * h * h;
    for (int axis = 0; axis < axes; axis++) {
      int c = count * STRIDE + axis * PER_AXIS;
      double p = from[axis];
      double v = from[axis + 3] * h;
      double a = half * rate0[axis + 3];
      double d = to[axis] - p - v - a;
      double e = to[axis + 3] * h - v - 2 * a;
      double f = half * rate1[axis + 3] - a;
      coefficients[c] = p;
      coefficients[c + 1] = v;
      coefficients[c + 2] = a;
      coefficients[c + 3] = 10 * d - 4 * e + f;
      coefficients[c + 4] = -15 * d + 7 * e - 2 * f;
      coefficients[c + 5] = 6 * d - 3 * e + f;
    }
    count++;
  }

  /** Takes the last piece away again. */
  void dropLast() {
    count--;
  }

  /** A coordinate of the piece added last, after a share of it. */
  double lastPosition(int axis, double s) {
    return position(count - 1, axis, s);
  }

  private void grow() {
    int capacity = 2 * start.length;
    start = Arrays.copyOf(start, capacity);
    duration = Arrays.copyOf(duration, capacity);
    phases = Arrays.copyOf(phases, capacity);
    coefficients = Arrays.copyOf(coefficients, capacity * STRIDE);
  }

  int count() {
    return count;
  }

  Phase phase(int i) {
    return phases[i];
  }

  double start(int i) {
    return start[i];
  }

  double duration(int i) {
    return duration[i];
  }

  double end() {
    return count == 0 ? Double.NaN : start[count - 1] + duration[count - 1];
  }

  /** Length over the ground of all pieces before the i-th. */
  double wayBefore(int i) {
    return ways()[i];
  }

  private double[] ways() {
    double[] known = ways;
    if (known == null) {
      known = new double[count + 1];
      for (int i = 0; i < count; i++) {
        known[i + 1] = known[i] + length(i, 1);
      }
      ways = known;
    }
    return known;
  }

  /** The last piece that begins at or before a time. */
  int indexAt(double t) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (start[middle] <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  /** The same, looked for from a piece that is near it. */
  int indexAt(double t, int near) {
    int i = near;
    while (i > 0 && start[i] > t) {
      i--;
    }
    while (i < count - 1 && start[i + 1] <= t) {
      i++;
    }
    return i;
  }

  /** The elapsed share of a piece at a time. */
  double share(int i, double t) {
    return Math.min(1, (t - start[i]) / duration[i]);
  }

  double position(int i, int axis, double s) {
    double[] k = coefficients;
    int c = i * STRIDE + axis * PER_AXIS;
    return k[c] + s * (k[c + 1] + s * (k[c + 2] + s * (k[c + 3] + s * (k[c + 4] + s * k[c + 5]))));
  }

  /** Height of the ball, m; 0 on the carpet, where the pieces have no height. */
  double height(int i, double s) {
    return phases[i] == Phase.FLYING ? Math.max(0, position(i, 2, s)) : 0;
  }

  double velocity(int i, int axis, double s) {
    double[] k = coefficients;
    int c = i * STRIDE + axis * PER_AXIS;
    double perShare =
        k[c + 1] + s * (2 * k[c + 2] + s * (3 * k[c + 3] + s * (4 * k[c + 4] + s * 5 * k[c + 5])));
    return perShare / duration[i];
  }

  /** Length over the ground of the first share of a piece, m. */
  double length(int i, double share) {
    double span = share * duration[i];
    double turning =
        velocity(i, 0, 0) * velocity(i, 0, share) + velocity(i, 1, 0) * velocity(i, 1, share);
    int panels = turning < 0 ? PANELS_AT_TURN : 1 + (int) (span / PANEL);
    double step = share / panels;
    double sum = groundSpeed(i, 0) - groundSpeed(i, share);
    for (int j = 1; j <= panels; j++) {
      sum += 4 * groundSpeed(i, (j - 0.5) * step) + 2 * groundSpeed(i, j * step);
    }
    return sum * span / (6 * panels);
  }

  double groundSpeed(int i, double s) {
    double vx = velocity(i, 0, s);
    double vy = velocity(i, 1, s);
    return Math.sqrt(vx * vx + vy * vy);
  }

  /** The share of a piece after which it has the given length; a safeguarded Newton iteration from where a ball of constant deceleration would be. */
  double shareAtLength(int i, double length) {
    double low = 0;
    double high = 1;
    double total = wayBefore(i + 1) - wayBefore(i);
    double s = total > 0 ? shareAtSteadyBraking(i, length / total) : 0;
    for (int round = 0; round < 60; round++) {
      double miss = length(i, s) - length;
      if (miss > 0) {
        high = s;
      } else {
        low = s;
      }
      double next = s - miss / (groundSpeed(i, s) * duration[i]);
      if (!(next >= low && next <= high)) {
        next = 0.5 * (low + high);
      }
      // The error that is left is about the square of this step.
      if (Math.abs(next - s) * duration[i] < 1e-7) {
        return next;
      }
      s = next;
    }
    return s;
  }

  /** The share of the time after which that share of the way is done, if the speed changed evenly. */
  private double shareAtSteadyBraking(int i, double way) {
    double begin = groundSpeed(i, 0);
    double end = groundSpeed(i, 1);
    double there = Math.sqrt(begin * begin + (end * end - begin * begin) * way);
    double s = way * (begin + end) / (begin + there);
    return s <= 1 ? s : 1;
  }
}
