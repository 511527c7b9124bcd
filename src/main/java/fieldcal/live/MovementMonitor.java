package fieldcal.live;

import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementObserver;
import fieldcal.movement.MovementStatistics;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Epoch;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Measures the movement limits of both teams while they play, whether the robots are the host's own or not. It only reports and changes nothing.
 *
 * <p>Frames and phases come from one thread; {@link #poll} estimates on another, some tenths of a second each time. In breaks and timeouts, when robots may be changed, counting begins again; the last estimate
 * before stays beside the new one. Without a referee everything counts. {@link #snapshot} may be called from any thread.
 */
public final class MovementMonitor {
  private final LiveSettings settings;
  private final Epoch epoch;
  private final LiveListener listener;
  private final MovementObserver observer = new MovementObserver();

  // Of the frame thread.
  private PlayPhase phase = PlayPhase.UNKNOWN;
  private double now = Double.NaN;
  private double due = Double.NaN;
  private long countedBefore;

  // Of the estimating thread, which holds this lock.
  private final Object estimating = new Object();

  // Of both, which hold this lock for a moment only.
  private final Object shared = new Object();
  private final Map<Team, TeamLimits> limits = new EnumMap<>(Team.class);
  private final Map<Team, TeamLimits> beforeBreak = new EnumMap<>(Team.class);
  private final Map<Team, LimitWatch> watches = new EnumMap<>(Team.class);
  private Request waiting;
  private Request waitingForBreak;
  private double countingSince = Double.NaN;
  private double estimatedAt = Double.NaN;
  private int breaks;
  private long counted;
  private long refused;
  private double noise = Double.NaN;

  /** Statistics that wait to be estimated from. */
  private record Request(MovementStatistics statistics, double time) {}

  /**
   * Creates a monitor that has seen nothing.
   *
   * @param settings how often to estimate
   * @param epoch of the frames' times
   * @param listener receives new estimates, in the thread that calls {@link #poll}
   */
  public MovementMonitor(LiveSettings settings, Epoch epoch, LiveListener listener) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.epoch = Objects.requireNonNull(epoch, "epoch");
    this.listener = Objects.requireNonNull(listener, "listener");
    for (Team team : Team.values()) {
      watches.put(team, new LimitWatch(team, settings));
    }
  }

  /**
   * What the referee says from now on.
   *
   * @param next the phase
   */
  public void phase(PlayPhase next) {
    if (next == phase) {
      return;
    }
    observer.phase(next);
    phase = next;
    if (next == PlayPhase.BREAK) {
      Request last = request();
      observer.clear();
      countedBefore = 0;
      synchronized (shared) {
        waiting = null;
        waitingForBreak = last;
        breaks++;
        counted = 0;
        refused = 0;
        countingSince = epoch.unixSeconds(now);
      }
    }
  }

  /**
   * What the robots of a team are configured to do; compared from the next estimate on.
   *
   * @param team which
   * @param configured what is configured
   */
  public void configured(Team team, ConfiguredLimits configured) {
    synchronized (shared) {
      watches.get(team).configure(configured);
    }
  }

  /**
   * Takes a frame.
   *
   * @param frame of any camera
   */
  public void accept(VisionFrame frame) {
    observer.accept(frame);
    double time = frame.captureTime();
    if (Double.isNaN(now)) {
      due = time + settings.limitsInterval();
      synchronized (shared) {
        countingSince = epoch.unixSeconds(time);
      }
    }
    now = time;
    if (time >= due) {
      due = time + settings.limitsInterval();
      ask();
    }
  }

  /** The clock has restarted: no movement connects earlier frames with later ones. */
  public void restart() {
    observer.finish();
    due = Double.NEGATIVE_INFINITY;
  }

  /** No more frames come: what is under way is counted, and {@link #poll} estimates a last time. */
  public void finish() {
    observer.finish();
    ask();
  }

  private void ask() {
    long total = observer.statistics().counted();
    if (total == countedBefore) {
      return;
    }
    countedBefore = total;
    Request next = request();
    synchronized (shared) {
      // An older request that has not been served yet is obsolete.
      waiting = next;
      counted = total;
      refused = observer.statistics().refused();
      noise = observer.noiseKnown() ? 1000 * observer.noise() : Double.NaN;
    }
  }

  private Request request() {
    MovementStatistics copy = new MovementStatistics();
    copy.merge(observer.statistics());
    return new Request(copy, now);
  }

  /**
   * Whether {@link #poll} has something to do.
   *
   * @return true when it has
   */
  public boolean hasWork() {
    synchronized (shared) {
      return waiting != null || waitingForBreak != null;
    }
  }

  /**
   * Does one piece of the work that takes long: estimates the limits of both teams.
   *
   * @return false when there was nothing to do
   */
  public boolean poll() {
    synchronized (estimating) {
      Request request;
      boolean forBreak;
      synchronized (shared) {
        forBreak = waitingForBreak != null;
        request = forBreak ? waitingForBreak : waiting;
        if (forBreak) {
          waitingForBreak = null;
        } else {
          waiting = null;
        }
      }
      if (request == null) {
        return false;
      }
      for (Team team : Team.values()) {
        TeamLimits next = LimitEstimator.estimate(team, request.statistics().of(team));
        synchronized (shared) {
          if (forBreak) {
            limits.remove(team);
            // When there was little play since the last break, the estimate before that break is
            // better.
            if (next.velocity().known() || !beforeBreak.containsKey(team)) {
              beforeBreak.put(team, next);
            }
          } else {
            limits.put(team, next);
          }
          estimatedAt = epoch.unixSeconds(request.time());
        }
        listener.limits(team, next);
        compare(team, next, epoch.unixSeconds(request.time()));
      }
      return true;
    }
  }

  private void compare(Team team, TeamLimits limits, double time) {
    LimitWatch watch = watches.get(team);
    List<LimitWarning> begun = new ArrayList<>();
    List<LimitWarning> ended = new ArrayList<>();
    synchronized (shared) {
      for (LimitWarning change : watch.compare(limits, time)) {
        (watch.isOn(change) ? begun : ended).add(change);
      }
    }
    begun.forEach(listener::limitWarningRaised);
    ended.forEach(listener::limitWarningCleared);
  }

  /**
   * What is known now.
   *
   * @return immutable
   */
  public MovementSnapshot snapshot() {
    synchronized (shared) {
      return new MovementSnapshot(
          limits,
          beforeBreak,
          countingSince,
          estimatedAt,
          breaks,
          counted,
          refused,
          watches.values().stream().flatMap(w -> w.warnings().stream()).toList(),
          noise);
    }
  }
}
