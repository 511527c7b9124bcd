package fieldcal.play;

/** Somebody has to lay the ball down; the robots stand still until it lies where they can get at it. */
final class HelpStep implements Step {
  private static final double[] PLACES = {0.05, 0.3, 0.5, 0.7, 0.95, 0.15, 0.85};

  private final Ledger ledger;
  private final String reason;
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
      since = s.time();
    }
    if (Double.isNaN(x)) {
      choosePlace(s);
    }
    BallMemory ball = s.ball();
    boolean back = ball.known() && s.ballUnseen() < 0.2 && ball.resting() > 0.3;
    if (back && s.area().reachable(ball.x(), ball.y()) && s.time() - since > 0.5) {
      return new CheckStep(ledger, -1);
    }
    if (s.time() - since > s.limits().patience()) {
      return new EndStep(PlayPhase.STOPPED, reason + "; nobody laid it down");
    }
    s.request(x, y, reason);
    return this;
  }

  /** On the line of the next kick, away from all robots. */
  private void choosePlace(Situation s) {
    PlayLine line = s.plan().lineOf(ledger.next(s.ball()));
    for (double share : PLACES) {
      double px = line.x0() + share * (line.x1() - line.x0());
      double py = line.y0() + share * (line.y1() - line.y0());
      if (Double.isNaN(x) || s.near(x, y, 0.6, 0).isPresent() || s.near(x, y, 0.6, 1).isPresent()) {
        x = px;
        y = py;
      }
    }
  }
}
