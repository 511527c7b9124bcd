package fieldcal.app.play;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;

/**
 * By how much each camera reports everything shifted, learned from what two cameras see at the same time. Their sum is zero: nobody knows which camera is right. A play needs them so that a robot
 * that only one camera sees and a ball that two see stand where they do to each other. Not thread-safe.
 */
final class CameraOffsets {
  /** Part of a contradiction that is believed at once: some 50 frames of two cameras make it known to a millimetre or two. */
  private static final double GAIN = 0.02;

  /** Tracks of two cameras further apart in time tell more of the motion than of the cameras, s. */
  private static final double TOGETHER = 0.02;

  /** What moves faster is shifted by what cameras' clocks disagree in, m/s. */
  private static final double SLOW = 0.5;

  /** Cameras that disagree by more see different things, m. */
  private static final double MOST = 0.2;

  private final Map<Integer, double[]> offsets = new HashMap<>();

  /** What one camera last saw of something, carried on to the time asked for. */
  record View(int camera, double time, double x, double y, double vx, double vy) {
    View at(double t) {
      return new View(camera, time, x + (t - time) * vx, y + (t - time) * vy, vx, vy);
    }
  }

  /** Learns from what cameras see of one thing; the newest view is of the camera that has just seen it. */
  void learn(View newest, Collection<View> all) {
    for (View other : all) {
      boolean slow =
          Math.hypot(other.vx, other.vy) < SLOW && Math.hypot(newest.vx, newest.vy) < SLOW;
      if (other.camera != newest.camera && newest.time - other.time < TOGETHER && slow) {
        View then = other.at(newest.time);
        learn(newest.camera, other.camera, newest.x - then.x, newest.y - then.y);
      }
    }
  }

  private void learn(int a, int b, double apartX, double apartY) {
    if (Math.hypot(apartX, apartY) > MOST) {
      return;
    }
    double[] first = offsets.computeIfAbsent(a, id -> new double[2]);
    double[] second = offsets.computeIfAbsent(b, id -> new double[2]);
    double errorX = GAIN * (apartX - first[0] + second[0]);
    double errorY = GAIN * (apartY - first[1] + second[1]);
    first[0] += errorX / 2;
    first[1] += errorY / 2;
    second[0] -= errorX / 2;
    second[1] -= errorY / 2;
  }

  /** What to take off a camera's x, m. */
  double x(int camera) {
    double[] offset = offsets.get(camera);
    return offset == null ? 0 : offset[0];
  }

  /** What to take off a camera's y, m. */
  double y(int camera) {
    double[] offset = offsets.get(camera);
    return offset == null ? 0 : offset[1];
  }
}
