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
 *
 * <p>A kick whose fit throws an exception, a {@link StackOverflowError} or an {@link AssertionError} is lost and counts as dropped; the others are fitted. See {@link #poll} for other errors.
 */
public final class BallMonitor {
  /** With this many samples, flat kicks determine accRoll better than a chip that hardly rolls. */
  private static final int ENOUGH_FOR_CHIPS = 5;

  private static final int REMEMBERED_KICKS = 50;
  private static final int REMEMBERED_PHASES = 64;

  private record PhaseChange(double time, PlayPhase phase) {}

  /** Fits a kick and decides what it determines: {@link KickJudge}, or what a test puts in its place. */
  interface Judge {
    /** See {@link KickJudge#judge}. */
    LiveKick judge(Kick kick, CameraViews cameras, BallModels start, OptionalDouble roll);
  }

  private final LiveSettings settings;
  private final LiveListener listener;
  private final KickFinder finder;
  private final Judge judge;

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
    this(settings, listener, new KickJudge(settings, epoch)::judge);
  }

  /** With another judge. */
  BallMonitor(LiveSettings settings, LiveListener listener, Judge judge) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.listener = Objects.requireNonNull(listener, "listener");
    finder = new KickFinder(settings.kicks(), this::found);
    this.judge = judge;
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
   * Does one piece of the work that takes long: fits the oldest kick that waits, and those that waited for it. Throws nothing but an error that is the machine's, such as an {@link OutOfMemoryError}:
   * the kicks of this piece then count as dropped, and the next call goes on with the next kick.
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
        drop(alignment.restart(known));
      }
      if (anew) {
        compareAll();
      }
      try {
        fitAll(kick != null ? align(kick, known) : last ? alignment.flush() : List.of());
      } finally {
        synchronized (shared) {
          aside = alignment.waiting();
        }
      }
      return true;
    }
  }

  /** Those that can be judged now. What was learnt with a kick that breaks this is forgotten, since it would break it again. */
  private List<Kick> align(Kick kick, CameraViews known) {
    try {
      return alignment.add(kick);
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      drop(1 + alignment.restart(known));
      return List.of();
    } catch (Error e) {
      drop(1 + alignment.restart(known));
      throw e;
    }
  }

  private void drop(int lost) {
    synchronized (shared) {
      dropped += lost;
    }
  }

  private void fitAll(List<Kick> ready) {
    int left = ready.size();
    try {
      for (Kick kick : ready) {
        fit(kick);
        left--;
      }
    } finally {
      // None, but after an error that is for the host.
      drop(left);
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
    LiveKick judged;
    try {
      judged = judge.judge(kick, alignment.views(), start, roll);
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      // It costs this kick and must not end the watching.
      drop(1);
      return;
    }
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
