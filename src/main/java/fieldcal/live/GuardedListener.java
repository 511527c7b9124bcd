package fieldcal.live;

import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;

/** Passes everything on to the host's listener; an exception, a stack overflow or a failed assertion of that listener must not end the watching. */
final class GuardedListener implements LiveListener {
  private final LiveListener host;
  private final AtomicLong failures = new AtomicLong();

  GuardedListener(LiveListener host) {
    this.host = Objects.requireNonNull(host, "listener");
  }

  /** Counts a failure outside of the host's listener. */
  void countFailure() {
    failures.incrementAndGet();
  }

  long failures() {
    return failures.get();
  }

  @Override
  public void warningRaised(LiveWarning warning) {
    pass(() -> host.warningRaised(warning));
  }

  @Override
  public void warningCleared(LiveWarning warning) {
    pass(() -> host.warningCleared(warning));
  }

  @Override
  public void kick(LiveKick kick) {
    pass(() -> host.kick(kick));
  }

  @Override
  public void estimate(ParameterEstimate estimate) {
    pass(() -> host.estimate(estimate));
  }

  @Override
  public void limits(Team team, TeamLimits limits) {
    pass(() -> host.limits(team, limits));
  }

  @Override
  public void limitWarningRaised(LimitWarning warning) {
    pass(() -> host.limitWarningRaised(warning));
  }

  @Override
  public void limitWarningCleared(LimitWarning warning) {
    pass(() -> host.limitWarningCleared(warning));
  }

  private void pass(Runnable call) {
    try {
      call.run();
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      failures.incrementAndGet();
    }
  }
}
