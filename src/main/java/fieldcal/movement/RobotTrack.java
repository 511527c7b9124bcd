package fieldcal.movement;

import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;

/**
 * Follows one robot: refuses detections that cannot be this robot, and has its path cut into manoeuvres a few seconds later.
 *
 * <p>A detection that lies too far from where the robot must be is an exchanged identity or a misread pattern; if such detections agree for a while, the robot was
 * moved, and a new stretch begins. No manoeuvre spans a break.
 */
final class RobotTrack {
  /** A robot that was not seen for longer may have moved in any way, s. */
  private static final double LONGEST_GAP = 0.2;

  /** Robots do not accelerate more, m/s²: twice what the league's strongest do. */
  private static final double STRONGEST = 20;

  /** How far a detection may be off for other reasons: cameras that disagree by 26 mm, and noise, m. */
  private static final double TOLERANCE = 0.06;

  /** Robots do not drive faster, m/s; used while a robot's velocity is not known yet. */
  private static final double FASTEST = 6;

  /** Detections after which the velocity is known. */
  private static final int ACQUAINTED = 5;

  /** Detections refused in a row after which the robot is believed to be elsewhere. */
  private static final int PERSISTENT = 6;

  private final PathBlocks path;
  private final TurnTrack turning;
  private double time = Double.NEGATIVE_INFINITY;
  private double x;
  private double y;
  private double vx;
  private double vy;
  private int followed;
  private int refusedInARow;

  RobotTrack(RobotId id, ManoeuvreFinder driving, ManoeuvreFinder turning) {
    path = new PathBlocks(id, driving);
    this.turning = new TurnTrack(id, turning);
  }

  /** Whether a detection is farther from where the robot must be than is possible. */
  private boolean isFarther(double possible, double at, RobotDetection robot) {
    double dt = at - time;
    double dx = robot.x() - x - vx * dt;
    double dy = robot.y() - y - vy * dt;
    return dx * dx + dy * dy > possible * possible;
  }

  /**
   * Takes a detection.
   *
   * @return false when it cannot have been this robot
   */
  boolean accept(double at, int camera, RobotDetection robot) {
    if (!Double.isFinite(robot.x()) || !Double.isFinite(robot.y()) || !Double.isFinite(at)) {
      return false;
    }
    double dt = at - time;
    if (!(Math.abs(dt) < LONGEST_GAP)) {
      end();
      start(at, robot);
    } else {
      double late = Math.abs(dt);
      double possible = TOLERANCE + 0.5 * STRONGEST * late * late;
      if (followed < ACQUAINTED) {
        possible += FASTEST * late;
      }
      if (isFarther(possible, at, robot)) {
        if (++refusedInARow < PERSISTENT) {
          return false;
        }
        end();
        start(at, robot);
      } else {
        follow(dt, robot);
      }
    }
    refusedInARow = 0;
    path.add(at, robot.x(), robot.y(), robot.orientation(), camera);
    turning.accept(at, camera, robot.orientation());
    return true;
  }

  private void start(double at, RobotDetection robot) {
    time = at;
    x = robot.x();
    y = robot.y();
    vx = 0;
    vy = 0;
    followed = 1;
  }

  /** An alpha-beta filter: good enough to say where the robot cannot be. Its gains are those of a line fit until they reach those of a memory of some 0.1 s. */
  private void follow(double dt, RobotDetection robot) {
    if (dt <= 0) {
      return;
    }
    double n = ++followed;
    double alpha = Math.max(2 * (2 * n - 1) / (n * (n + 1)), Math.min(1, dt / 0.03));
    double beta = Math.max(6 / (n * (n + 1)), Math.min(1, dt / 0.1) * Math.min(1, dt / 0.03));
    double aheadX = robot.x() - x - vx * dt;
    double aheadY = robot.y() - y - vy * dt;
    x += vx * dt + alpha * aheadX;
    y += vy * dt + alpha * aheadY;
    vx += beta * aheadX / Math.max(dt, 0.005);
    vy += beta * aheadY / Math.max(dt, 0.005);
    time += dt;
  }

  /** The path breaks off here. */
  void end() {
    path.end();
    turning.end();
    time = Double.NEGATIVE_INFINITY;
    refusedInARow = 0;
  }
}
