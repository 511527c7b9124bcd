package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import java.util.List;
import java.util.Optional;

/** A robot takes the ball with its dribbler. */
final class FetchStep extends TaskStep {
  private static final int DIRECTIONS = 16;
  private static final double TIMEOUT = 15;

  /** Least distance between the centres of a robot that takes the ball and of any other, m. */
  private static final double APART = 0.26;

  /** A robot whose centre is nearer to the ball touches it, m. */
  private static final double TOUCHES = 0.125;

  /** A robot that stands too close, or in the only way, for longer is avoided by taking another direction, s. */
  private static final double BLOCKED = 3;

  /** A ball that lies nearer to its place is fetched from the direction of the kick instead of being pushed there, m. */
  private static final double PUSHED = 0.15;

  private final double ballX;
  private final double ballY;
  private final double facing;
  private boolean grabbing;
  private double touching = Double.NaN;
  private double blocked = Double.NaN;

  private FetchStep(Ledger ledger, Task task, double ballX, double ballY, double facing) {
    super(PlayPhase.FETCH, ledger, task);
    this.ballX = ballX;
    this.ballY = ballY;
    this.facing = facing;
  }

  /** Fetching from the first direction that is free, beginning with that of the next kick. */
  static Optional<FetchStep> of(Situation s, Ledger ledger, Task task) {
    BallMemory ball = s.ball();
    double toX = task.x() - ball.x();
    double toY = task.y() - ball.y();
    // A robot that has lost the ball before pushes it to its place.
    boolean pushes =
        ledger.grip(task.kicker(), true, s.limits()).gentle() && Math.hypot(toX, toY) > PUSHED;
    double best = pushes ? Math.atan2(toY, toX) : task.aim();
    FetchStep barred = null;
    for (int i = 0; i < DIRECTIONS; i++) {
      // 0, +1, -1, +2, -2 … sixteenths of a turn.
      double offset = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1) * 2 * Math.PI / DIRECTIONS;
      double facing = best + offset;
      Pose behind = Task.behind(ball.x(), ball.y(), facing, Task.BEHIND);
      boolean room = s.area().free(behind.x(), behind.y());
      if (room && inTheWay(s.others(), ball.x(), ball.y(), facing).isEmpty()) {
        FetchStep fetch = new FetchStep(ledger, task, ball.x(), ball.y(), facing);
        if (s.hasWay(task.kicker(), behind, Task.AROUND)) {
          return Optional.of(fetch);
        }
        barred = barred == null ? fetch : barred;
      }
    }
    // The robot that is in the way may leave.
    return Optional.ofNullable(barred);
  }

  /** A robot without which there would be room to drive up to the ball and take it. One beyond the ball may be near it. */
  private static Optional<Robot> inTheWay(List<Robot> robots, double x, double y, double facing) {
    Pose behind = Task.behind(x, y, facing, Task.BEHIND);
    Pose taking = Task.behind(x, y, facing, PlayArea.AT_DRIBBLER);
    return robots.stream()
        .filter(
            r ->
                distance(r, behind) < APART
                    || distance(r, taking) < APART
                    || Math.hypot(r.x() - x, r.y() - y) < TOUCHES)
        .findFirst();
  }

  private static double distance(Robot robot, Pose pose) {
    return Math.hypot(robot.x() - pose.x(), robot.y() - pose.y());
  }

  @Override
  Step tick(Situation s, int i) {
    driveReceiver(s);
    if (age(s) > TIMEOUT) {
      return notFetched(s.plan().robot(i) + " did not get hold of the ball");
    }
    if (!grabbing) {
      return approach(s, i);
    }
    s.dribble(i);
    s.creep(
        i,
        s.limits().creepSpeed() * Math.cos(facing),
        s.limits().creepSpeed() * Math.sin(facing),
        facing);
    boolean has = s.fromDribbler(i) < 0.03 || s.ballUnseen() > 0.2;
    if (!has) {
      touching = Double.NaN;
    } else if (Double.isNaN(touching)) {
      touching = s.time();
    } else if (s.time() - touching > 0.2) {
      return new PlaceStep(ledger, task);
    }
    if (passed(s.robot(i))) {
      return notFetched(s.plan().robot(i) + " drove past the ball without getting hold of it");
    }
    boolean gone = s.ball().distance(ballX, ballY) > 0.5;
    return gone ? movedAway("the ball rolled away from " + s.plan().robot(i)) : this;
  }

  private Step notFetched(String reason) {
    ledger.notFetched();
    return giveUp(reason);
  }

  private boolean passed(Robot r) {
    double ahead = (ballX - r.x()) * Math.cos(facing) + (ballY - r.y()) * Math.sin(facing);
    return ahead < -0.05;
  }

  private Step approach(Situation s, int i) {
    if (s.ball().distance(ballX, ballY) > 0.08) {
      return movedAway("the ball moved before " + s.plan().robot(i) + " reached it");
    }
    Pose behind = Task.behind(ballX, ballY, facing, Task.BEHIND);
    boolean hasWay = s.drive(i, behind, s.limits().driveSpeed(), Task.AROUND);
    Robot r = s.robot(i);
    double turn = Math.IEEEremainder(facing - r.orientation(), 2 * Math.PI);
    Optional<Robot> close = inTheWay(s.except(i), ballX, ballY, facing);
    close.ifPresent(c -> s.waitFor(c.id() + " is too close to the ball", WaitingFor.robot(c.id())));
    if (hasWay && close.isEmpty()) {
      blocked = Double.NaN;
    } else if (Double.isNaN(blocked)) {
      blocked = s.time();
    } else if (s.time() - blocked > BLOCKED) {
      return notFetched(s.waiting().orElseThrow());
    }
    grabbing =
        close.isEmpty() && distance(r, behind) < 0.03 && Math.abs(turn) < 0.1 && r.speed() < 0.2;
    return this;
  }
}
