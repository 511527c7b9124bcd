package fieldcal.app.cli;

import java.io.PrintStream;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Says from time to time what long work is at, where nobody sees a progress bar: a pipe or a file gets a plain line every ten seconds, and none from
 * work that is shorter.
 */
final class Heartbeat implements AutoCloseable {
  /** Longer silences look like a hang; chosen. */
  private static final long PERIOD_SECONDS = 10;

  private final PrintStream out;
  private final LongSupplier nanoTime;
  private final long begin;
  private ScheduledExecutorService timer;
  private String what = "";

  /** On the error stream. */
  Heartbeat() {
    this(System.err, System::nanoTime);
  }

  /** To a stream, with a clock in ns. */
  Heartbeat(PrintStream out, LongSupplier nanoTime) {
    this.out = out;
    this.nanoTime = nanoTime;
    begin = nanoTime.getAsLong();
  }

  /** What is being done from now on. */
  synchronized void at(String now) {
    what = now;
    if (timer == null) {
      timer =
          Executors.newSingleThreadScheduledExecutor(
              task -> {
                Thread thread = new Thread(task, "heartbeat");
                thread.setDaemon(true);
                return thread;
              });
      timer.scheduleAtFixedRate(this::tell, PERIOD_SECONDS, PERIOD_SECONDS, TimeUnit.SECONDS);
    }
  }

  /** A line now. */
  synchronized void tell() {
    long seconds = TimeUnit.NANOSECONDS.toSeconds(nanoTime.getAsLong() - begin);
    out.println(String.format(Locale.ROOT, "%4d s  %s", seconds, what));
    out.flush();
  }

  @Override
  public synchronized void close() {
    if (timer != null) {
      timer.shutdownNow();
      timer = null;
    }
  }
}
