package fieldcal.kick;

import fieldcal.vision.BallDetection;
import java.util.Arrays;

/**
 * The last second or two of what one camera saw of one ball: a ring of detections.
 *
 * <p>Per camera, because cameras disagree by centimetres and because an airborne ball is projected to different places by each.
 */
final class BallTrack {
  /** 160 detections are two seconds at 75 Hz: more than the rest that a kick keeps plus the delay of its detection. */
  private static final int CAPACITY = 160;

  /** Initial capacity, small because most are single false detections. */
  private static final int AT_FIRST = 4;

  private final int camera;
  private double[] time = new double[AT_FIRST];
  private double[] x = new double[AT_FIRST];
  private double[] y = new double[AT_FIRST];
  private double[] pixelX = new double[AT_FIRST];
  private double[] pixelY = new double[AT_FIRST];
  private int count;
  private int lastFrame;
  private final JumpDetector jumps = new JumpDetector();

  BallTrack(int camera) {
    this.camera = camera;
  }

  int camera() {
    return camera;
  }

  JumpDetector jumps() {
    return jumps;
  }

  void add(double t, BallDetection ball, int frame) {
    add(t, ball.x(), ball.y(), ball.pixelX(), ball.pixelY(), frame);
  }

  /** Takes over a detection of another track of this camera. */
  void add(BallTrack other, int age, int frame) {
    int i = other.slot(age);
    add(other.time[i], other.x[i], other.y[i], other.pixelX[i], other.pixelY[i], frame);
  }

  private void add(double t, double px, double py, double u, double v, int frame) {
    lastFrame = frame;
    if (count == time.length && count < CAPACITY) {
      grow();
    }
    int i = count++ % CAPACITY;
    time[i] = t;
    x[i] = px;
    y[i] = py;
    pixelX[i] = u;
    pixelY[i] = v;
  }

  private void grow() {
    int n = Math.min(CAPACITY, 4 * count);
    time = Arrays.copyOf(time, n);
    x = Arrays.copyOf(x, n);
    y = Arrays.copyOf(y, n);
    pixelX = Arrays.copyOf(pixelX, n);
    pixelY = Arrays.copyOf(pixelY, n);
  }

  /** How many detections are still held. */
  int size() {
    return Math.min(count, CAPACITY);
  }

  /** How many detections there ever were. */
  int total() {
    return count;
  }

  private int slot(int age) {
    return (count - 1 - age) % CAPACITY;
  }

  /** Capture time of the detection {@code age} places before the newest, s. */
  double time(int age) {
    return time[slot(age)];
  }

  double x(int age) {
    return x[slot(age)];
  }

  double y(int age) {
    return y[slot(age)];
  }

  /** The number of the camera's frame in which the ball was seen last. */
  int lastFrame() {
    return lastFrame;
  }

  double lastTime() {
    return time(0);
  }

  /** Fits a line to the detections of the given ages, {@code newest <= age <= oldest}. */
  boolean fit(int newest, int oldest, LineFit line) {
    line.clear(time(newest));
    for (int age = newest; age <= oldest; age++) {
      line.add(time(age), x(age), y(age));
    }
    return line.solve();
  }

  /** Fits a line to at most {@code most} newest detections that are at most {@code span} seconds older than the newest. */
  boolean fitNewest(int most, double span, LineFit line) {
    int oldest = 0;
    while (oldest + 1 < Math.min(most, size()) && lastTime() - time(oldest + 1) <= span) {
      oldest++;
    }
    return fit(0, oldest, line);
  }

  /** Where the camera reports, or would report, this ball at {@code t}; false when the track does not cover that time. */
  boolean positionAt(double t, double reach, LineFit scratch, double[] xy) {
    if (t > lastTime()) {
      if (t - lastTime() > reach || !fitNewest(6, 0.1, scratch)) {
        return false;
      }
      xy[0] = scratch.x(t);
      xy[1] = scratch.y(t);
      return true;
    }
    for (int age = 1; age < size(); age++) {
      if (time(age) <= t) {
        double gap = time(age - 1) - time(age);
        if (gap > 0.1) {
          return false;
        }
        double f = (t - time(age)) / gap;
        xy[0] = x(age) + f * (x(age - 1) - x(age));
        xy[1] = y(age) + f * (y(age - 1) - y(age));
        return true;
      }
    }
    return false;
  }

  void copyTo(int age, Observations.Builder to) {
    int i = slot(age);
    to.add(time[i], camera, x[i], y[i], pixelX[i], pixelY[i]);
  }
}
