package fieldcal.app.cli;

import fieldcal.app.files.NamedOutput;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Says from time to time what long work is at, where nobody sees a progress bar. Progress on the error stream is for a terminal only, so a pipe or a
 * file gets a plain line in the output itself, as from {@code play} and {@code record}, and none from shorter work.
 */
final class Heartbeat implements AutoCloseable {
  /** Chosen: well below the minutes after which silence looks like a hang, and above what most work takes. */
  static final long PERIOD_SECONDS = 30;

  private final PrintWriter out;
  private final LongSupplier nanoTime;
  private final long begin;
  private ScheduledExecutorService timer;
  private String what = "";
  private boolean closed;

  /** Into a command's output, with a clock in ns. */
  Heartbeat(PrintWriter out, LongSupplier nanoTime) {
    this.out = out;
    this.nanoTime = nanoTime;
    begin = nanoTime.getAsLong();
  }

  /** Into a command's output. */
  static Heartbeat in(PrintWriter out) {
    return new Heartbeat(out, System::nanoTime);
  }

  /** Into a command's output, unless that is where its JSON goes, which a program reads; {@code json} may be null. */
  static Heartbeat in(PrintWriter out, Path json) {
    return json != null && NamedOutput.isStandardOutput(json) ? none() : in(out);
  }

  /** Nowhere. */
  static Heartbeat none() {
    return in(new PrintWriter(Writer.nullWriter()));
  }

  /** What is being done from now on. */
  synchronized void at(String now) {
    what = now;
    if (timer == null && !closed) {
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

  /** A line now; none once the work has ended. */
  synchronized void tell() {
    if (closed) {
      return;
    }
    long seconds = TimeUnit.NANOSECONDS.toSeconds(nanoTime.getAsLong() - begin);
    out.println(String.format(Locale.ROOT, "%4d s  %s", seconds, what));
    out.flush();
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (timer != null) {
      timer.shutdownNow();
    }
  }
}
