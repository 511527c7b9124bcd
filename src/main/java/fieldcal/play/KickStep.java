package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;

/** The kicker drives up to the ball with its kicker armed, until the ball leaves. */
final class KickStep implements Step {
  private static final double TIMEOUT = 3;

  private final Ledger ledger;
  private final Task task;
  private double since = Double.NaN;

  KickStep(Ledger ledger, Task task) {
    this.ledger = ledger;
    this.task = task;
  }

  @Override
  public PlayPhase phase() {
    return PlayPhase.KICK;
  }

  @Override
  public int kicker() {
    return task.kicker();
  }

  @Override
  public Step tick(Situation s) {
    if (Double.isNaN(since)) {
      since = s.time();
    }
    int i = task.kicker();
    double moved = s.ball().distance(task.x(), task.y());
    double fast = Math.max(0.5, 0.3 * task.kick().speed() * Math.cos(task.kick().elevation()));
    if (moved > 0.06 && s.ball().speed() > fast) {
      return new WatchStep(ledger, task, s.time());
    }
    s.drive(task.other(), task.receiver(), s.limits().driveSpeed(), 0.35);
    Robot r = s.robot(i);
    boolean passed = task.along(r.x(), r.y()) > -0.03;
    if (passed || s.time() - since > TIMEOUT) {
      ledger.failed(s.plan().robot(i) + " did not kick");
      return new CheckStep(ledger, -1);
    }
    if (moved > 0.2) {
      ledger.failed(s.plan().robot(i) + " only pushed the ball");
      return new CheckStep(ledger, -1);
    }
    double aside = Math.max(-0.1, Math.min(0.1, -3 * task.aside(r.x(), r.y())));
    double cos = Math.cos(task.aim());
    double sin = Math.sin(task.aim());
    double speed = s.limits().creepSpeed();
    s.creep(i, speed * cos - aside * sin, speed * sin + aside * cos, task.aim());
    s.arm(i, task.order());
    return this;
  }
}
