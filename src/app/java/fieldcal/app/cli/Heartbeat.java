package fieldcal.app.cli;

import java.io.PrintWriter;
import java.io.Writer;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Says from time to time what long work is at, where the error stream is no terminal and nobody sees a progress bar: a plain line on the error
 * stream, and none from shorter work. The output has the result alone, whose first line is the verdict.
 */
final class Heartbeat implements AutoCloseable {
  /** Chosen: well below the minutes after which silence looks like a hang, and above what most work takes. */
  static final long PERIOD_SECONDS = 30;

  private final PrintWriter err;
  private final LongSupplier nanoTime;
  private final long begin;
  private ScheduledExecutorService timer;
  private String what = "";
  private boolean closed;

  /** Onto a command's error stream, with a clock in ns. */
  Heartbeat(PrintWriter err, LongSupplier nanoTime) {
    this.err = err;
    this.nanoTime = nanoTime;
    begin = nanoTime.getAsLong();
  }

  /** Of a command, onto its error stream. */
  static Heartbeat of(CommandSpec command) {
    return new Heartbeat(command.commandLine().getErr(), System::nanoTime);
  }

  /** Nowhere. */
  static Heartbeat none() {
    return new Heartbeat(new PrintWriter(Writer.nullWriter()), System::nanoTime);
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
    err.println(String.format(Locale.ROOT, "%4d s  %s", seconds, what));
    err.flush();
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (timer != null) {
      timer.shutdownNow();
    }
  }
}
