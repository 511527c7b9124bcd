package fieldcal.movement;

import java.util.Arrays;

/** The last eleven frames of one camera that may show one robot. The league's estimator looks at these. */
final class FrameSteps {
  /** Frames between two positions. */
  private static final int APART = 5;

  private static final int KEPT = 2 * APART + 1;

  private final long[] frame = new long[KEPT];
  private final double[] t = new double[KEPT];
  private final double[] x = new double[KEPT];
  private final double[] y = new double[KEPT];

  FrameSteps() {
    forget();
  }

  void forget() {
    Arrays.fill(frame, Long.MIN_VALUE);
  }

  /** Takes a position in the camera's n-th frame, and counts when the robot is also in the frames five and ten before. */
  void add(long n, double time, double px, double py, LeagueStatistics sink) {
    int now = (int) (n % KEPT);
    frame[now] = n;
    t[now] = time;
    x[now] = px;
    y[now] = py;
    if (n < 2 * APART) {
      return;
    }
    int middle = (int) ((n - APART) % KEPT);
    int first = (int) ((n - 2 * APART) % KEPT);
    if (frame[middle] != n - APART || frame[first] != n - 2 * APART) {
      return;
    }
    double dt1 = t[middle] - t[first];
    double dt2 = time - t[middle];
    if (dt1 > 0 && dt2 > 0) {
      sink.add(
          (x[middle] - x[first]) / dt1,
          (y[middle] - y[first]) / dt1,
          (px - x[middle]) / dt2,
          (py - y[middle]) / dt2,
          dt2);
    }
  }
}
