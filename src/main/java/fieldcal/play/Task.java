package fieldcal.play;

import fieldcal.play.RobotOrder.Kick;
import fieldcal.play.RobotOrder.Pose;

/**
 * One kick to be made: who kicks the ball from where in which direction.
 *
 * @param kick what is wanted
 * @param kicker index of the robot
 * @param x of the ball, m
 * @param y of the ball, m
 * @param aim direction of the kick, rad, counter-clockwise from x
 * @param receiver where the other robot waits
 */
record Task(PlannedKick kick, int kicker, double x, double y, double aim, Pose receiver) {
  /** Distance of a kicker's centre from the ball before it drives up, m: 7 cm of air. */
  static final double BEHIND = 0.17;

  /** How fast a robot drives backwards away from the ball, m/s: a robot's radius within 0.4 s. */
  static final double BACK_OFF = 0.25;

  /** At which distance robots go round a ball that they must not touch, m. */
  static final double AROUND = 0.155;

  /** At which distance a robot that has nothing to do with the ball goes round it, m. */
  static final double ROUND = 0.35;

  int other() {
    return 1 - kicker;
  }

  Pose behind() {
    return behind(x, y, aim, BEHIND);
  }

  static Pose behind(double x, double y, double aim, double distance) {
    return new Pose(x - distance * Math.cos(aim), y - distance * Math.sin(aim), aim);
  }

  Kick order() {
    return new Kick(kick.speed(), kick.elevation());
  }

  /** How far a point lies along the kick's path. */
  double along(double px, double py) {
    return (px - x) * Math.cos(aim) + (py - y) * Math.sin(aim);
  }

  /** How far it lies to the left of it. */
  double aside(double px, double py) {
    return -(px - x) * Math.sin(aim) + (py - y) * Math.cos(aim);
  }
}
