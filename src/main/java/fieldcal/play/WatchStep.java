package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.PlayedKick.End;
import fieldcal.play.RobotOrder.Pose;

/** The ball is left alone: no robot comes near it except the receiver, to whose place it comes. */
final class WatchStep implements Step {
  /** A ball that was not seen for longer is lost, s. */
  private static final double LOST = 1.2;

  /** Distance at which a kicker follows a slow ball, m. */
  private static final double FOLLOW = 0.8;

  private final Ledger ledger;
  private final Task task;
  private final double kicked;
  private final double shown;
  private final int number;
  private double outside = Double.NaN;
  private double held = Double.NaN;

  WatchStep(Ledger ledger, Task task, Situation s) {
    this.ledger = ledger;
    this.task = task;
    kicked = s.time();
    shown = s.ball().seen();
    number = ledger.takeNumber(task.kicker());
  }

  @Override
  public PlayPhase phase() {
    return PlayPhase.WATCH;
  }

  @Override
  public int kicker() {
    return task.kicker();
  }

  @Override
  public Step tick(Situation s) {
    if (s.time() - kicked > 0.5) {
      follow(s);
    }
    receive(s);
    return watch(s);
  }

  @Override
  public boolean isUnderWay() {
    return true;
  }

  /** Until the ball is done. {@inheritDoc} */
  @Override
  public Step watch(Situation s) {
    double since = s.time() - kicked;
    if (s.sees(task.other()) && received(s)) {
      return end(s, End.RECEIVED, task.other());
    }
    BallMemory ball = s.ball();
    if (since > 0.5 && ball.resting() > 0.4) {
      return end(s, End.STOPPED, -1);
    }
    if (left(s)) {
      return end(s, End.LEFT_FIELD, -1);
    }
    if (s.ballUnseen() > LOST) {
      return end(s, End.LOST, -1);
    }
    return since > s.limits().flightTimeout() ? end(s, End.TIMEOUT, -1) : this;
  }

  /** Nobody waits any longer: the kick ends with what was seen of it. */
  Step cut(Situation s) {
    return end(s, End.TIMEOUT, -1);
  }

  private Step end(Situation s, End end, int holder) {
    ledger.made(
        new PlayedKick(
            number,
            task.kick(),
            s.plan().robot(task.kicker()),
            shown,
            task.x(),
            task.y(),
            task.aim(),
            s.time(),
            end));
    return new CheckStep(ledger, holder);
  }

  /** A slow ball will stop on the way: its kicker follows it to kick it again. After any other kick it gets out of the way. */
  private void follow(Situation s) {
    int i = task.kicker();
    double run = task.along(task.receiver().x(), task.receiver().y());
    boolean slow =
        !task.kick().chip() && 0.85 * task.kick().speed() * task.kick().speed() < run - 1;
    double along = Math.max(-0.2, task.along(s.ball().x(), s.ball().y()) - FOLLOW);
    if (slow && along > -0.2) {
      double x = task.x() + along * Math.cos(task.aim());
      double y = task.y() + along * Math.sin(task.aim());
      s.drive(i, new Pose(x, y, task.aim()), s.limits().driveSpeed(), 0.6);
    } else if (!slow) {
      PlayLine line = s.plan().lineOf(task.kick());
      Pose own = new Pose(line.x(i), line.y(i), task.aim());
      s.drive(i, own, s.limits().driveSpeed(), 0.5);
    }
  }

  /** The receiver moves onto the ball's path. */
  private void receive(Situation s) {
    int i = task.other();
    BallMemory ball = s.ball();
    Robot r = s.robot(i);
    double distance = ball.distance(r.x(), r.y());
    // What is seen of a flying ball is not where it is.
    boolean onGround = !task.kick().chip() || s.time() - kicked > 1 && distance < 3;
    double speed = ball.speed();
    if (!onGround || speed < 0.15 || s.ballUnseen() > 0.3) {
      if (distance < 0.4) {
        s.dribble(i);
      } else {
        s.drive(i, task.receiver(), s.limits().driveSpeed(), 0.35);
      }
      return;
    }
    double ux = ball.vx() / speed;
    double uy = ball.vy() / speed;
    double along = (r.x() - ball.x()) * ux + (r.y() - ball.y()) * uy;
    if (along < 0) {
      return;
    }
    double x = ball.x() + along * ux;
    double y = ball.y() + along * uy;
    double facing = Math.atan2(-uy, -ux);
    // Only what is near its place: a ball that goes elsewhere is not chased.
    if (Math.hypot(x - task.receiver().x(), y - task.receiver().y()) < 2.5) {
      s.drive(i, new Pose(x, y, facing), s.limits().driveSpeed(), 0);
    }
    s.dribble(i);
  }

  private boolean received(Situation s) {
    boolean has = s.fromDribbler(task.other()) < 0.06 && s.time() - kicked > 0.3;
    if (!has || s.ball().speed() > 1 && s.ballUnseen() < 0.1) {
      held = Double.NaN;
    } else if (Double.isNaN(held)) {
      held = s.time();
    }
    return s.time() - held > 0.25;
  }

  private boolean left(Situation s) {
    BallMemory ball = s.ball();
    double ahead = Math.min(0.5, s.ballUnseen());
    boolean out = s.area().outside(ball.x() + ahead * ball.vx(), ball.y() + ahead * ball.vy());
    if (!out) {
      outside = Double.NaN;
    } else if (Double.isNaN(outside)) {
      outside = s.time();
    }
    return s.time() - outside > 0.3;
  }
}
