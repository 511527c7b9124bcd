package fieldcal.play;

/** A robot that may hide the ball from the cameras backs off, and everybody looks again. Nothing else is known of the ball. */
final class RevealStep implements Step {
  /** How far it backs off, m: the way that a robot 0.15 m high hides from a camera 4 m above and 5 m beside it. */
  private static final double SHADOW = 0.2;

  /** Time allowed, s: three times what it takes at the usual speed. */
  private static final double TIMEOUT = 3 * SHADOW / Task.BACK_OFF;

  /** A ball that was seen since then is in sight, s. */
  private static final double IN_SIGHT = 0.1;

  private final Ledger ledger;
  private final int robot;
  private double since = Double.NaN;
  private double x;
  private double y;

  RevealStep(Ledger ledger, int robot) {
    this.ledger = ledger;
    this.robot = robot;
  }

  @Override
  public PlayPhase phase() {
    return PlayPhase.CHECK;
  }

  @Override
  public Step tick(Situation s) {
    double px = s.robot(robot).x();
    double py = s.robot(robot).y();
    if (Double.isNaN(since)) {
      since = s.passed();
      x = px;
      y = py;
    }
    boolean seen = s.ball().known() && s.ballUnseen() < IN_SIGHT;
    if (seen || Math.hypot(px - x, py - y) > SHADOW || s.passed() - since > TIMEOUT) {
      ledger.carries(-1);
      return new CheckStep(ledger, -1);
    }
    s.waitFor("the ball is not seen", s.theBall());
    s.backOff(robot);
    return this;
  }
}
