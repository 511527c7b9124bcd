package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import java.util.Optional;

/** A robot takes the ball with its dribbler. */
final class FetchStep extends TaskStep {
  private static final int DIRECTIONS = 16;
  private static final double TIMEOUT = 15;

  private final double ballX;
  private final double ballY;
  private final double facing;
  private boolean grabbing;
  private double touching = Double.NaN;

  private FetchStep(Ledger ledger, Task task, double ballX, double ballY, double facing) {
    super(PlayPhase.FETCH, ledger, task);
    this.ballX = ballX;
    this.ballY = ballY;
    this.facing = facing;
  }

  /** Fetching with the first direction that is free; best the one of the kick to come. */
  static Optional<FetchStep> of(Situation s, Ledger ledger, Task task) {
    BallMemory ball = s.ball();
    for (int i = 0; i < DIRECTIONS; i++) {
      // 0, +1, -1, +2, -2 … sixteenths of a turn.
      double offset = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1) * 2 * Math.PI / DIRECTIONS;
      double facing = task.aim() + offset;
      Pose behind = Task.behind(ball.x(), ball.y(), facing, Task.BEHIND);
      boolean free =
          s.area().free(behind.x(), behind.y())
              && s.others().stream().noneMatch(r -> distance(r, behind) < 0.26);
      if (free) {
        return Optional.of(new FetchStep(ledger, task, ball.x(), ball.y(), facing));
      }
    }
    return Optional.empty();
  }

  private static double distance(Robot robot, Pose pose) {
    return Math.hypot(robot.x() - pose.x(), robot.y() - pose.y());
  }

  @Override
  Step tick(Situation s, int i) {
    driveReceiver(s);
    if (age(s) > TIMEOUT) {
      return giveUp(s.plan().robot(i) + " did not get hold of the ball");
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
    boolean gone = s.ball().distance(ballX, ballY) > 0.5 || passed(s.robot(i));
    return gone ? lookAgain() : this;
  }

  private boolean passed(Robot r) {
    double ahead = (ballX - r.x()) * Math.cos(facing) + (ballY - r.y()) * Math.sin(facing);
    return ahead < -0.05;
  }

  private Step approach(Situation s, int i) {
    if (s.ball().distance(ballX, ballY) > 0.08) {
      return lookAgain();
    }
    Pose behind = Task.behind(ballX, ballY, facing, Task.BEHIND);
    s.drive(i, behind, s.limits().driveSpeed(), Task.AROUND);
    Robot r = s.robot(i);
    double turn = Math.IEEEremainder(facing - r.orientation(), 2 * Math.PI);
    boolean clear = s.near(ballX, ballY, 0.22, i).isEmpty();
    if (!clear) {
      s.waitFor("a robot is too close to the ball");
    }
    grabbing = clear && distance(r, behind) < 0.03 && Math.abs(turn) < 0.1 && r.speed() < 0.2;
    return this;
  }
}
