package fieldcal.movement;

import java.util.Arrays;

/**
 * One robot's detections of the last seconds, of all cameras, in the order of their times. Structure of arrays, made once: a frame allocates nothing.
 *
 * <p>Positions and times count from the first detection after {@link #clear}, so that sums of powers keep their digits.
 */
final class Stretch {
  /** Four cameras at 75 Hz for five seconds; when more see the robot, the stretch is analysed earlier. */
  static final int CAPACITY = 1536;

  /** Largest number of cameras that see one robot at once. */
  static final int CAMERAS = 8;

  final double[] t = new double[CAPACITY];
  final double[] x = new double[CAPACITY];
  final double[] y = new double[CAPACITY];
  final double[] orientation = new double[CAPACITY];

  /** Index into the cameras of this stretch, not the camera's number. */
  final int[] camera = new int[CAPACITY];

  private final int[] cameraIds = new int[CAMERAS];
  private int cameras;
  private int size;
  private double baseTime;
  private double baseX;
  private double baseY;

  int size() {
    return size;
  }

  int cameras() {
    return cameras;
  }

  boolean full() {
    return size == CAPACITY;
  }

  /** Time of the first detection, s since the recording's epoch. */
  double baseTime() {
    return baseTime;
  }

  /** Time from the first detection to the last, s. */
  double span() {
    return size == 0 ? 0 : t[size - 1] - t[0];
  }

  /** Range of x, m or rad. */
  double extent() {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      low = Math.min(low, x[i]);
      high = Math.max(high, x[i]);
    }
    return high - low;
  }

  void clear() {
    size = 0;
    cameras = 0;
  }

  /** Adds a detection where its time puts it; nothing is added when the stretch is full or too many cameras see the robot. */
  void add(double time, double px, double py, double angle, int cameraId) {
    if (size == 0) {
      baseTime = time;
      baseX = px;
      baseY = py;
      cameras = 0;
    }
    int index = cameraIndex(cameraId);
    if (index < 0 || full()) {
      return;
    }
    double relative = time - baseTime;
    int i = size;
    // Cameras are hardly ever in order by more than one frame.
    while (i > 0 && t[i - 1] > relative) {
      move(i - 1, i);
      i--;
    }
    t[i] = relative;
    x[i] = px - baseX;
    y[i] = py - baseY;
    orientation[i] = angle;
    camera[i] = index;
    size++;
  }

  private int cameraIndex(int id) {
    for (int i = 0; i < cameras; i++) {
      if (cameraIds[i] == id) {
        return i;
      }
    }
    if (cameras == CAMERAS) {
      return -1;
    }
    cameraIds[cameras] = id;
    return cameras++;
  }

  private void move(int from, int to) {
    t[to] = t[from];
    x[to] = x[from];
    y[to] = y[from];
    orientation[to] = orientation[from];
    camera[to] = camera[from];
  }

  /** The first detection at or after a relative time; {@link #size} if there is none. */
  int indexAt(double relative) {
    return indexAt(t, 0, size, relative);
  }

  /** The first of ascending times [from, to) that is not before another; {@code to} if there is none. */
  static int indexAt(double[] times, int from, int to, double time) {
    int low = from;
    int high = to;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (times[middle] < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Forgets what is earlier than a relative time, and counts from the first that is left. */
  void forgetBefore(double relative) {
    int first = indexAt(relative);
    if (first == 0) {
      return;
    }
    if (first == size) {
      clear();
      return;
    }
    double shiftT = t[first];
    double shiftX = x[first];
    double shiftY = y[first];
    int present = 0;
    int[] renamed = new int[CAMERAS];
    int[] ids = cameraIds.clone();
    Arrays.fill(renamed, -1);
    for (int i = first; i < size; i++) {
      int c = camera[i];
      if (renamed[c] < 0) {
        renamed[c] = present;
        cameraIds[present] = ids[c];
        present++;
      }
      t[i - first] = t[i] - shiftT;
      x[i - first] = x[i] - shiftX;
      y[i - first] = y[i] - shiftY;
      orientation[i - first] = orientation[i];
      camera[i - first] = renamed[c];
    }
    cameras = present;
    size -= first;
    baseTime += shiftT;
    baseX += shiftX;
    baseY += shiftY;
  }
}
