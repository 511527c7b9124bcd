package fieldcal.app.monitor;

import fieldcal.app.recording.LogOpener;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.ProblemKind;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executor;

/**
 * A recorded match, replayed at a multiple of its speed or as fast as the machine can. Kicks are fitted between the frames, so that the outcome does not depend on the speed, and none is dropped.
 */
public final class ReplayFeed implements MatchFeed {
  /** As fast as the machine can. */
  public static final double UNLIMITED = 0;

  /** The longest pause before the control is asked again, ms. */
  private static final long STEP = 50;

  /** When vision sends nothing for longer, the recording pauses, which nobody wants to wait for, s of the recording: 70 frames. */
  private static final double PAUSE = 1;

  /** A machine that is later cannot follow, s: it goes on from where it is. */
  private static final double TOO_LATE = 1;

  private static final int FRAMES_BETWEEN_QUESTIONS = 256;

  /** Movement limits take as long as ten thousand frames; in a replay nobody waits for them, s of the recording. */
  private static final double LIMITS_INTERVAL = 60;

  /** When nobody can look on, only those before breaks and at the end matter, s of the recording. */
  private static final double UNSEEN_LIMITS_INTERVAL = 300;

  private final Path log;
  private final double speed;
  private final RecordingReader reader;
  private volatile double share;
  private volatile List<String> problems = List.of();

  /**
   * Opens a recording.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @param speed how many times faster than it happened, or {@link #UNLIMITED}
   * @param opener opens it
   * @throws IOException when it cannot be read
   * @throws IllegalArgumentException when the speed is negative or not finite
   */
  public ReplayFeed(Path log, double speed, LogOpener opener) throws IOException {
    if (!(speed >= 0) || Double.isInfinite(speed)) {
      throw new IllegalArgumentException("speed must not be negative: " + speed);
    }
    this.log = log;
    this.speed = speed;
    reader = opener.recording(log);
  }

  @Override
  public Epoch epoch() {
    return reader.epoch();
  }

  @Override
  public Executor executor() {
    return Runnable::run;
  }

  @Override
  public LiveSettings suited(LiveSettings settings) {
    if (speed == UNLIMITED) {
      return settings.withLimitsInterval(UNSEEN_LIMITS_INTERVAL);
    }
    boolean slow = speed <= LIMITS_INTERVAL / settings.limitsInterval();
    return slow ? settings : settings.withLimitsInterval(LIMITS_INTERVAL);
  }

  @Override
  public void run(LiveMonitor monitor, Control control) throws IOException {
    try {
      RecordingSummary summary = reader.read(new Feed(monitor, control));
      problems = problems(summary);
    } catch (Stopped e) {
      // The operator has seen enough.
    }
  }

  private static List<String> problems(RecordingSummary summary) {
    List<String> lines = new ArrayList<>();
    ProblemAccount account = summary.problems();
    for (ProblemKind kind : account.kinds()) {
      lines.add(
          String.format(
              Locale.ROOT,
              "%s: %d %s, first at %s",
              kind.text(),
              account.count(kind),
              account.count(kind) == 1 ? "time" : "times",
              account.place(account.first(kind).get(0).offset())));
    }
    if (summary.frames() == 0) {
      lines.add("no vision frame in the recording");
    }
    return lines;
  }

  @Override
  public FeedStatus status() {
    List<String> notes = new ArrayList<>();
    String pace =
        speed == UNLIMITED
            ? "as fast as possible"
            : String.format(Locale.ROOT, "at %s times its speed", trimmed(speed));
    notes.add(String.format(Locale.ROOT, "%.0f %% read, %s", 100 * share, pace));
    notes.addAll(problems);
    return new FeedStatus(log.toString(), notes, false);
  }

  private static String trimmed(double value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }

  /** Ends the reading from within. */
  private static final class Stopped extends RuntimeException {
    private static final long serialVersionUID = 1;

    Stopped() {
      super(null, null, false, false);
    }
  }

  /** Gives a monitor what a recording holds, at its pace. */
  private final class Feed implements RecordingListener {
    private final LiveMonitor monitor;
    private final Control control;
    private double start = Double.NaN;
    private double last = Double.NaN;
    private long startNanos;
    private int frames;

    Feed(LiveMonitor monitor, Control control) {
      this.monitor = monitor;
      this.control = control;
    }

    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      pace(receivedTime);
      monitor.accept(frame);
      if (++frames % FRAMES_BETWEEN_QUESTIONS == 0) {
        ask();
      }
    }

    private void pace(double time) {
      if (speed == UNLIMITED) {
        return;
      }
      double ahead = (time - start) / speed - 1e-9 * (System.nanoTime() - startNanos);
      boolean follows = Math.abs(time - last) < PAUSE;
      last = time;
      if (!follows || ahead < -TOO_LATE) {
        // The beginning, a pause in the recording, or a machine that cannot follow.
        start = time;
        startNanos = System.nanoTime();
        return;
      }
      while (ahead > 0.001) {
        sleep((long) Math.min(STEP, 1000 * ahead));
        ask();
        ahead = (time - start) / speed - 1e-9 * (System.nanoTime() - startNanos);
      }
    }

    private void sleep(long millis) {
      try {
        Thread.sleep(millis);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new Stopped();
      }
    }

    private void ask() {
      if (!control.goOn()) {
        throw new Stopped();
      }
    }

    @Override
    public void onGeometry(FieldGeometry geometry) {
      monitor.geometry(geometry);
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      control.referee(state);
    }

    @Override
    public void onProgress(long bytesRead, long totalBytes) {
      share = totalBytes > 0 ? (double) bytesRead / totalBytes : 1;
    }
  }
}
