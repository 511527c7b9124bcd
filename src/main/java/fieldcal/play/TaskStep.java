package fieldcal.play;

/** A step of one kick: the kicker is at work, the other robot goes to where it receives. Remembers when it began. */
abstract class TaskStep implements Step {
  final Ledger ledger;
  final Task task;
  private final PlayPhase phase;
  private double since = Double.NaN;

  TaskStep(PlayPhase phase, Ledger ledger, Task task) {
    this.phase = phase;
    this.ledger = ledger;
    this.task = task;
  }

  @Override
  public final PlayPhase phase() {
    return phase;
  }

  @Override
  public final int kicker() {
    return task.kicker();
  }

  @Override
  public final Step tick(Situation s) {
    if (Double.isNaN(since)) {
      since = s.passed();
    }
    return tick(s, task.kicker());
  }

  /** The step of the next tick, as {@link Step#tick}. */
  abstract Step tick(Situation s, int kicker);

  /** For how long it goes on, s. */
  final double age(Situation s) {
    return s.passed() - since;
  }

  /** Sends the other robot to where it receives. */
  final void driveReceiver(Situation s) {
    s.drive(task.other(), task.receiver(), s.limits().driveSpeed(), Task.ROUND);
  }

  /** It did not work: looks again what to do. */
  final Step giveUp(String reason) {
    ledger.failed(reason);
    return lookAgain();
  }

  /** The kicker was fired and the ball did not move: decides again what to do. It is not the kicker's fault when the robot did not move. */
  final Step misfired(Situation s, String reason) {
    if (s.hardlyMoves(task.kicker())) {
      return giveUp(s.doesNotMove(task.kicker()));
    }
    ledger.misfired(task.kicker(), reason, s.time());
    return lookAgain();
  }

  /** Somebody or something moved the ball: looks again what to do. */
  final Step lookAgain(String reason) {
    ledger.remember(reason);
    return lookAgain();
  }

  /** The ball moved away from the robot that drove to it: looks again what to do. When this happens repeatedly, the ball sticks to a robot, or robots push it. */
  final Step movedAway(String reason) {
    ledger.movedAway(reason);
    return lookAgain();
  }

  final Step lookAgain() {
    return new CheckStep(ledger, -1);
  }
}
