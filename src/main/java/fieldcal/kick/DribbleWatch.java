package fieldcal.kick;

import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.HashMap;
import java.util.Map;

/**
 * Remembers when each robot had the ball at its front, to recognise kicks after dribbling.
 *
 * <p>Ball and robot are compared within one camera's frame, so that what cameras disagree by does not matter.
 */
final class DribbleWatch {
  /** A ball at the dribbler is 75 mm + 21.5 mm ahead of the robot's centre; 25 mm less or 40 mm more for noise and heights that vision assumes, m. */
  private static final double NEAREST = 0.07;

  private static final double FARTHEST = 0.135;

  /** Largest distance of the ball to the side of the dribbler's middle, m: dribblers reach some 70 mm to each side. */
  private static final double ASIDE = 0.08;

  /** A robot that drives up to a resting ball at 0.4 m/s has it at its front for this long without holding it, s. */
  private static final double LEAST_HOLD = 0.1;

  /** A ball that moved this far while at the front was taken along, m: cameras see a resting one to within a few millimetres. */
  private static final double LEAST_WAY = 0.025;

  /** Earlier contacts do not belong to this kick, s: the rules let a robot carry a ball for 1 m only. */
  private static final double MEMORY = 1.5;

  /** Longest time for which the ball may be hidden during one hold, s. */
  private static final double HIDDEN = 0.5;

  /** The kick's time is known to some milliseconds only, so the robot may have had the ball within this time of it, s. */
  private static final double BEFORE_KICK = 0.02;

  /** Fewer detections at the front may be false, or show a ball that passes by. */
  private static final int LEAST_SEEN = 3;

  /** Contacts remembered for each robot: two seconds of one camera at 75 Hz. */
  private static final int CAPACITY = 160;

  private final Map<RobotId, Contacts> contacts = new HashMap<>();

  /** When and where one robot had a ball at its front: a ring. */
  private static final class Contacts {
    private final double[] time = new double[CAPACITY];
    private final double[] x = new double[CAPACITY];
    private final double[] y = new double[CAPACITY];
    private long count;
    private double caught = Double.NEGATIVE_INFINITY;

    void add(double t, double px, double py) {
      int i = (int) (count++ % CAPACITY);
      time[i] = t;
      x[i] = px;
      y[i] = py;
    }
  }

  void clear() {
    contacts.clear();
  }

  void update(VisionFrame frame) {
    for (BallDetection ball : frame.balls()) {
      for (RobotDetection robot : frame.robots()) {
        if (atFront(robot, ball)) {
          of(robot.id()).add(frame.captureTime(), ball.x(), ball.y());
        }
      }
    }
  }

  private static boolean atFront(RobotDetection robot, BallDetection ball) {
    double dx = ball.x() - robot.x();
    double dy = ball.y() - robot.y();
    if (Math.abs(dx) > FARTHEST + ASIDE || Math.abs(dy) > FARTHEST + ASIDE) {
      return false;
    }
    if (Double.isNaN(robot.orientation())) {
      return Math.hypot(dx, dy) < FARTHEST;
    }
    double cos = Math.cos(robot.orientation());
    double sin = Math.sin(robot.orientation());
    double ahead = dx * cos + dy * sin;
    return ahead > NEAREST && ahead < FARTHEST && Math.abs(dy * cos - dx * sin) < ASIDE;
  }

  private Contacts of(RobotId robot) {
    return contacts.computeIfAbsent(robot, id -> new Contacts());
  }

  /** A kicked ball ended at this robot. */
  void caught(RobotId robot, double t) {
    of(robot).caught = t;
  }

  /** Whether the robot had the ball at its front, or stopped it, within {@code span} before {@code t}. */
  boolean hadBall(RobotId robot, double t, double span) {
    Contacts c = contacts.get(robot);
    if (c == null) {
      return false;
    }
    int seen = 0;
    for (long k = c.count - 1; k >= Math.max(0, c.count - CAPACITY); k--) {
      double at = c.time[(int) (k % CAPACITY)];
      if (at < t - span) {
        break;
      }
      seen += at <= t ? 1 : 0;
    }
    return seen >= LEAST_SEEN || c.caught <= t + BEFORE_KICK && t - c.caught < span;
  }

  /** Whether the robot that kicks at {@code t} had the ball before: took it along, or caught it and did not let go of it. */
  boolean dribbled(RobotId robot, double t, boolean fromRest) {
    Contacts c = contacts.get(robot);
    if (c == null) {
      return false;
    }
    double newest = Double.NEGATIVE_INFINITY;
    double oldest = t;
    double way = 0;
    int last = -1;
    for (long k = c.count - 1; k >= Math.max(0, c.count - CAPACITY); k--) {
      int i = (int) (k % CAPACITY);
      if (c.time[i] > t - BEFORE_KICK) {
        continue;
      }
      if (oldest - c.time[i] > HIDDEN || t - c.time[i] > MEMORY) {
        break;
      }
      if (last < 0) {
        last = i;
        newest = c.time[i];
      }
      oldest = c.time[i];
      way = Math.max(way, Math.hypot(c.x[i] - c.x[last], c.y[i] - c.y[last]));
    }
    boolean takenAlong = newest - oldest > LEAST_HOLD && way > LEAST_WAY;
    // A ball that comes along and is kicked on at once is at the front for some hundredths of a
    // second only.
    boolean longThere = !fromRest && t - oldest > LEAST_HOLD;
    boolean justCaught = t - c.caught > LEAST_HOLD && t - c.caught < MEMORY;
    // A ball that came to rest elsewhere after a robot touched it was let go of.
    boolean kept = !fromRest || oldest < c.caught + HIDDEN;
    return takenAlong || longThere || justCaught && kept;
  }
}
