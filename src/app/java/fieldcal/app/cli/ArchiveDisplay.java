package fieldcal.app.cli;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveProgress;
import java.time.Duration;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;

/** How far an archive is: logs done, throughput, and the time that is left. */
final class ArchiveDisplay implements ArchiveEngine.Progress, AutoCloseable {
  private final Heartbeat heartbeat;
  private final TerminalProgress bar;
  private final long begin = System.nanoTime();

  /** A bar on a terminal; otherwise a line now and then on the command's error stream. */
  ArchiveDisplay(CommandSpec spec) {
    heartbeat = Heartbeat.of(spec);
    bar = TerminalProgress.ofSteps("archive", " logs", heartbeat);
  }

  @Override
  public synchronized void at(ArchiveProgress progress) {
    bar.note(words(progress, (System.nanoTime() - begin) * 1e-9));
    bar.at(progress.logsDone(), progress.logs());
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
    heartbeat.close();
  }
}
