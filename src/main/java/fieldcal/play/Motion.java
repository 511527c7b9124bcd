package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;

/** Whether a robot moves when it is commanded to. */
final class Motion {
  /** A robot that is commanded to drive but does not move for this long is stuck, s. */
  private static final double STUCK = 3;

  /** A robot that is commanded to drive but does not move for this long ends the play, s. */
  private static final double STUCK_FOR_GOOD = 20;

  /** A kicker that did not move for this long while it was commanded up to the ball has nothing to do with a kick that did not happen, s. */
  private static final double HARDLY_MOVES = 2;

  /** A shorter displacement may be the noise of vision, m. */
  private static final double MOVED = 0.03;

  /** A slower drive may end before it shows, m/s. */
  private static final double DRIVES = 0.2;

  private double x;
  private double y;
  private double stuck;

  /**
   * Takes the next tick.
   *
   * @param robot as it is seen
   * @param ordered how fast it is commanded to drive, m/s
   * @param needed whether the play waits for this robot to do something; one that is stuck stays so meanwhile, whatever it is commanded
   * @param span since the last tick, s
   */
  void update(Robot robot, double ordered, boolean needed, double span) {
    if (Math.hypot(robot.x() - x, robot.y() - y) > MOVED) {
      x = robot.x();
      y = robot.y();
      stuck = 0;
    } else if (ordered > DRIVES || needed && stuck()) {
      stuck += span;
    }
  }

  boolean hardlyMoves() {
    return stuck > HARDLY_MOVES;
  }

  boolean stuck() {
    return stuck > STUCK;
  }

  boolean stuckForGood() {
    return stuck > STUCK_FOR_GOOD;
  }
}
