package fieldcal.app.monitor;

import fieldcal.app.limits.PlayPhases;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.BallSamples;
import fieldcal.live.LimitWarning;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.LiveWarning;
import fieldcal.live.ParameterEstimate;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/** Watches one match from its feed: gives it to a {@link LiveMonitor}, shows it, writes changes and state. Runs once. */
public final class MonitorSession {
  /** The state is made so often for the display at most, ns. */
  private static final long SHOW_EVERY = 100_000_000L;

  private final MonitorRequest request;
  private final MatchFeed feed;
  private final List<LiveListener> listeners = new ArrayList<>();
  private final MatchDisplay display;
  private final LiveMonitor monitor;
  private final Optional<ChangeLog> changes;
  private final AtomicBoolean stop = new AtomicBoolean();
  private volatile Optional<RefereeState> referee = Optional.empty();
  private long shown;

  /**
   * A session.
   *
   * @param request what is wanted
   * @param feed where frames come from; closed by whoever made it
   * @param display who looks on; closed by whoever made it
   * @throws IOException when the state cannot be read or the file of changes not be begun; one line for the operator
   */
  public MonitorSession(MonitorRequest request, MatchFeed feed, MatchDisplay display)
      throws IOException {
    this.request = request;
    this.feed = feed;
    this.display = display;
    if (request.state().isPresent()) {
      StateFile.check(request.state().get());
    }
    BallSamples earlier =
        request.state().isPresent() ? StateFile.read(request.state().get()) : BallSamples.NONE;
    changes =
        request.changes().isPresent()
            ? Optional.of(new ChangeLog(request.changes().get(), feed.status().title()))
            : Optional.empty();
    listeners.add(display);
    changes.ifPresent(listeners::add);
    LiveSettings usual = LiveSettings.defaults();
    LiveSettings settings = feed.suited(request.models().map(usual::withPublished).orElse(usual));
    monitor = new LiveMonitor(settings, feed.epoch(), new Everybody(), feed.executor());
    monitor.add(earlier);
    request.robots().forEach(monitor::configured);
  }

  /** Ends {@link #run} soon; from any thread. */
  public void stop() {
    stop.set(true);
  }

  /**
   * The present state, for those who show it elsewhere; from any thread.
   *
   * @return what there is to show
   */
  public MatchStatus status() {
    return new MatchStatus(monitor.snapshot(), feed.status(), referee);
  }

  /**
   * Watches until the feed ends or {@link #stop} is called, and writes the state.
   *
   * @return the last state
   * @throws IOException when the feed breaks off or a file cannot be written; one line for the operator
   */
  public MatchStatus run() throws IOException {
    display.show(status());
    try {
      feed.run(monitor, new Control());
    } finally {
      monitor.finish();
      // What the feed's executor does not do any more is done here.
      while (monitor.poll()) {
        // Each call does one piece.
      }
    }
    MatchStatus last = status();
    // First of all: a disk that is full must not take that away, too.
    display.summary(last);
    if (request.state().isPresent()) {
      StateFile.write(monitor.samples(), request.state().get());
    }
    if (changes.isPresent()) {
      changes.get().summary(last.snapshot());
      changes.get().close();
    }
    return last;
  }

  /** Passes the feed's news on. */
  private final class Control implements MatchFeed.Control {
    @Override
    public void referee(RefereeState state) {
      boolean changed = referee.isEmpty() || differs(referee.get(), state);
      referee = Optional.of(state);
      PlayPhase phase = PlayPhases.of(state);
      monitor.phase(phase);
      if (changed) {
        double time = feed.epoch().unixSeconds(state.time());
        display.referee(state, time);
        changes.ifPresent(c -> c.referee(state, time, phase));
      }
    }

    private static boolean differs(RefereeState a, RefereeState b) {
      return a.stage() != b.stage()
          || a.command() != b.command()
          || a.commandCounter() != b.commandCounter();
    }

    @Override
    public void refereeLost() {
      referee = Optional.empty();
      monitor.phase(PlayPhase.UNKNOWN);
      display.refereeLost();
      changes.ifPresent(ChangeLog::refereeLost);
    }

    @Override
    public boolean goOn() {
      long now = System.nanoTime();
      if (shown == 0 || now - shown > SHOW_EVERY) {
        shown = now;
        MatchStatus status = status();
        LiveSnapshot s = status.snapshot();
        changes.ifPresent(c -> c.time(s.time()));
        changes.ifPresent(c -> c.vision(!status.feed().silent()));
        display.show(status);
      }
      return !stop.get() && display.watched();
    }
  }

  /** Tells all who listen. */
  private final class Everybody implements LiveListener {
    private void tell(Consumer<LiveListener> what) {
      listeners.forEach(what);
    }

    @Override
    public void warningRaised(LiveWarning warning) {
      tell(l -> l.warningRaised(warning));
    }

    @Override
    public void warningCleared(LiveWarning warning) {
      tell(l -> l.warningCleared(warning));
    }

    @Override
    public void kick(LiveKick kick) {
      tell(l -> l.kick(kick));
    }

    @Override
    public void estimate(ParameterEstimate estimate) {
      tell(l -> l.estimate(estimate));
    }

    @Override
    public void limitWarningRaised(LimitWarning warning) {
      tell(l -> l.limitWarningRaised(warning));
    }

    @Override
    public void limitWarningCleared(LimitWarning warning) {
      tell(l -> l.limitWarningCleared(warning));
    }

    @Override
    public void limits(Team team, TeamLimits limits) {
      tell(l -> l.limits(team, limits));
    }
  }
}
