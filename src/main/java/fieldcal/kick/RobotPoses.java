package fieldcal.kick;

import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.HashMap;
import java.util.Map;

/**
 * Where each robot was seen last, by each camera, and how fast it drives.
 *
 * <p>Per camera, because cameras that disagree by centimetres would make a robot that both see look as if it jumped to and fro.
 */
final class RobotPoses {
  /** A robot not seen for that long may be anywhere, s. */
  private static final double FORGET = 0.6;

  /** Robots drive at most so fast; more is an identity swap, m/s. */
  private static final double MAX_SPEED = 5;

  private record Key(RobotId robot, int camera) {}

  private static final class Pose {
    private double time = Double.NEGATIVE_INFINITY;
    private double x;
    private double y;
    private double vx;
    private double vy;
  }

  private final Map<Key, Pose> poses = new HashMap<>();

  void update(VisionFrame frame) {
    for (RobotDetection robot : frame.robots()) {
      Pose pose = poses.computeIfAbsent(new Key(robot.id(), frame.cameraId()), key -> new Pose());
      double dt = frame.captureTime() - pose.time;
      if (dt > 0.004 && dt < FORGET) {
        // A light low pass: cameras that disagree by centimetres would otherwise look like robots
        // at several m/s.
        double gain = Math.min(1, dt / 0.1);
        double vx = (robot.x() - pose.x) / dt;
        double vy = (robot.y() - pose.y) / dt;
        if (Math.hypot(vx, vy) < MAX_SPEED) {
          pose.vx += gain * (vx - pose.vx);
          pose.vy += gain * (vy - pose.vy);
        }
      } else if (!(Math.abs(dt) < FORGET)) {
        pose.vx = 0;
        pose.vy = 0;
      }
      pose.time = frame.captureTime();
      pose.x = robot.x();
      pose.y = robot.y();
    }
  }

  void clear() {
    poses.clear();
  }

  /** Centre-to-centre distance between a ball and the nearest robot at {@code t}, m; infinite without robots. */
  double distance(double t, double x, double y, RobotId except) {
    double nearest = Double.POSITIVE_INFINITY;
    for (Map.Entry<Key, Pose> e : poses.entrySet()) {
      if (!e.getKey().robot().equals(except)) {
        nearest = Math.min(nearest, distance(e.getValue(), t, x, y));
      }
    }
    return nearest;
  }

  private static double distance(Pose p, double t, double x, double y) {
    double dt = t - p.time;
    if (Math.abs(dt) > FORGET) {
      return Double.POSITIVE_INFINITY;
    }
    double ahead = Math.max(-0.1, Math.min(0.1, dt));
    return Math.hypot(x - p.x - p.vx * ahead, y - p.y - p.vy * ahead);
  }

  /** Centre-to-centre distance between a ball and one robot at {@code t}, m; infinite when the robot is not seen. */
  double distanceTo(RobotId robot, double t, double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (Map.Entry<Key, Pose> e : poses.entrySet()) {
      if (e.getKey().robot().equals(robot)) {
        nearest = Math.min(nearest, distance(e.getValue(), t, x, y));
      }
    }
    return nearest;
  }

  /** The robot nearest to a place; null when none is within reach. */
  RobotId nearest(double t, double x, double y, double reach) {
    RobotId best = null;
    double nearest = reach;
    for (Map.Entry<Key, Pose> e : poses.entrySet()) {
      double d = distance(e.getValue(), t, x, y);
      if (d < nearest) {
        nearest = d;
        best = e.getKey().robot();
      }
    }
    return best;
  }

  /**
   * Who can have given a ball at (x, y) the velocity (vx, vy): the nearest robot within reach from which the ball moves away.
   *
   * @return null when there is none
   */
  RobotId kicker(double t, double x, double y, double vx, double vy, double reach) {
    RobotId best = null;
    double nearest = reach;
    for (Map.Entry<Key, Pose> e : poses.entrySet()) {
      Pose p = e.getValue();
      double d = distance(p, t, x, y);
      double away = (x - p.x) * (vx - p.vx) + (y - p.y) * (vy - p.vy);
      if (d < nearest && away > 0.3 * d) {
        nearest = d;
        best = e.getKey().robot();
      }
    }
    return best;
  }
}
