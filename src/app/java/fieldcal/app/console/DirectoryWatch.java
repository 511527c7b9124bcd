package fieldcal.app.console;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Tells when recordings come into the directory, or another program writes them again. Thread-safe. */
final class DirectoryWatch {
  /** As often as windows are told that their connection lives; a look at the directory costs less than that, s. */
  private static final long PERIOD = 3;

  private final SessionDirectory directory;
  private final Runnable changed;
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "directory");
            thread.setDaemon(true);
            return thread;
          });

  private Map<Path, FileStamp> last;

  /**
   * Of a session.
   *
   * @param changed is called after each change
   */
  DirectoryWatch(SessionDirectory directory, Runnable changed) {
    this.directory = directory;
    this.changed = changed;
  }

  void start() {
    timer.scheduleWithFixedDelay(this::look, 0, PERIOD, TimeUnit.SECONDS);
  }

  private void look() {
    try {
      Map<Path, FileStamp> now = directory.files();
      boolean another = last != null && !last.equals(now);
      last = now;
      if (another) {
        changed.run();
      }
    } catch (IOException e) {
      // The directory went away: it may come back.
    }
  }

  void close() {
    timer.shutdownNow();
  }
}
