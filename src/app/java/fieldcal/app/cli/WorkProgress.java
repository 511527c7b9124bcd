package fieldcal.app.cli;

import fieldcal.app.diagnose.DiagnosisSession;
import java.nio.file.Path;

/** Progress of a calibration or diagnosis on the terminal: reading in bytes, one recording after the other, fitting in kicks, then in words. */
final class WorkProgress implements DiagnosisSession.Progress, AutoCloseable {
  private TerminalProgress bar;
  private Path reading;
  private int kicks;
  private int fitted;
  private boolean inWords;

  @Override
  public void read(Path log, long bytesRead, long totalBytes) {
    if (!log.equals(reading)) {
      close();
      reading = log;
      bar = TerminalProgress.ofBytes("reading " + log.getFileName());
    }
    bar.at(bytesRead, totalBytes);
  }

  @Override
  public void fitting(int count) {
    close();
    kicks = count;
    bar = TerminalProgress.ofSteps("fitting", " kicks");
  }

  @Override
  public synchronized void fitted() {
    bar.at(++fitted, kicks);
  }

  @Override
  public void diagnosing(String what) {
    if (!inWords) {
      close();
      bar = TerminalProgress.ofWords();
      inWords = true;
    }
    bar.say(what);
  }

  @Override
  public void close() {
    if (bar != null) {
      bar.close();
      bar = null;
    }
  }
}
