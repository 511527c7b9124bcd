package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;

/** The kicker drives up to the ball with its kicker armed, until the ball leaves. */
final class KickStep extends TaskStep {
  private static final double TIMEOUT = 3;

  /** A slow ball farther from the dribbler was not pushed there by it, m. */
  private static final double ELSEWHERE = 0.5;

  /**
   * Longest time after it was disarmed in which a kicker of a robot that hears no later than usual may still fire, s: 70 ms until a slow robot hears of it, 60 ms until the ball is seen to leave, and
   * three frames that show its speed.
   */
  private static final double ON_ITS_WAY = 0.2;

  private double disarmed = Double.NaN;
  private String reason;
  private boolean interrupted;

  KickStep(Ledger ledger, Task task) {
    super(PlayPhase.KICK, ledger, task);
  }

  @Override
  Step tick(Situation s, int i) {
    double moved = s.ball().distance(task.x(), task.y());
    if (interrupted) {
      driveReceiver(s);
      return watch(s);
    }
    if (isKicked(s)) {
      return new WatchStep(ledger, task, s);
    }
    driveReceiver(s);
    if (!Double.isNaN(disarmed)) {
      return mayFire(s) ? this : misfired(s, reason);
    }
    Robot r = s.robot(i);
    boolean passed = task.along(r.x(), r.y()) > -0.03;
    if (passed || age(s) > TIMEOUT) {
      return disarm(s, s.plan().robot(i) + " did not kick");
    }
    if (moved > 0.2 && s.fromDribbler(i) > ELSEWHERE) {
      return lookAgain("somebody moved the ball before " + s.plan().robot(i) + " kicked it");
    }
    if (moved > 0.2) {
      return disarm(s, s.plan().robot(i) + " only pushed the ball");
    }
    double aside = Math.max(-0.1, Math.min(0.1, -3 * task.aside(r.x(), r.y())));
    double cos = Math.cos(task.aim());
    double sin = Math.sin(task.aim());
    double speed = s.limits().creepSpeed();
    s.creep(i, speed * cos - aside * sin, speed * sin + aside * cos, task.aim());
    s.arm(i, task.order());
    return this;
  }

  private boolean isKicked(Situation s) {
    double moved = s.ball().distance(task.x(), task.y());
    double fast = Math.max(0.5, 0.3 * task.kick().speed() * Math.cos(task.kick().elevation()));
    return mayFire(s) && moved > 0.06 && s.ball().speed() > fast;
  }

  /** Whether a kick that was ordered before it was disarmed may still come to light: what counts is the time that vision has shown, which is late, or stands still while vision is silent. */
  private boolean mayFire(Situation s) {
    return !(s.world().visionTime() - disarmed > ON_ITS_WAY + s.heardLate(task.kicker()));
  }

  @Override
  public boolean isUnderWay() {
    return true;
  }

  /** The kicker may have fired before it heard that it must not. {@inheritDoc} */
  @Override
  public Step watch(Situation s) {
    if (!interrupted) {
      interrupted = true;
      disarmed = Double.isNaN(disarmed) ? s.time() : disarmed;
    }
    if (isKicked(s)) {
      return new WatchStep(ledger, task, s);
    }
    return mayFire(s) ? this : lookAgain();
  }

  /** The robot stands, disarmed. A kick that still happens counts as one. */
  private Step disarm(Situation s, String why) {
    disarmed = s.time();
    reason = why;
    return this;
  }
}
