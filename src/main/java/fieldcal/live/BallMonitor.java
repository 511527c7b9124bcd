package fieldcal.live;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.movement.PlayPhase;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Finds every kick of a match, fits it, and keeps the median of each parameter that kicks determine.
 *
 * <p>Frames, geometry and phases come from one thread and take microseconds; {@link #poll} fits on another, some 10 to 100 ms a kick. The queue between them is bounded. {@link #snapshot} and {@link #samples}
 * may be called from any thread. Partial kicks count for what they determine. After dribbling the ball may spin;
 * then a parameter that spin changes counts only where it agrees with the other kicks ({@link BallParameter#spinSensitive}).
 */
public final class BallMonitor {
  /** With this many samples, flat kicks determine accRoll better than a chip that hardly rolls. */
  private static final int ENOUGH_FOR_CHIPS = 5;

  private static final int REMEMBERED_KICKS = 50;
  private static final int REMEMBERED_PHASES = 64;

  private record PhaseChange(double time, PlayPhase phase) {}

  private final LiveSettings settings;
  private final LiveListener listener;
  private final KickFinder finder;
  private final KickJudge judge;

  // Of the frame thread.
  private final Deque<PhaseChange> phases = new ArrayDeque<>();
  private PlayPhase phase = PlayPhase.UNKNOWN;
  private double now = Double.NEGATIVE_INFINITY;

  // Of the fitting thread, which holds this lock.
  private final Object fitting = new Object();
  private final CameraAlignment alignment = new CameraAlignment();
  private CameraViews aligned;

  // Of both, which hold this lock for a moment only.
  private final Object shared = new Object();
  private final Deque<Kick> queue = new ArrayDeque<>();
  private final Map<BallParameter, ParameterTrack> tracks = new EnumMap<>(BallParameter.class);
  private final Deque<LiveKick> kicks = new ArrayDeque<>();
  private List<CameraCalibration> calibrations = List.of();
  private CameraViews cameras = CameraViews.of(List.of());
  private BallModels published;
  private boolean compare;
  private boolean finishing;
  private long found;
  private long outsidePlay;
  private long dropped;
  private long used;
  private long unused;
  private long spinning;
  private int aside;

  /**
   * Creates a monitor that has seen nothing.
   *
   * @param settings how to watch
   * @param epoch of the frames' times
   * @param listener receives kicks, medians and warnings, in the thread that calls {@link #poll}
   */
  public BallMonitor(LiveSettings settings, Epoch epoch, LiveListener listener) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.listener = Objects.requireNonNull(listener, "listener");
    finder = new KickFinder(settings.kicks(), this::found);
    judge = new KickJudge(settings, epoch);
    published = settings.published().orElse(BallModels.NONE);
    for (BallParameter parameter : BallParameter.values()) {
      tracks.put(parameter, new ParameterTrack(parameter, settings));
    }
  }

  /**
   * Learns the field, the cameras and the published models.
   *
   * @param geometry as published; may come again and may change
   * @param usable the usable cameras, by id
   */
  public void geometry(FieldGeometry geometry, Map<Integer, Camera> usable) {
    finder.geometry(geometry, usable);
    List<CameraView> views = new ArrayList<>();
    geometry
        .cameras()
        .forEach(c -> views.add(CameraView.of(c.id(), Optional.ofNullable(usable.get(c.id())))));
    synchronized (shared) {
      if (!geometry.cameras().equals(calibrations)) {
        calibrations = geometry.cameras();
        cameras = CameraViews.of(views);
        // Those who ask for the cameras' state see the new ones before the next kick.
        compare = true;
      }
      BallModels models =
          settings.published().orElse(new BallModels(geometry.flat(), geometry.chip()));
      compare |= !models.equals(published);
      published = models;
    }
  }

  /**
   * What the referee says from now on: kicks count that begin in play.
   *
   * @param next the phase
   */
  public void phase(PlayPhase next) {
    if (next != phase) {
      phase = Objects.requireNonNull(next, "next");
      phases.addLast(new PhaseChange(now, next));
      if (phases.size() > REMEMBERED_PHASES) {
        phases.removeFirst();
      }
    }
  }

  /**
   * Takes a frame.
   *
   * @param frame of any camera
   */
  public void accept(VisionFrame frame) {
    now = Math.max(now, frame.captureTime());
    finder.accept(frame);
  }

  /** The clock has restarted: kicks under way end, and later frames are on the new clock. */
  public void restart() {
    finder.finish();
    now = Double.NEGATIVE_INFINITY;
    phases.clear();
    phases.addLast(new PhaseChange(now, phase));
  }

  /** No more frames come; the kicks that wait, also those for the cameras' offsets, are fitted by the next calls of {@link #poll}. */
  public void finish() {
    finder.finish();
    synchronized (shared) {
      finishing = true;
    }
  }

  private PlayPhase phaseAt(double time) {
    PlayPhase at = phases.isEmpty() ? phase : PlayPhase.UNKNOWN;
    for (PhaseChange change : phases) {
      if (change.time() <= time) {
        at = change.phase();
      }
    }
    return at;
  }

  private void found(Kick kick) {
    boolean counts = phaseAt(kick.time()).counts();
    synchronized (shared) {
      found++;
      if (!counts) {
        outsidePlay++;
        return;
      }
      queue.addLast(kick);
      if (queue.size() > settings.waitingKicks()) {
        queue.removeFirst();
        dropped++;
      }
    }
  }

  /**
   * Whether {@link #poll} has something to do.
   *
   * @return true when it has
   */
  public boolean hasWork() {
    synchronized (shared) {
      return !queue.isEmpty() || compare || finishing;
    }
  }

  /**
   * Does one piece of the work that takes long: fits the oldest kick that waits.
   *
   * @return false when there was nothing to do
   */
  public boolean poll() {
    synchronized (fitting) {
      Kick kick;
      CameraViews known;
      boolean last;
      boolean anew;
      synchronized (shared) {
        kick = queue.pollFirst();
        known = cameras;
        last = kick == null && finishing;
        anew = compare;
        compare = false;
        finishing &= !last;
      }
      if (kick == null && !last && !anew) {
        return false;
      }
      if (known != aligned) {
        aligned = known;
        int lost = alignment.restart(known);
        synchronized (shared) {
          dropped += lost;
        }
      }
      if (anew) {
        compareAll();
      }
      try {
        if (kick != null) {
          alignment.add(kick).forEach(this::fit);
        } else if (last) {
          alignment.flush().forEach(this::fit);
        }
      } catch (RuntimeException e) {
        // A kick whose processing fails must not end the watching: what was learnt with it is
        // forgotten, and it counts as dropped.
        int lost = alignment.restart(known);
        synchronized (shared) {
          dropped += lost + (kick == null ? 0 : 1);
        }
      }
      synchronized (shared) {
        aside = alignment.waiting();
      }
      return true;
    }
  }

  private void fit(Kick kick) {
    BallModels start;
    OptionalDouble roll;
    synchronized (shared) {
      start = published;
      ParameterEstimate known = tracks.get(BallParameter.ACC_ROLL).estimate(start);
      roll =
          known.samples() >= ENOUGH_FOR_CHIPS
              ? OptionalDouble.of(known.median())
              : OptionalDouble.empty();
    }
    LiveKick judged = judge.judge(kick, alignment.views(), start, roll);
    List<ParameterEstimate> changed = new ArrayList<>();
    synchronized (shared) {
      kicks.addLast(judged);
      if (kicks.size() > REMEMBERED_KICKS) {
        kicks.removeFirst();
      }
      used += judged.unused().isEmpty() ? 1 : 0;
      unused += judged.unused().isEmpty() ? 0 : 1;
      spinning += judged.possiblySpinning() ? 1 : 0;
      judged
          .samples()
          .forEach(
              (parameter, sample) -> {
                tracks.get(parameter).add(sample);
                changed.add(tracks.get(parameter).estimate(published));
              });
    }
    listener.kick(judged);
    changed.forEach(listener::estimate);
    compareAll();
  }

  private void compareAll() {
    // The lock is not held while the listener is told: it may wait for a thread that wants a
    // snapshot.
    for (ParameterTrack track : tracks.values()) {
      Optional<LiveWarning> change;
      boolean on;
      synchronized (shared) {
        change = track.compare(published);
        on = track.warning().isPresent();
      }
      if (on) {
        change.ifPresent(listener::warningRaised);
      } else {
        change.ifPresent(listener::warningCleared);
      }
    }
  }

  /**
   * The samples behind the medians, to be stored or pooled with those of other matches.
   *
   * @return a copy
   */
  public BallSamples samples() {
    Map<BallParameter, List<BallSample>> all = new EnumMap<>(BallParameter.class);
    synchronized (shared) {
      tracks.forEach((parameter, track) -> all.put(parameter, track.samples()));
    }
    return new BallSamples(all);
  }

  /**
   * Adds samples of earlier matches; the newest count, whenever they are added.
   *
   * @param earlier samples
   */
  public void add(BallSamples earlier) {
    synchronized (shared) {
      tracks.forEach((parameter, track) -> earlier.of(parameter).forEach(track::add));
      compare = true;
    }
  }

  /**
   * Why the lens of a camera is not used.
   *
   * @param published the camera
   * @return one clause; empty when its lens fits what it reported, or when too little is known yet
   */
  Optional<String> lensFault(CameraCalibration published) {
    return alignment.views().get(published.id()).camera().flatMap(Camera::fault);
  }

  /**
   * What is known of a camera from the kicks it saw.
   *
   * @param camera its id
   * @return its offset
   */
  CameraAlignment.Known known(int camera) {
    return alignment.known(camera);
  }

  /**
   * What is known now.
   *
   * @return immutable
   */
  public BallSnapshot snapshot() {
    synchronized (shared) {
      KickCounts counts =
          new KickCounts(found, outsidePlay, dropped, queue.size() + aside, used, unused, spinning);
      return new BallSnapshot(
          counts,
          published,
          tracks.values().stream().map(t -> t.estimate(published)).toList(),
          List.copyOf(kicks),
          tracks.values().stream().flatMap(t -> t.warning().stream()).toList());
    }
  }
}
