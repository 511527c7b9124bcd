package fieldcal.app.cli;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveProgress;
import java.time.Duration;
import java.util.Locale;

/** How far an archive is: a bar over the logs on a terminal, a line now and then elsewhere. */
final class ArchiveDisplay implements ArchiveEngine.Progress, AutoCloseable {
  /** Between two lines where there is no terminal, s: often enough to see that it lives, seldom enough for a log file. */
  private static final double LINE_EVERY = 30;

  private final boolean terminal = TerminalProgress.isTerminal(TerminalProgress.ERROR_STREAM);
  private final TerminalProgress bar = TerminalProgress.ofSteps("archive", " logs");
  private final long begin = System.nanoTime();
  private double lastLine;

  @Override
  public synchronized void at(ArchiveProgress progress) {
    double elapsed = (System.nanoTime() - begin) * 1e-9;
    if (terminal) {
      bar.at(progress.logsDone(), progress.logs());
      bar.note(words(progress, elapsed));
    } else if (elapsed - lastLine >= LINE_EVERY) {
      lastLine = elapsed;
      System.err.printf(
          "archive: %d of %d logs%s%n",
          progress.logsDone(), progress.logs(), words(progress, elapsed));
    }
  }

  /** Throughput, and the time left by the bytes that are left. */
  static String words(ArchiveProgress progress, double elapsed) {
    if (progress.logsDone() == 0 || !(elapsed > 0)) {
      return "";
    }
    long left =
        Math.round(
            elapsed
                * (progress.bytes() - progress.bytesDone())
                / Math.max(1, progress.bytesDone()));
    Duration time = Duration.ofSeconds(left);
    return String.format(
        Locale.ROOT,
        ", %.1f minutes of play per second, %d:%02d:%02d left",
        progress.play() / 60 / elapsed,
        time.toHours(),
        time.toMinutesPart(),
        time.toSecondsPart());
  }

  @Override
  public void close() {
    bar.close();
  }
}
