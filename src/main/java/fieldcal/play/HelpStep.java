package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import java.util.Optional;

/** Somebody has to place the ball; the robots stand still until it lies where they can get at it. */
final class HelpStep implements Step {
  private static final double[] PLACES = {0.05, 0.3, 0.5, 0.7, 0.95, 0.15, 0.85};

  /** A ball that lies farther away than this was placed elsewhere, m. */
  private static final double ELSEWHERE = 0.3;

  /** Robots nearer to the ball may be the reason why it cannot be reached, m. */
  private static final double CROWD = 1;

  private final Ledger ledger;
  private final String reason;
  private boolean reachable;
  private boolean crowded;
  private double ballX;
  private double ballY;
  private double since = Double.NaN;
  private double x = Double.NaN;
  private double y;

  HelpStep(Ledger ledger, String reason) {
    this.ledger = ledger;
    this.reason = reason;
  }

  @Override
  public PlayPhase phase() {
    return PlayPhase.FETCH;
  }

  @Override
  public Step tick(Situation s) {
    if (Double.isNaN(since)) {
      begin(s);
    }
    BallMemory ball = s.ball();
    boolean back = ball.known() && s.ballUnseen() < 0.2 && ball.resting() > 0.3;
    boolean well = back && s.area().reachable(ball.x(), ball.y()) && s.passed() - since > 0.5;
    // A ball that could be reached but was not taken must have been moved, unless the robots that
    // stood around it have left.
    boolean helped = !reachable || ball.distance(ballX, ballY) > ELSEWHERE;
    if (well && (helped || crowded && !isCrowded(s))) {
      ledger.helped();
      return new CheckStep(ledger, -1);
    }
    if (s.passed() - since > s.limits().patience()) {
      return new EndStep(PlayPhase.STOPPED, reason + "; nobody placed the ball");
    }
    s.request(x, y, reason);
    return this;
  }

  private void begin(Situation s) {
    since = s.passed();
    BallMemory ball = s.ball();
    ballX = ball.x();
    ballY = ball.y();
    reachable = ball.known() && s.ballUnseen() < 0.5 && s.area().reachable(ballX, ballY);
    crowded = isCrowded(s);
    choosePlace(s);
  }

  private boolean isCrowded(Situation s) {
    return s.others().stream().anyMatch(r -> Math.hypot(r.x() - ballX, r.y() - ballY) < CROWD);
  }

  /** Chooses a place on the line of the next kick, away from all robots and from where the ball could not be reached, where a robot can kick it soonest. */
  private void choosePlace(Situation s) {
    PlannedKick kick = ledger.next(s);
    PlayLine line = s.plan().lineOf(kick);
    double least = Double.POSITIVE_INFINITY;
    for (double share : PLACES) {
      double px = line.x0() + share * (line.x1() - line.x0());
      double py = line.y0() + share * (line.y1() - line.y0());
      boolean free = isFree(s, px, py);
      double drive = free ? drive(s, kick, px, py) : Double.POSITIVE_INFINITY;
      if (Double.isNaN(x) || drive < least || free && !isFree(s, x, y)) {
        x = px;
        y = py;
        least = drive;
      }
    }
  }

  /** How far the robots have to drive until one can kick from there and the other receive, the farther of the two, m; infinite when neither can kick. */
  private static double drive(Situation s, PlannedKick kick, double px, double py) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 2; i++) {
      Optional<Task> task = Decider.from(s, kick, i, px, py);
      if (!s.stuck(i) && task.isPresent()) {
        double kicker = distance(s.robot(i), task.get().behind());
        double receiver = distance(s.robot(1 - i), task.get().receiver());
        least = Math.min(least, Math.max(kicker, receiver));
      }
    }
    return least;
  }

  private static double distance(Robot robot, Pose pose) {
    return Math.hypot(robot.x() - pose.x(), robot.y() - pose.y());
  }

  private boolean isFree(Situation s, double px, double py) {
    boolean elsewhere = !reachable || Math.hypot(px - ballX, py - ballY) > 2 * ELSEWHERE;
    return elsewhere && s.near(px, py, 0.6, 0).isEmpty() && s.near(px, py, 0.6, 1).isEmpty();
  }
}
