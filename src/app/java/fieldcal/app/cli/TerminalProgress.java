package fieldcal.app.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** A progress bar on the error stream, if that is a terminal; otherwise a {@link Heartbeat}, which is the caller's to close. */
final class TerminalProgress implements AutoCloseable {
  static final int ERROR_STREAM = 2;
  private static final long MEGABYTE = 1_000_000;
  private static final String CLEAR_LINE = "\r\u001b[K";

  private final String task;
  private final boolean shown;
  private final Heartbeat heartbeat;
  private final String unit;
  private final long unitSize;
  private ProgressBar bar;
  private String note = "";
  private boolean said;

  private TerminalProgress(String task, String unit, long unitSize, Heartbeat heartbeat) {
    this.task = task;
    this.heartbeat = heartbeat;
    this.unit = unit;
    this.unitSize = unitSize;
    shown = isTerminal(ERROR_STREAM);
  }

  /** A bar that counts bytes; it appears with the first call of {@link #at}. */
  static TerminalProgress ofBytes(String task, Heartbeat heartbeat) {
    return new TerminalProgress(task, " MB", MEGABYTE, heartbeat);
  }

  /** A bar that counts steps of the given unit; it appears with the first call of {@link #at}. */
  static TerminalProgress ofSteps(String task, String unit, Heartbeat heartbeat) {
    return new TerminalProgress(task, unit, 1, heartbeat);
  }

  /** A bar that counts from 0 to 100; it appears with the first call of {@link #at}. */
  static TerminalProgress ofPercent(String task, Heartbeat heartbeat) {
    return new TerminalProgress(task, " %", 1, heartbeat);
  }

  /** No bar: says in words what is being done, see {@link #say}. */
  static TerminalProgress ofWords(Heartbeat heartbeat) {
    return new TerminalProgress("", "", 1, heartbeat);
  }

  /** Shows what is being done in place of what was shown before. */
  void say(String what) {
    if (shown) {
      System.err.print(CLEAR_LINE + what);
      System.err.flush();
      said = true;
    } else {
      heartbeat.at(what);
    }
  }

  void at(long done, long total) {
    if (!shown) {
      heartbeat.at(task + ", " + done / unitSize + " of " + total / unitSize + unit + note);
      return;
    }
    if (bar == null) {
      bar =
          new ProgressBarBuilder()
              .setTaskName(task)
              .setInitialMax(total)
              .setUnit(unit, unitSize)
              .setStyle(ProgressBarStyle.UNICODE_BLOCK)
              .setConsumer(new ConsoleProgressBarConsumer(System.err))
              .clearDisplayOnFinish()
              .build();
    }
    bar.stepTo(done);
  }

  /** Shows more behind the bar. */
  void note(String what) {
    note = what;
    if (bar != null) {
      bar.setExtraMessage(what);
    }
  }

  @Override
  public void close() {
    if (bar != null) {
      bar.close();
    }
    if (said) {
      System.err.print(CLEAR_LINE);
      System.err.flush();
      said = false;
    }
  }

  /** Java tells only whether both standard input and output are terminals; Linux tells of each stream. */
  static boolean isTerminal(int descriptor) {
    Path stream = Path.of("/proc/self/fd/" + descriptor);
    try {
      if (Files.exists(stream)) {
        String target = Files.readSymbolicLink(stream).toString();
        return target.startsWith("/dev/pts/")
            || target.startsWith("/dev/tty")
            || target.equals("/dev/console");
      }
    } catch (IOException e) {
      // No Linux after all: fall through to Java's own answer.
    }
    return System.console() != null;
  }
}
