package fieldcal.kick;

import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Where the robots are and were a moment ago, and how fast they drive.
 *
 * <p>Per camera, because cameras that disagree by centimetres would make a robot that both see look as if it jumped to and fro.
 */
final class RobotPoses {
  /** Distance of the ball's centre ahead of the robot's when it is kicked, m: a front at 75 mm plus the ball's radius. */
  private static final double MOUTH = 0.0965;

  /** Half of a kicker's width and an error of the pose, m. */
  private static final double HALF_MOUTH = 0.08;

  /** Cosine of the largest angle between the ball's direction and the robot's front: a kicker sends the ball straight ahead, and 25° cover the robot's own motion and noise. */
  private static final double STRAIGHT = 0.906;

  /** A ball that is not faster than its robot by at least this is carried, m/s. */
  private static final double LEAST_RELATIVE = 0.7;

  private final Map<Integer, Map<RobotId, RobotPath>> cameras = new HashMap<>();
  private final Map<RobotId, List<RobotPath>> robots = new HashMap<>();
  private final List<RobotPath> near = new ArrayList<>();
  private final double[] state = new double[4];

  void update(VisionFrame frame) {
    Map<RobotId, RobotPath> seen =
        cameras.computeIfAbsent(frame.cameraId(), camera -> new HashMap<>());
    for (RobotDetection robot : frame.robots()) {
      RobotPath path = seen.get(robot.id());
      if (path == null) {
        path = new RobotPath(robot.id());
        seen.put(robot.id(), path);
        robots.computeIfAbsent(robot.id(), id -> new ArrayList<>()).add(path);
      }
      path.add(frame.captureTime(), robot.x(), robot.y(), robot.orientation());
    }
  }

  void clear() {
    cameras.clear();
    robots.clear();
  }

  /** The paths of robots that may be near a place; of each robot only those from cameras that know it at that time, if there are any. */
  private List<RobotPath> near(double t, double x, double y) {
    near.clear();
    for (List<RobotPath> paths : robots.values()) {
      int first = near.size();
      boolean known = false;
      for (int i = 0; i < paths.size(); i++) {
        RobotPath path = paths.get(i);
        if (!path.mayHaveBeenNear(x, y)) {
          continue;
        }
        boolean knows = path.knows(t);
        if (knows && !known) {
          known = true;
          near.subList(first, near.size()).clear();
        }
        if (knows || !known) {
          near.add(path);
        }
      }
    }
    return near;
  }

  /** Centre-to-centre distance between a ball and the nearest robot at {@code t}, m; infinite without robots. */
  double distance(double t, double x, double y, RobotId except) {
    double nearest = Double.POSITIVE_INFINITY;
    for (RobotPath path : near(t, x, y)) {
      if (!path.robot().equals(except) && path.at(t, state)) {
        nearest = Math.min(nearest, Math.hypot(x - state[0], y - state[1]));
      }
    }
    return nearest;
  }

  /** Centre-to-centre distance between a ball and one robot at {@code t}, m; infinite when the robot is not seen. */
  double distanceTo(RobotId robot, double t, double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (RobotPath path : near(t, x, y)) {
      if (path.robot().equals(robot) && path.at(t, state)) {
        nearest = Math.min(nearest, Math.hypot(x - state[0], y - state[1]));
      }
    }
    return nearest;
  }

  /** The robot nearest to a place, with its velocity (m/s); null when none is within reach. */
  RobotId nearest(double t, double x, double y, double reach, double[] velocity) {
    RobotId best = null;
    double nearest = reach;
    for (RobotPath path : near(t, x, y)) {
      if (path.at(t, state)) {
        double d = Math.hypot(x - state[0], y - state[1]);
        if (d < nearest) {
          nearest = d;
          best = path.robot();
          velocity[0] = state[2];
          velocity[1] = state[3];
        }
      }
    }
    return best;
  }

  /**
   * Who can have given a ball at (x, y) the velocity (vx, vy): the nearest robot within reach from which the ball moves away.
   *
   * @param velocity gets the robot's velocity, m/s
   * @return null when there is none
   */
  RobotId kicker(
      double t, double x, double y, double vx, double vy, double reach, double[] velocity) {
    RobotId best = null;
    double nearest = reach;
    for (RobotPath path : near(t, x, y)) {
      if (!path.at(t, state)) {
        continue;
      }
      double d = Math.hypot(x - state[0], y - state[1]);
      double away = (x - state[0]) * (vx - state[2]) + (y - state[1]) * (vy - state[3]);
      if (d < nearest && away > 0.3 * d) {
        nearest = d;
        best = path.robot();
        velocity[0] = state[2];
        velocity[1] = state[3];
      }
    }
    return best;
  }

  /**
   * Who can have kicked a ball a little before it came into view at (x, y) with the velocity (vx, vy): a robot from whose mouth it comes straight.
   *
   * @param longest how long before at most, s
   * @param start gets how long before t that was, s, and the robot's velocity there, m/s
   * @return null when there is none
   */
  RobotId kickerBefore(
      double t, double x, double y, double vx, double vy, double longest, double[] start) {
    RobotId best = null;
    double soonest = longest;
    for (RobotPath path : near(t, x, y)) {
      if (!path.at(t, state)) {
        continue;
      }
      double back = 0;
      double aside = 0;
      double along = 0;
      for (int i = 0; i < 2 && path.at(t - back, state); i++) {
        double front = path.orientation(t - back);
        double cos = Math.cos(front);
        double sin = Math.sin(front);
        double dx = x - state[0];
        double dy = y - state[1];
        along = vx * cos + vy * sin;
        double ahead = dx * cos + dy * sin;
        // Both at the time of the kick.
        back = Math.max(0, (ahead - MOUTH) / along);
        aside = Math.abs((dy - vy * back) * cos - (dx - vx * back) * sin);
      }
      boolean straight = along > STRAIGHT * Math.hypot(vx, vy);
      double relative = Math.hypot(vx - state[2], vy - state[3]);
      if (straight && aside < HALF_MOUTH && back < soonest && relative > LEAST_RELATIVE) {
        soonest = back;
        best = path.robot();
        start[0] = back;
        start[1] = state[2];
        start[2] = state[3];
      }
    }
    return best;
  }
}
