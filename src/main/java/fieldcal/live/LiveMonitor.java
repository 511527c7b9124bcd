package fieldcal.live;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.movement.PlayPhase;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;

/**
 * Watches a match: the ball, the robots, the cameras.
 *
 * <p>One thread gives it geometry, phases and frames as they come; that takes microseconds and never waits for a fit. What takes long runs on the host's executor, one task at a time, or, without one, in {@link
 * #poll}, which any other thread calls whenever it likes. {@link #snapshot}, {@link #samples} and {@link #add} may be called from any thread. It never throws on bad frames.
 *
 * <p>A fit that throws an exception, a {@link StackOverflowError} or an {@link AssertionError} costs one kick. Any other error, such as an {@link OutOfMemoryError}, is the machine's, and the host must hear of it: it is thrown
 * out of {@link #poll}, or out of the task on the executor. The kick counts as dropped; the next frame or call of {@link #poll} goes on with the next one.
 */
public final class LiveMonitor {
  private final GuardedListener listener;
  private final Epoch epoch;
  private final Optional<Executor> executor;
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final Object working = new Object();
  private final BallMonitor ball;
  private final MovementMonitor movement;

  // Of the frame thread and of those that want a snapshot, which hold this lock for a moment only.
  private final Object shared = new Object();
  private final FrameGuard guard = new FrameGuard();
  private final Map<Integer, CameraWatch> cameras = new TreeMap<>();
  private FieldGeometry field;
  private PlayPhase phase = PlayPhase.UNKNOWN;
  private long frames;
  private long stray;
  private long jumps;

  /**
   * Creates a monitor without an executor; the host calls {@link #poll}.
   *
   * @param settings how to watch
   * @param epoch of the frames' times
   * @param listener receives what changes
   */
  public LiveMonitor(LiveSettings settings, Epoch epoch, LiveListener listener) {
    this(settings, epoch, listener, Optional.empty());
  }

  /**
   * Creates a monitor with an executor.
   *
   * @param settings how to watch
   * @param epoch of the frames' times
   * @param listener receives what changes
   * @param executor runs what takes long, for example a single thread of low priority; with {@code Runnable::run} it is done within {@link #accept}, as for reading recordings
   */
  public LiveMonitor(LiveSettings settings, Epoch epoch, LiveListener listener, Executor executor) {
    this(settings, epoch, listener, Optional.of(executor));
  }

  private LiveMonitor(
      LiveSettings settings, Epoch epoch, LiveListener listener, Optional<Executor> executor) {
    this(settings, epoch, listener, executor, new KickJudge(settings, epoch)::judge);
  }

  /** With another judge of kicks. */
  LiveMonitor(
      LiveSettings settings,
      Epoch epoch,
      LiveListener listener,
      Optional<Executor> executor,
      BallMonitor.Judge judge) {
    this.listener = new GuardedListener(listener);
    this.epoch = Objects.requireNonNull(epoch, "epoch");
    this.executor = executor;
    ball = new BallMonitor(settings, this.listener, judge);
    movement = new MovementMonitor(settings, epoch, this.listener);
  }

  /**
   * Learns the field, the cameras and the published models.
   *
   * @param geometry as published; may come over and over, and may change
   */
  public void geometry(FieldGeometry geometry) {
    synchronized (shared) {
      if (geometry.equals(field)) {
        return;
      }
      field = geometry;
    }
    Map<Integer, Camera> usable = new HashMap<>();
    for (CameraCalibration calibration : geometry.cameras()) {
      camera(calibration).ifPresent(c -> usable.put(c.id(), c));
    }
    ball.geometry(geometry, usable);
    schedule();
  }

  /** A camera whose calibration cannot be used is treated like one without. */
  private static Optional<Camera> camera(CameraCalibration calibration) {
    try {
      return Optional.of(Camera.of(calibration));
    } catch (IllegalArgumentException unusable) {
      return Optional.empty();
    }
  }

  /**
   * What the referee says from now on; may come over and over. Without it everything counts.
   *
   * @param next the phase
   */
  public void phase(PlayPhase next) {
    synchronized (shared) {
      phase = Objects.requireNonNull(next, "next");
    }
    ball.phase(next);
    movement.phase(next);
    schedule();
  }

  /**
   * Takes a frame, within microseconds unless the executor works in the calling thread. A frame whose time is far off from the others' is left out and counted; when the clock has restarted, what was followed ends. Without {@link #geometry} chips are not fitted, since nothing is known of
   * where the cameras are.
   *
   * @param frame of any camera, as it comes; times in s since the epoch
   */
  public void accept(VisionFrame frame) {
    FrameGuard.Verdict verdict;
    synchronized (shared) {
      verdict = guard.judge(frame.captureTime());
      if (verdict == FrameGuard.Verdict.LEAVE) {
        stray++;
        return;
      }
      if (verdict == FrameGuard.Verdict.RESTART) {
        jumps++;
        cameras.values().forEach(CameraWatch::restart);
      }
      frames++;
      cameras.computeIfAbsent(frame.cameraId(), CameraWatch::new).accept(frame);
    }
    if (verdict == FrameGuard.Verdict.RESTART) {
      ball.restart();
      movement.restart();
    }
    ball.accept(frame);
    movement.accept(frame);
    schedule();
  }

  /** No more frames come: what is under way ends, and all that waits is done by the executor or the next calls of {@link #poll}. */
  public void finish() {
    ball.finish();
    movement.finish();
    schedule();
  }

  private void schedule() {
    if (executor.isEmpty()
        || !(ball.hasWork() || movement.hasWork())
        || !scheduled.compareAndSet(false, true)) {
      return;
    }
    try {
      executor.get().execute(this::work);
    } catch (RejectedExecutionException e) {
      // The host is shutting down; when the queue is full, kicks that wait are dropped and counted.
      scheduled.set(false);
    }
  }

  private void work() {
    try {
      while (poll()) {
        // Each call does one piece.
      }
    } finally {
      scheduled.set(false);
    }
    // What came after the last call had found nothing.
    schedule();
  }

  /**
   * Does one piece of the work that takes long: some 10 to 100 ms for a kick, some tenths of a second for movement limits. Throws nothing into the host but an error that is the machine's, such as an {@link OutOfMemoryError}: a piece that breaks for another reason is
   * counted in {@link LiveSnapshot#listenerFailures}.
   *
   * @return false when there was nothing to do
   */
  public boolean poll() {
    // One piece at a time, also when the host calls this beside its executor: the listener is told
    // one thing after the other.
    synchronized (working) {
      return guarded(() -> ball.poll() || movement.poll());
    }
  }

  /** A piece that breaks is over: there may be another one. */
  boolean guarded(BooleanSupplier piece) {
    try {
      return piece.getAsBoolean();
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      // Both take a piece from their queue before they work on it, so that the next call continues
      // with the rest.
      listener.countFailure();
      return true;
    }
  }

  /**
   * What the robots of a team are configured to do, usually the host's own: when they do otherwise, {@link LiveListener#limitWarningRaised} is called with the next estimate. May come again, from any thread.
   *
   * @param team which
   * @param limits what is configured
   */
  public void configured(Team team, ConfiguredLimits limits) {
    movement.configured(team, limits);
  }

  /**
   * The samples behind the ball's medians, to be stored or pooled with those of other matches, see {@link LiveStateDocument}.
   *
   * @return a copy
   */
  public BallSamples samples() {
    return ball.samples();
  }

  /**
   * Adds samples of earlier matches on the same carpet.
   *
   * @param earlier samples
   */
  public void add(BallSamples earlier) {
    ball.add(earlier);
  }

  private CameraHealth health(
      int id, CameraWatch camera, Map<Integer, CameraAlignment.Known> known) {
    CameraAlignment.Known its = known.get(id);
    double apart = Double.NaN;
    OptionalInt from = OptionalInt.empty();
    for (Map.Entry<Integer, CameraAlignment.Known> other : known.entrySet()) {
      double distance = other.getValue().distance(its);
      if (other.getKey() != id && !(distance <= apart) && Double.isFinite(distance)) {
        apart = distance;
        from = OptionalInt.of(other.getKey());
      }
    }
    return camera.health(guard.now(), its, apart, from);
  }

  /** Of the cameras as published, and of lenses that do not fit the detections. */
  private List<CameraFault> faults() {
    List<CameraFault> faults = new ArrayList<>();
    for (CameraCalibration calibration :
        field == null ? List.<CameraCalibration>of() : field.cameras()) {
      int id = calibration.id();
      Camera.faultOf(calibration)
          .or(() -> ball.lensFault(calibration))
          .ifPresent(reason -> faults.add(new CameraFault(id, reason)));
    }
    faults.sort(Comparator.comparingInt(CameraFault::camera));
    return faults;
  }

  /**
   * What is known now.
   *
   * @return immutable
   */
  public LiveSnapshot snapshot() {
    BallSnapshot ballNow = ball.snapshot();
    MovementSnapshot movementNow = movement.snapshot();
    synchronized (shared) {
      List<CameraHealth> health = new ArrayList<>();
      Map<Integer, CameraAlignment.Known> known = new TreeMap<>();
      cameras.keySet().forEach(id -> known.put(id, ball.known(id)));
      cameras.forEach((id, camera) -> health.add(health(id, camera, known)));
      return new LiveSnapshot(
          epoch.unixSeconds(guard.now()),
          phase,
          Optional.ofNullable(field),
          ballNow,
          movementNow,
          health,
          faults(),
          frames,
          stray,
          jumps,
          listener.failures());
    }
  }
}
