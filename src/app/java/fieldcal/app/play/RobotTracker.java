package fieldcal.app.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;

/** Follows one robot over all cameras: an α-β filter on position and orientation (Benedict and Bordner 1962). */
final class RobotTracker {
  /** Gains for 3 mm of noise at 70 to 150 Hz and robots that accelerate at 3 m/s². */
  private static final double ALPHA = 0.3;

  private static final double BETA = 0.06;

  /** Farther off than that is another pattern taken for this robot, m. */
  private static final double GATE = 0.3;

  private static final int ENOUGH_ELSEWHERE = 4;
  private static final double FORGET = 0.5;

  private final RobotId id;
  private double x;
  private double y;
  private double orientation;
  private double vx;
  private double vy;
  private double angular;
  private double time = Double.NaN;
  private int elsewhere;

  RobotTracker(RobotId id) {
    this.id = id;
  }

  void accept(RobotDetection seen, double t) {
    if (Double.isNaN(seen.orientation())) {
      return;
    }
    double dt = Math.max(0, t - time);
    if (Double.isNaN(time) || dt > FORGET || elsewhere >= ENOUGH_ELSEWHERE) {
      start(seen, t);
      return;
    }
    double errorX = seen.x() - (x + dt * vx);
    double errorY = seen.y() - (y + dt * vy);
    double turn =
        Math.IEEEremainder(seen.orientation() - (orientation + dt * angular), 2 * Math.PI);
    if (Math.hypot(errorX, errorY) > GATE) {
      elsewhere++;
      return;
    }
    elsewhere = 0;
    // Two cameras may show the same instant: then there is no time for a velocity to work in.
    double span = Math.max(dt, 0.005);
    x += dt * vx + ALPHA * errorX;
    y += dt * vy + ALPHA * errorY;
    orientation += dt * angular + ALPHA * turn;
    vx += BETA / span * errorX;
    vy += BETA / span * errorY;
    angular += BETA / span * turn;
    time = Math.max(time, t);
  }

  private void start(RobotDetection seen, double t) {
    x = seen.x();
    y = seen.y();
    orientation = seen.orientation();
    vx = 0;
    vy = 0;
    angular = 0;
    time = t;
    elsewhere = 0;
  }

  /** Where it is now, if it went on as it did; beyond a tenth of a second it is taken to stand. */
  Robot at(double now) {
    double dt = now - time;
    double ahead = dt < 0.1 ? Math.max(0, dt) : 0;
    boolean known = dt < 0.1;
    return new Robot(
        id,
        x + ahead * vx,
        y + ahead * vy,
        Math.IEEEremainder(orientation + ahead * angular, 2 * Math.PI),
        known ? vx : 0,
        known ? vy : 0,
        time);
  }
}
