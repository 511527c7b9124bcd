package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import fieldcal.play.RobotOrder.Velocity;
import java.util.Optional;

/**
 * A robot carries the ball to where it is to be kicked from, turns it into the direction of the kick, lets go and backs off. A robot that has lost the ball before pushes it there if it can, more
 * slowly, and lets go without turning.
 */
final class PlaceStep extends TaskStep {
  /** Time allowed in addition to the drive at half the speed, s. */
  private static final double TIMEOUT = 15;

  private static final double LET_GO = 0.3;

  /** A ball farther from the dribbler is lost, m; a moving one is seen late by up to 60 ms. */
  private static final double HELD = 0.06;

  private static final double SEEN_LATE = 0.06;

  /** The ball is lost when it was seen away from the dribbler for this long, s: eight frames. */
  private static final double LOSS = 0.12;

  /** A robot and a ball that it has lost part at no more than twice its speed: a ball that is farther off was taken away. */
  private static final double PART = 2;

  /** A pushed ball is at its place within this distance, m. */
  private static final double PUSHED_THERE = 0.1;

  /** Nearer to its place the ball is not turned towards it any more, m. */
  private static final double STRAIGHT = 0.3;

  /** A robot that would have to turn the ball by more pulls it instead, rad. */
  private static final double MOST_TURN = Math.toRadians(100);

  private double lost = Double.NaN;
  private double had;
  private double released = Double.NaN;
  private double last = Double.NaN;
  private double timeout;
  private double heading = Double.NaN;
  private boolean pulls;
  private boolean enough;
  private Velocity ordered;

  PlaceStep(Ledger ledger, Task task) {
    super(PlayPhase.PLACE, ledger, task);
  }

  @Override
  Step tick(Situation s, int i) {
    driveReceiver(s);
    Robot r = s.robot(i);
    if (Double.isNaN(heading)) {
      head(r);
    }
    Grip grip = ledger.grip(i, !pulls, s.limits());
    if (Double.isNaN(last)) {
      last = s.time();
      had = s.time();
      ordered = new Velocity(r.vx(), r.vy(), 0);
      timeout = TIMEOUT + Math.hypot(r.x() - task.x(), r.y() - task.y()) / (0.5 * grip.speed());
    }
    if (age(s) > timeout) {
      return giveUp(s.plan().robot(i) + " did not get the ball to its place");
    }
    if (!Double.isNaN(released)) {
      return backOff(s, i);
    }
    ledger.carries(i);
    if (isLost(s, i)) {
      if (s.fromDribbler(i) > HELD + PART * grip.speed() * (s.time() - had)) {
        return lookAgain("somebody took the ball from " + s.plan().robot(i));
      }
      String reason = s.plan().robot(i) + " lost the ball while carrying it";
      ledger.lost(i, grip.gentle() && !pulls, reason);
      return lookAgain();
    }
    enough |= isEnough(s, r, grip);
    Pose target = grip.gentle() ? straight(r) : behind(task.aim());
    if (enough) {
      target = new Pose(r.x(), r.y(), r.orientation());
    }
    double span = Math.max(0, Math.min(0.1, s.time() - last));
    last = s.time();
    ordered = s.carry(i, target, grip, ordered, span);
    s.dribble(i);
    if (isThere(r, target, grip)) {
      released = s.time();
    }
    return this;
  }

  /** Whether the ball can be kicked from where it is now, so that it need not be carried farther: where it is hard to carry, or where much of the way is left. */
  private boolean isEnough(Situation s, Robot r, Grip grip) {
    // A ball that its robot hides from the cameras is seen where it was lost from sight.
    double[] ball = ball(r);
    Optional<Task> here =
        grip.gentle()
            ? Decider.withoutCarrying(s, task.kick(), ball[0], ball[1], ledger.pushing(s))
            : Decider.fromAfar(s, task.kick(), ball[0], ball[1], ledger.pushing(s));
    return here.isPresent();
  }

  private Pose behind(double orientation) {
    return Task.behind(task.x(), task.y(), orientation, PlayArea.AT_DRIBBLER);
  }

  /** Whether it pushes or pulls, by which it has to turn less. */
  private void head(Robot r) {
    heading = r.orientation();
    double[] ball = ball(r);
    double way = Math.atan2(task.y() - ball[1], task.x() - ball[0]);
    pulls = Math.abs(Math.IEEEremainder(way - r.orientation(), 2 * Math.PI)) > MOST_TURN;
  }

  private static double[] ball(Robot r) {
    return new double[] {
      r.x() + PlayArea.AT_DRIBBLER * Math.cos(r.orientation()),
      r.y() + PlayArea.AT_DRIBBLER * Math.sin(r.orientation())
    };
  }

  /** Straight before or behind the robot on its way. */
  private Pose straight(Robot r) {
    double[] ball = ball(r);
    double dx = task.x() - ball[0];
    double dy = task.y() - ball[1];
    if (Math.hypot(dx, dy) > STRAIGHT) {
      heading = Math.atan2(dy, dx) + (pulls ? Math.PI : 0);
    }
    return behind(heading);
  }

  private boolean isThere(Robot r, Pose target, Grip grip) {
    double off = Math.hypot(r.x() - target.x(), r.y() - target.y());
    if (grip.gentle() || enough) {
      double[] ball = ball(r);
      double ballOff = Math.hypot(ball[0] - task.x(), ball[1] - task.y());
      return (enough || ballOff < PUSHED_THERE) && r.speed() < 0.15;
    }
    double turn = Math.IEEEremainder(task.aim() - r.orientation(), 2 * Math.PI);
    return off < 0.04 && Math.abs(turn) < 0.06 && r.speed() < 0.1;
  }

  /** A ball that is not seen counts as hidden by the robot that has it, if it is seen again at the end. */
  private boolean isLost(Situation s, int i) {
    boolean held = s.fromDribbler(i) < HELD + SEEN_LATE * s.robot(i).speed();
    had = held && s.ballUnseen() < LOSS ? s.time() : had;
    if (s.ballUnseen() > 0.15 || held) {
      lost = Double.NaN;
    } else if (Double.isNaN(lost)) {
      lost = s.time();
    }
    return s.time() - lost > LOSS;
  }

  private Step backOff(Situation s, int i) {
    if (s.time() - released < LET_GO) {
      return this;
    }
    s.backOff(i);
    // A ball that its robot has hidden comes into sight.
    boolean off =
        s.ballUnseen() < LOSS && s.fromDribbler(i) > Task.BEHIND - PlayArea.AT_DRIBBLER - 0.015;
    return off || s.time() - released > LET_GO + 1 ? lookAgain() : this;
  }
}
