package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import java.util.Locale;
import java.util.Optional;

/** Kicker and receiver drive to their places; then everything has to be calm. */
final class PositionStep extends TaskStep {
  private static final double TIMEOUT = 15;

  /** When a robot stands in the way for longer, the kick goes past it in another direction, s. */
  private static final double BLOCKED = 3;

  /** A robot that takes longer to get behind the ball is waited for, s; the operator is told. */
  private static final double SLOW = 5;

  /** A ball that was not seen for longer may lie elsewhere by now: nobody drives up to it, s. */
  private static final double SEEN = 0.2;

  private final Swing[] swings = {new Swing(), new Swing()};
  private double blocked = Double.NaN;

  PositionStep(Ledger ledger, Task task) {
    super(PlayPhase.POSITION, ledger, task);
  }

  @Override
  Step tick(Situation s, int i) {
    s.drive(i, task.behind(), s.limits().driveSpeed(), Task.AROUND);
    driveReceiver(s);
    if (s.ballUnseen() > 0.5) {
      return lookAgain("the ball was not seen any more");
    }
    if (s.ball().distance(task.x(), task.y()) > 0.05) {
      return movedAway("the ball moved before " + s.plan().robot(i) + " was behind it");
    }
    boolean ready = ready(s);
    watchSwings(s);
    if (age(s) > TIMEOUT || s.time() - blocked > BLOCKED) {
      String late = s.waiting().orElse(s.plan().robot(i) + " did not get behind the ball");
      boolean aboutKicker = s.waitingFor().robot().map(s.plan().robot(i)::equals).orElse(true);
      return giveUp(aboutKicker ? late + measured(s) : late);
    }
    return ready ? new KickStep(ledger, task) : this;
  }

  private void watchSwings(Situation s) {
    for (int i = 0; i < 2; i++) {
      double wanted = i == task.kicker() ? task.aim() : task.receiver().orientation();
      swings[i].look(Math.IEEEremainder(s.robot(i).orientation() - wanted, 2 * Math.PI));
      if (swings[i].swings() && age(s) > SLOW) {
        s.waitForLate("swings around its target", i);
      }
    }
  }

  /** Where vision sees the kicker, for the operator who has to find out what is wrong. */
  private String measured(Situation s) {
    Robot r = s.robot(task.kicker());
    double turn = Math.IEEEremainder(task.aim() - r.orientation(), 2 * Math.PI);
    return String.format(
        Locale.ROOT,
        " (%s: %.0f mm behind the ball, %.0f mm to the side, turned by %.1f°, %.2f m/s)",
        r.id(),
        -1000 * task.along(r.x(), r.y()),
        1000 * Math.abs(task.aside(r.x(), r.y())),
        Math.toDegrees(Math.abs(turn)),
        r.speed());
  }

  private boolean ready(Situation s) {
    Robot kicker = s.robot(task.kicker());
    Robot receiver = s.robot(task.other());
    double distance = Math.min(3, task.along(task.receiver().x(), task.receiver().y()));
    Optional<Robot> third = Decider.inTheWay(s, task, distance);
    if (third.isPresent()) {
      s.waitFor(
          third.get().id() + " is in the way of the kick", WaitingFor.robot(third.get().id()));
      blocked = Double.isNaN(blocked) ? s.time() : blocked;
      return false;
    }
    blocked = Double.NaN;
    double aside = Math.abs(task.aside(kicker.x(), kicker.y()));
    double behind = -task.along(kicker.x(), kicker.y());
    double turn = Math.IEEEremainder(task.aim() - kicker.orientation(), 2 * Math.PI);
    String amiss =
        aside >= 0.015
            ? "stands beside the line of the kick"
            : behind <= 0.12
                ? "stands too near to the ball"
                : behind >= 0.21
                    ? "is not behind the ball"
                    : Math.abs(turn) >= 0.02
                        ? "does not face the ball"
                        : kicker.speed() >= 0.08 ? "does not stand still" : "";
    boolean placed = amiss.isEmpty();
    if (!placed && age(s) > SLOW) {
      s.waitFor(s.plan().robot(task.kicker()) + " " + amiss, WaitingFor.robot(kicker.id()));
    }
    double off = Math.hypot(receiver.x() - task.receiver().x(), receiver.y() - task.receiver().y());
    boolean late = age(s) > 8;
    boolean received = off < (late ? 0.6 : 0.15) && receiver.speed() < 0.3;
    if (placed && !received) {
      s.waitFor(
          s.plan().robot(task.other()) + " is not in its place yet",
          WaitingFor.robot(receiver.id()).at(task.receiver().x(), task.receiver().y()));
    }
    boolean seen = s.ballUnseen() < SEEN;
    if (placed && received && !seen) {
      s.waitFor("the ball is not seen", WaitingFor.place(task.x(), task.y()));
    }
    boolean stands = placed && received && seen;
    Optional<String> charges = ledger.charges(task.kicker(), s.time());
    boolean rests = s.ball().resting() > s.limits().settle();
    if (stands && charges.isPresent()) {
      s.waitFor(charges.get() + "; trying again", WaitingFor.robot(kicker.id()));
    } else if (stands && !rests && age(s) > SLOW) {
      s.waitFor("the ball does not lie still", WaitingFor.place(task.x(), task.y()));
    }
    return stands && charges.isEmpty() && rests;
  }
}
