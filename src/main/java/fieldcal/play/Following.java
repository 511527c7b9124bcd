package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;

/**
 * How late a robot follows its orders, measured while it slows down: the way that it goes too far, per speed that it was ordered to lose. Radios, motors, weak brakes and the delay of vision all contribute. A robot that follows late is driven more calmly: the usual gains would make it overshoot.
 */
final class Following {
  /** The delay that the gains of {@link Driver} are made for, s: robots that hear after 20 ms measure 0.05 to 0.13, of which vision's filter is half. */
  static final double USUAL = 0.13;

  /** What is assumed of a robot until it has slowed down, s: the delays of a slow radio and weak brakes. */
  private static final double FEARED = 0.25;

  /** Weight of that assumption, as a loss of speed, m/s: a quarter of a drive across the field. */
  private static final double KNOWN = 0.5;

  /** Loss of speed after which an older measurement has half its weight, m/s: two drives across the field. */
  private static final double MEMORY = 5;

  /** A robot that moves for longer after it was ordered to stand is pushed or carried, s. */
  private static final double AFTERWARDS = 1;

  /** A slower robot's direction is noise, m/s. */
  private static final double SLOW = 0.1;

  /** Least part of the usual gains: no robot is driven more calmly. */
  private static final double CALMEST = 0.2;

  /** A rise by more is an order to drive faster again, not noise, m/s. */
  private static final double FASTER = 0.1;

  private final double braking;
  private final Whereabouts whereabouts = new Whereabouts();
  private double reference;
  private double standsSince;
  private double overrun = KNOWN * FEARED;
  private double lost = KNOWN;
  private double overrunNow;
  private double lostNow;
  private boolean turnsRound;

  /** Creates it with the deceleration, m/s², that robots are ordered and expected to reach. */
  Following(double braking) {
    this.braking = braking;
  }

  /**
   * Takes what is known at the beginning of a tick.
   *
   * @param robot as it is known now; null when it was never seen
   * @param span since the last tick, s
   */
  void look(Robot robot, double span) {
    whereabouts.look(robot, span);
  }

  /**
   * Takes what the robot is ordered at the end of a tick.
   *
   * @param robot as it was seen last; null when it was never seen
   * @param seen whether it is seen now; otherwise nothing is learned
   * @param ordered its velocity, m/s
   * @param span since the last tick, s
   */
  void update(Robot robot, boolean seen, Velocity ordered, double span) {
    whereabouts.order(ordered);
    if (robot == null || !seen) {
      reference = 0;
      learn(-lostNow);
      return;
    }
    double speed = robot.speed();
    if (speed < SLOW) {
      // It counts only if the robot was ordered to stop.
      learn(lostNow > 0 ? reference : 0);
      reference = 0;
      return;
    }
    double along = (ordered.vx() * robot.vx() + ordered.vy() * robot.vy()) / speed;
    // An order to stop at once is taken as one to brake with the expected deceleration.
    double next = Math.max(Math.max(0, along), reference - braking * span);
    boolean goesOn = next > reference + FASTER;
    turnsRound |= along < -FASTER;
    if (goesOn) {
      // It may not have slowed down yet.
      learn(speed < reference + FASTER ? 0 : -lostNow);
      reference = Math.min(next, speed);
    } else if (next >= speed) {
      learn(0);
      reference = speed;
    } else {
      standsSince = next > 0 ? 0 : standsSince + span;
      overrunNow += standsSince > AFTERWARDS ? 0 : (speed - next) * span;
      lostNow += reference - next;
      reference = next;
    }
  }

  /** Learns from what the robot did since it was ordered to slow down, and from a last loss of speed. */
  private void learn(double more) {
    double loses = lostNow + more;
    // A robot that is to turn round brakes harder than one that is to stop: it is at least so late.
    boolean isLateness = !turnsRound || overrunNow > loses * late();
    if (loses > SLOW && isLateness) {
      double keeps = Math.pow(0.5, loses / MEMORY);
      overrun = keeps * overrun + overrunNow;
      lost = keeps * lost + loses;
    }
    overrunNow = 0;
    lostNow = 0;
    standsSince = 0;
    turnsRound = false;
  }

  /** How much farther in a direction, given as a unit vector, the robot may be than it is known to be, m. */
  double beyond(Robot robot, double nx, double ny) {
    return whereabouts.beyond(robot, nx, ny);
  }

  /** How late it follows, s. */
  double late() {
    return overrun / lost;
  }

  /** The part of the usual gains and decelerations that the robot tolerates: 1 if it follows as usual or better. */
  double calm() {
    return Math.max(CALMEST, Math.min(1, USUAL / late()));
  }
}
