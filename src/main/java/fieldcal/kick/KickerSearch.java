package fieldcal.kick;

import fieldcal.vision.RobotId;

/** Finds the robot that a jump of the ball's velocity comes from, and distinguishes a kick from everything else that robots do to balls. */
final class KickerSearch {
  /** A ball that is not faster than before bounced off a robot; a kick adds speed, m/s. */
  static final double LEAST_GAIN = 0.2;

  /** A kick leaves a ball at least this share of its speed; a robot that runs into a ball from the side may leave less. */
  private static final double LEAST_SHARE = 0.6;

  /** A kicked ball is farther from its robot by at least this some 0.1 s later, m. */
  private static final double LEAST_SEPARATION = 0.04;

  /** A kicked ball is faster than this relative to its robot; a carried one is not, m/s. */
  private static final double CARRIED = 0.5;

  /** Longest time for which a kicker hides the ball, s: 0.5 m at 2.5 m/s. */
  private static final double HIDDEN = 0.2;

  /** A hidden kicker had the ball within this time before, s. */
  private static final double HELD = 1.5;

  /** Centres of ball and robot are 112 mm apart when they touch; the rest is for cameras that disagree, m. */
  private static final double TOUCHING = 0.15;

  private final KickFinderSettings settings;
  private final RobotPoses robots;
  private final DribbleWatch dribbles;
  private final PlayingArea area;
  private final double[] velocity = new double[2];
  private final double[] start = new double[3];

  KickerSearch(
      KickFinderSettings settings, RobotPoses robots, DribbleWatch dribbles, PlayingArea area) {
    this.settings = settings;
    this.robots = robots;
    this.dribbles = dribbles;
    this.area = area;
  }

  /**
   * The robot within reach from which the ball moves away; from rest also one from which it does not seem to, since a camera projects a steep chip to one side.
   *
   * @return null when there is none
   */
  RobotId kicker(JumpDetector.Jump jump) {
    double t = jump.time();
    double reach = settings.robotReach();
    RobotId robot = robots.kicker(t, jump.x(), jump.y(), jump.vx(), jump.vy(), reach, velocity);
    return robot == null && jump.fromRest()
        ? robots.nearest(t, jump.x(), jump.y(), reach, velocity)
        : robot;
  }

  /**
   * The robot that may have kicked a ball that came into view only on its way: it had the ball, and the ball comes straight out of its mouth. {@link #hidden} then tells for how long the ball was hidden.
   *
   * @return null when there is none
   */
  RobotId hiddenKicker(JumpDetector.Jump jump) {
    RobotId robot =
        robots.kickerBefore(jump.time(), jump.x(), jump.y(), jump.vx(), jump.vy(), HIDDEN, start);
    if (robot == null || !dribbles.hadBall(robot, jump.time() - start[0], HELD)) {
      return null;
    }
    velocity[0] = start[1];
    velocity[1] = start[2];
    return robot;
  }

  /** For how long the ball of the last {@link #hiddenKicker} was hidden, s. */
  double hidden() {
    return start[0];
  }

  /** Whether the ball touched a robot. */
  boolean touched(JumpDetector.Jump jump) {
    return robots.nearest(jump.time(), jump.x(), jump.y(), TOUCHING, velocity) != null;
  }

  /** Whether a ball with no robot in reach was kicked: only if it lay still, by a robot that no camera sees. */
  boolean startedAlone(JumpDetector.Jump jump) {
    return jump.fromRest()
        && jump.speed() > 1.5 * settings.minSpeed()
        && area.outside(jump.x(), jump.y()) <= 0;
  }

  /** Whether the ball stays at the robot: then it is dribbled or pushed, however fast both are. */
  boolean carried(RobotId robot, JumpDetector.Jump jump, BallTrack track) {
    if (Math.hypot(jump.vx() - velocity[0], jump.vy() - velocity[1]) < CARRIED) {
      return true;
    }
    double t = track.lastTime();
    double before = robots.distanceTo(robot, jump.time(), jump.x(), jump.y());
    return robots.distanceTo(robot, t, track.x(0), track.y(0)) - before < LEAST_SEPARATION;
  }

  /**
   * Whether the ball bounced off a robot. A ball that bounces off loses energy, a kicked one gains some; both in the robot's frame, since the robot may itself have run into the ball.
   *
   * @param robot that was found last
   * @param speedBefore of the ball, m/s
   */
  boolean isDeflection(JumpDetector.Jump jump, RobotId robot, double speedBefore) {
    if (robot == null) {
      return !jump.fromRest() && jump.speed() < speedBefore + LEAST_GAIN;
    }
    if (jump.born()) {
      return jump.speed() < speedBefore + LEAST_GAIN;
    }
    double before = Math.hypot(jump.vxBefore() - velocity[0], jump.vyBefore() - velocity[1]);
    double after = Math.hypot(jump.vx() - velocity[0], jump.vy() - velocity[1]);
    return after < before + LEAST_GAIN || jump.speed() < LEAST_SHARE * speedBefore;
  }
}
