package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import java.util.Optional;

/** Looks where the ball is and decides what to do. Robots stand; one that holds the ball keeps it. */
final class CheckStep implements Step {
  /** A ball that is out of sight for longer does not come back by itself, s. */
  private static final double LOST = 2;

  /** A ball that was seen lying still for longer rests, s. */
  private static final double RESTS = 0.15;

  /** Number of failed attempts to take the ball after which somebody has to place it elsewhere. */
  private static final int FETCHES = 3;

  /** A robot that is in the way is given time to leave by itself, s. */
  private static final double POLITE = 2;

  /** A robot has room to leave when ours are at least this far away, m. */
  private static final double ROOM = 1;

  private final Ledger ledger;
  private final int holder;
  private double since = Double.NaN;

  CheckStep(Ledger ledger, int holder) {
    this.ledger = ledger;
    this.holder = holder;
  }

  @Override
  public PlayPhase phase() {
    return PlayPhase.CHECK;
  }

  @Override
  public Step tick(Situation s) {
    if (Double.isNaN(since)) {
      since = s.passed();
    }
    if (ledger.enough()) {
      s.waitFor("the last kicks are being fitted", WaitingFor.NOTHING);
      return this;
    }
    BallMemory ball = s.ball();
    if (holder >= 0 && s.fromDribbler(holder) < 0.1) {
      s.dribble(holder);
      return withBall(s, ledger.next(s));
    }
    double hidden = ball.known() ? s.ballUnseen() : s.passed() - since;
    if (!ball.known() || hidden > LOST) {
      s.waitFor("the ball is not seen", s.theBall());
      return hidden > LOST ? unseen() : this;
    }
    if (hidden < RESTS) {
      ledger.carries(-1);
    }
    if (!s.area().reachable(ball.x(), ball.y()) && (ball.resting() >= RESTS || hidden > 0.5)) {
      return new HelpStep(ledger, where(s));
    }
    if (ball.resting() < RESTS || hidden > 0.3) {
      s.waitFor(hidden > 0.3 ? "the ball is not seen" : "the ball still moves", s.theBall());
      return s.passed() - since > s.limits().flightTimeout()
          ? new HelpStep(ledger, "the ball does not come to rest")
          : this;
    }
    if (ledger.timesNotFetched() >= FETCHES) {
      return new HelpStep(ledger, ledger.lastReason());
    }
    return next(s, ledger.next(s));
  }

  /** A robot that carried the ball may hide it. */
  private Step unseen() {
    int carrier = ledger.carrier();
    return carrier >= 0
        ? new RevealStep(ledger, carrier)
        : new HelpStep(ledger, "the ball is not seen");
  }

  private Step withBall(Situation s, PlannedKick kick) {
    double x = s.area().placingX(s.ball().x());
    double y = s.area().placingY(s.ball().y());
    Optional<Task> here = Decider.from(s, kick, holder, x, y);
    Optional<Task> task = here.isPresent() ? here : Decider.fromEnd(s, kick, holder);
    if (task.isEmpty()) {
      s.waitFor(
          "somebody is in the way of " + s.plan().robot(holder),
          WaitingFor.robot(s.plan().robot(holder)));
      return new CheckStep(ledger, -1);
    }
    return new PlaceStep(ledger, task.get());
  }

  private Step next(Situation s, PlannedKick kick) {
    Optional<Task> here =
        Decider.withoutCarrying(s, kick, s.ball().x(), s.ball().y(), ledger.pushing(s));
    if (here.isPresent()) {
      return new PositionStep(ledger, here.get());
    }
    int carrier = Decider.carrier(s, kick);
    for (int i : new int[] {carrier, 1 - carrier}) {
      Optional<Task> task = Decider.fromEnd(s, kick, i);
      if (task.isPresent()) {
        Optional<FetchStep> fetch = FetchStep.of(s, ledger, task.get());
        if (fetch.isPresent()) {
          return fetch.get();
        }
      }
    }
    Optional<Robot> third = s.others().stream().filter(r -> near(s, r)).findFirst();
    s.waitFor(
        third.map(r -> r.id() + " is in the way").orElse("no robot can reach the ball"),
        third.map(r -> WaitingFor.robot(r.id())).orElse(s.theBall()));
    if (s.passed() - since > POLITE) {
      third.ifPresent(r -> giveWay(s, r, s.plan().lineOf(kick)));
    }
    return s.passed() - since > 0.25 * s.limits().patience()
        ? new HelpStep(ledger, s.waiting().orElseThrow())
        : this;
  }

  /** A robot that is in the way may be unable to leave because ours stand in its way. */
  private static void giveWay(Situation s, Robot third, PlayLine line) {
    for (int i = 0; i < 2; i++) {
      Robot ours = s.robot(i);
      if (Math.hypot(ours.x() - third.x(), ours.y() - third.y()) < ROOM) {
        double facing = Math.atan2(line.y(1 - i) - line.y(i), line.x(1 - i) - line.x(i));
        Pose end = new Pose(line.x(i), line.y(i), facing);
        s.drive(i, end, s.limits().driveSpeed(), Task.ROUND);
      }
    }
  }

  private static boolean near(Situation s, Robot robot) {
    return s.ball().distance(robot.x(), robot.y()) < 1;
  }

  private static String where(Situation s) {
    BallMemory ball = s.ball();
    boolean goal = s.area().inGoal(ball.x(), ball.y(), 0.12);
    return goal ? "the ball is in the goal" : "the ball is where no robot can reach it";
  }
}
