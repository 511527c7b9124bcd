package fieldcal.app.play;

import fieldcal.app.play.SessionSnapshot.Undecided;
import fieldcal.calibration.Average;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingGap;
import fieldcal.kick.KickKind;
import fieldcal.play.CalibrationPlay;
import fieldcal.play.KickChooser;
import fieldcal.play.PlayAnswer;
import fieldcal.play.PlayArea;
import fieldcal.play.PlayLine;
import fieldcal.play.PlayPhase;
import fieldcal.play.PlayPlan;
import fieldcal.play.PlayState;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayedKick;
import fieldcal.play.RobotOrder;
import fieldcal.play.SpreadKicks;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionPacket;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * Runs the calibration play on a field until it is over: recording, live fits, and snapshots for whoever looks on.
 *
 * <p>{@link #run} does all the work on the caller's thread. {@link #pause}, {@link #resume}, {@link #abort} and {@link #snapshot} may be called from any thread at any time; they act in the next tick.
 */
public final class PlaySession {
  /** Longest that the end takes after {@link #abort}, ms: robots brake within 3 s, the ball of the last kick is watched for 5 s meanwhile, then it is fitted. */
  public static final long LONGEST_END = 10_000;

  /** The play sees that a ball moves some hundredths of a second after the kick, s. */
  static final double NOTICED = 0.04;

  /** Field time between two snapshots, s. */
  private static final double SNAPSHOTS = 0.05;

  /** Vision must send the geometry within that time, s; SSL-Vision does every three seconds. */
  private static final double GEOMETRY = 10;

  /** It is at least waited for that long, whatever the patience, s. */
  private static final double LEAST_GEOMETRY = 5;

  /** After so long the operator hears what is waited for, and again and again, s. */
  private static final double TELL_WAIT = 2.5;

  /** At the end robots are told to stand for at least, and at most, so many ticks: more than one, since one may get lost. */
  private static final int FEWEST_LAST_TICKS = 20;

  private static final int MOST_LAST_TICKS = 150;

  /** Longest wait for the last fits, s; as the play itself waits for them. */
  private static final double LAST_FITS = 60;

  /** An older position of a robot does not show where it is now, s. */
  private static final double UNSEEN = 0.25;

  /** A robot that is slower stands, as far as vision can tell, m/s. */
  private static final double STANDS = 0.1;

  private final SessionRequest request;
  private final PlayField field;
  private final Consumer<SessionSnapshot> listener;
  private final WorldModel model = new WorldModel();
  private final LiveFits fits;
  private final CauseWatch causes;
  private final PlayField.Receiver receiver = new Recording();
  private final AtomicReference<SessionSnapshot> latest = new AtomicReference<>();

  private volatile boolean paused;
  private volatile String abortReason;
  private volatile boolean endsNow;
  private volatile boolean robotsStand;
  private final CountDownLatch ended = new CountDownLatch(1);

  private Consumer<String> whileWaiting = reason -> {};
  private SessionRecorder recorder;
  private CalibrationPlay play;
  private FieldGeometry geometry;
  private Map<String, Average> averages = Map.of();
  private AdaptiveKicks adaptive;
  private boolean precise;
  private boolean recorded;
  private double elapsed;
  private double started = Double.NaN;
  private double jumpsBefore;
  private double shown = Double.NEGATIVE_INFINITY;

  /**
   * A session that has not begun.
   *
   * @param request what is wanted
   * @param field where; closed by {@link #run}
   * @param listener gets a snapshot some 20 times per second of field time, and at every change, on the thread of {@link #run}; it should return quickly
   */
  public PlaySession(SessionRequest request, PlayField field, Consumer<SessionSnapshot> listener) {
    this.request = request;
    this.field = field;
    this.listener = listener;
    Executor executor = field.goesOnByItself() ? PlaySession::inBackground : Runnable::run;
    fits = new LiveFits(request.kind(), request.seed(), executor);
    Optional<Path> watched = request.adaptive() ? request.directory() : Optional.empty();
    causes = new CauseWatch(watched, executor);
  }

  private static void inBackground(Runnable task) {
    Thread thread = new Thread(task, "fits and diagnosis");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * What a session ended with.
   *
   * @param last the last snapshot
   * @param log the recording; empty when nothing was recorded
   * @param commands what the robots were commanded; empty when nothing was recorded
   */
  public record Outcome(SessionSnapshot last, Optional<Path> log, Optional<Path> commands) {

    /**
     * Whether all kicks were made.
     *
     * @return false when it was stopped
     */
    public boolean complete() {
      return last.state().phase() == PlayPhase.FINISHED;
    }
  }

  /**
   * Plays until all kicks are made, or something ends it. Both robots are told to stand at the end, whatever happened, and waited for until they do.
   *
   * @return how it ended
   * @throws IOException when the field is gone or the recording cannot be written; one line for the operator
   */
  public Outcome run() throws IOException {
    try (PlayField open = field) {
      if (request.directory().isPresent()) {
        String name = "session-" + request.kind().id();
        recorder =
            SessionRecorder.begin(request.directory().get(), name, open.epoch(), open.origin());
      }
      // Of both each is done whatever the other throws, and neither hides why the play ended.
      Closeable recording = this::endRecording;
      Closeable robots = this::stopRobots;
      try (recording;
          robots) {
        play();
      }
    } finally {
      ended.countDown();
    }
    return new Outcome(
        latest.get(),
        Optional.ofNullable(recorder).map(SessionRecorder::log),
        Optional.ofNullable(recorder).map(SessionRecorder::commands));
  }

  private void play() throws IOException {
    try {
      waitForGeometry();
      PlayPlan plan = checkedPlan();
      play = new CalibrationPlay(plan, chooser(plan), this::played);
      recallCauses();
      while (!play.over()) {
        tick();
      }
      settle();
      endRecording();
      judgeLast();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  private void endRecording() throws IOException {
    if (recorder == null || recorded) {
      return;
    }
    recorded = true;
    if (play == null) {
      recorder.discard();
    } else {
      recorder.close();
    }
  }

  /**
   * Who wants to hear what is waited for before the first snapshot; to be called before {@link #run}.
   *
   * @param listener gets a clause for the operator, on the thread of {@link #run}
   */
  public void whileItHasNotBegun(Consumer<String> listener) {
    whileWaiting = listener;
  }

  private void waitForGeometry() throws IOException {
    double first = Double.NaN;
    double tell = Math.min(TELL_WAIT, request.limits().patience() / 2);
    double patience = request.limits().patience();
    double longest = Math.min(GEOMETRY, Math.max(LEAST_GEOMETRY, patience));
    while (geometry == null) {
      double now = field.next(receiver);
      // When vision's clock is known at last, it may be far from the one that stood in for it.
      double time = now - field.clockJumps();
      first = Double.isNaN(first) ? time : first;
      double waited = time - first;
      if (abortReason != null) {
        throw new IOException("aborted before it began: " + abortReason);
      }
      if (field.over().isPresent()) {
        throw new IOException(field.over().get());
      }
      if (geometry == null && waited > tell) {
        whileWaiting.accept(
            "waiting for the geometry of the field from vision, for " + Math.round(waited) + " s");
        tell += TELL_WAIT;
      }
      if (geometry == null && waited > longest) {
        throw new IOException(
            "vision sent no geometry for "
                + Math.round(longest)
                + " s. "
                + (field.notes().isEmpty() ? "Is it running?" : String.join("; ", field.notes())));
      }
    }
  }

  /** What does not fit on the field that vision has published is the operator's mistake. */
  private PlayPlan checkedPlan() throws IOException {
    try {
      return plan();
    } catch (IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private PlayPlan plan() {
    PlayPlan plan =
        request.kind() == KickKind.CHIP
            ? PlayPlan.chip(request.first(), request.second(), geometry, request.kicks())
                .withLines(
                    PlayLine.across(geometry, request.across(), false),
                    PlayLine.across(geometry, request.across(), true))
            : PlayPlan.flat(
                request.first(), request.second(), geometry, request.half(), request.kicks());
    PlayArea area = plan.area();
    double margin = request.margin().orElse(area.margin());
    return plan.withLimits(request.limits())
        .withArea(new PlayArea(area.length(), area.width(), margin, area.goalWidth()));
  }

  private KickChooser chooser(PlayPlan plan) {
    if (request.adaptive() && !fits.cameras().isEmpty()) {
      adaptive = new AdaptiveKicks(request, plan, fits, causes::undecided);
      return adaptive;
    }
    return new SpreadKicks(
        request.kicks(), request.slowest(), request.fastest(), request.elevation(), request.seed());
  }

  private void tick() throws IOException {
    double now = field.next(receiver);
    if (Double.isNaN(started)) {
      started = now;
      jumpsBefore = field.clockJumps();
    }
    for (KickResult result : fits.judge()) {
      tellPlay(result);
      averages = fits.model();
      precise =
          request.precision() > 0
              && fits.precision(request.slowest(), request.fastest()) <= request.precision();
      shown = Double.NEGATIVE_INFINITY;
    }
    lookForCauses();
    if (precise && !causes.isBusy() && !undecided().mayBeTold()) {
      play.conclude();
    }
    if (paused) {
      play.pause();
    } else {
      play.resume();
    }
    if (abortReason != null) {
      play.abort(abortReason);
    }
    if (endsNow) {
      play.endNow();
    }
    field.over().ifPresent(play::abort);
    play.hold(field.hold());
    PlayPhase before = play.state().phase();
    PlayWorld world = model.at(now, field.permission());
    PlayAnswer answer = play.tick(world);
    field.order(answer.orders());
    if (answer.request().isPresent()) {
      field.layBall(answer.request().get());
    }
    if (play.state().phase() != before || now - shown >= SNAPSHOTS) {
      shown = now;
      show(world, answer, elapsed(now));
    }
  }

  /** Field time since the beginning, s: vision's clock may jump meanwhile. */
  private double elapsed(double now) {
    return now - started - (field.clockJumps() - jumpsBefore);
  }

  private void tellPlay(KickResult result) {
    int number = result.played().number();
    if (result.outOfView()) {
      play.judgeOutOfView(number, result.reason());
    } else {
      play.judge(number, result.good(), result.reason());
    }
  }

  /** What earlier sessions left open is told apart from the first kick on. */
  private void recallCauses() throws IOException {
    if (request.directory().isPresent() && PlayRun.logs(request.directory().get()).size() > 1) {
      recorder.flush();
      causes.recall();
    }
  }

  private void lookForCauses() throws IOException {
    int good = play.state().good();
    if (causes.isDue(good)) {
      recorder.flush();
      causes.look(good);
    }
  }

  private Undecided undecided() {
    UndecidedCauses open = causes.undecided();
    boolean inVain = adaptive == null || adaptive.isInVain();
    return new Undecided(open.words(), inVain ? List.of() : open.wordsByKicks(), open.advice());
  }

  private void show(PlayWorld world, PlayAnswer answer, double time) {
    PlayState state = play.state();
    SessionSnapshot snapshot =
        new SessionSnapshot(
            time,
            state,
            paused,
            world,
            Optional.of(geometry),
            List.of(request.first(), request.second()),
            answer.request().map(r -> List.of(r.x(), r.y())).orElse(List.of()),
            fits.results(),
            averages,
            undecided());
    latest.set(snapshot);
    listener.accept(snapshot);
  }

  private final class Recording implements PlayField.Receiver {
    @Override
    public void vision(double receivedTime, VisionPacket packet, byte[] payload) {
      record(receivedTime, MessageType.SSL_VISION_2014, payload);
      packet.geometry().ifPresent(PlaySession.this::geometry);
      packet
          .frame()
          .ifPresent(
              frame -> {
                model.accept(frame);
                fits.accept(frame);
              });
    }

    @Override
    public void referee(double receivedTime, byte[] payload) {
      record(receivedTime, MessageType.SSL_REFBOX_2013, payload);
    }

    @Override
    public void lost(double receivedTime) {
      record(receivedTime, MessageType.BLANK, RecordingGap.mark());
    }

    private void record(double receivedTime, MessageType type, byte[] payload) {
      if (recorder == null) {
        return;
      }
      try {
        recorder.message(receivedTime, type, payload);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  private void geometry(FieldGeometry next) {
    if (!next.equals(geometry)) {
      geometry = next;
      fits.geometry(next);
    }
  }

  private void played(PlayedKick kick) {
    fits.played(kick);
    shown = Double.NEGATIVE_INFINITY;
    if (recorder != null) {
      try {
        recorder.command(kick);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** Some ticks more, until the robots are seen standing, or surely do. */
  private void settle() throws IOException {
    boolean stand = false;
    for (int i = 0; i < FEWEST_LAST_TICKS || !stand && i < MOST_LAST_TICKS; i++) {
      double now = field.next(receiver);
      PlayWorld world = model.at(now, field.permission());
      PlayAnswer answer = play.tick(world);
      field.order(answer.orders());
      stand = stands(world, request.first()) && stands(world, request.second());
      if (i == 0) {
        elapsed = elapsed(now);
        show(world, answer, elapsed);
      }
    }
    robotsStand = stand;
  }

  /**
   * Whether both robots were seen standing at the end; from any thread.
   *
   * @return false also before the end
   */
  public boolean robotsStand() {
    return robotsStand;
  }

  /** The recording has ended: every kick in it is judged by what the recording holds, as a calibration of it will. The robots are commanded to stand meanwhile. */
  private void judgeLast() throws IOException {
    fits.end();
    double first = Double.NaN;
    double now;
    do {
      for (KickResult result : fits.judge()) {
        tellPlay(result);
      }
      averages = fits.model();
      now = field.next((receivedTime, packet, payload) -> {});
      first = Double.isNaN(first) ? now : first;
      stopRobots();
    } while (fits.isOpen() && !endsNow && now - first < LAST_FITS);
    PlayWorld world = model.at(now, field.permission());
    show(world, play.tick(world), elapsed);
  }

  private boolean stands(PlayWorld world, RobotId id) {
    return world
        .robot(id)
        .map(
            robot ->
                world.time() - model.visionDelay() - robot.seen() < UNSEEN
                    && robot.speed() < STANDS)
        .orElse(false);
  }

  private void stopRobots() throws IOException {
    field.order(List.of(RobotOrder.stop(request.first()), RobotOrder.stop(request.second())));
  }

  /** Both robots stand until {@link #resume}. */
  public void pause() {
    paused = true;
  }

  /** Goes on after {@link #pause}. */
  public void resume() {
    paused = false;
  }

  /**
   * Ends the session; what was recorded stays.
   *
   * @param reason for the operator
   */
  public void abort(String reason) {
    abortReason = reason;
  }

  /** After {@link #abort}, nothing is waited for any longer: neither the ball of the last kick nor its fit. */
  public void endNow() {
    endsNow = true;
  }

  /** The one seed of everything random in it. */
  long seed() {
    return request.seed();
  }

  /**
   * Waits until both robots stand and the recording is complete; for another thread than that of {@link #run}.
   *
   * @param millis at most so long, ms
   * @return false when it still goes on then
   * @throws InterruptedException when the thread is interrupted
   */
  public boolean awaitEnd(long millis) throws InterruptedException {
    return ended.await(millis, TimeUnit.MILLISECONDS);
  }

  /**
   * The newest snapshot.
   *
   * @return empty before the play has begun
   */
  public Optional<SessionSnapshot> snapshot() {
    return Optional.ofNullable(latest.get());
  }
}
