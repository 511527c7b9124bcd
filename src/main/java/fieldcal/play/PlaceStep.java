package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;

/** A robot carries the ball to where it is to be kicked from, turns it into the direction of the kick, lets go and backs off. */
final class PlaceStep extends TaskStep {
  private static final double TIMEOUT = 20;
  private static final double LET_GO = 0.3;

  private double lost = Double.NaN;
  private double released = Double.NaN;

  PlaceStep(Ledger ledger, Task task) {
    super(PlayPhase.PLACE, ledger, task);
  }

  @Override
  Step tick(Situation s, int i) {
    driveReceiver(s);
    if (age(s) > TIMEOUT) {
      return giveUp(s.plan().robot(i) + " did not get the ball to its place");
    }
    if (!Double.isNaN(released)) {
      return backOff(s, i);
    }
    Pose target = Task.behind(task.x(), task.y(), task.aim(), PlayArea.AT_DRIBBLER);
    s.drive(i, target, s.limits().carrySpeed(), 0);
    s.dribble(i);
    Robot r = s.robot(i);
    // A ball that cannot be seen is hidden by the robot that has it, as long as it is seen again at
    // the end.
    boolean away = s.ballUnseen() < 0.15 && s.fromDribbler(i) > 0.12 + 0.05 * r.speed();
    if (!away) {
      lost = Double.NaN;
    } else if (Double.isNaN(lost)) {
      lost = s.time();
    } else if (s.time() - lost > 0.3) {
      return lookAgain();
    }
    double turn = Math.IEEEremainder(task.aim() - r.orientation(), 2 * Math.PI);
    boolean there = Math.hypot(r.x() - target.x(), r.y() - target.y()) < 0.04;
    if (there && Math.abs(turn) < 0.06 && r.speed() < 0.1) {
      released = s.time();
    }
    return this;
  }

  private Step backOff(Situation s, int i) {
    if (s.time() - released < LET_GO) {
      return this;
    }
    double orientation = s.robot(i).orientation();
    s.creep(i, -0.25 * Math.cos(orientation), -0.25 * Math.sin(orientation), orientation);
    boolean off = s.fromDribbler(i) > Task.BEHIND - PlayArea.AT_DRIBBLER - 0.015;
    return off || s.time() - released > LET_GO + 1 ? lookAgain() : this;
  }
}
