package fieldcal.app.cli;

import fieldcal.app.diagnose.DiagnosisSession;
import java.nio.file.Path;

/** Progress of a calibration or diagnosis on the terminal: reading in bytes, one recording after the other, fitting in kicks, then in words. */
final class WorkProgress implements DiagnosisSession.Progress, AutoCloseable {
  private final Heartbeat heartbeat;
  private TerminalProgress bar;
  private Path reading;
  private int kicks;
  private int fitted;
  private boolean inWords;

  /** With plain lines on a heartbeat where there is no terminal; it is closed with this. */
  WorkProgress(Heartbeat heartbeat) {
    this.heartbeat = heartbeat;
  }

  @Override
  public void read(Path log, long bytesRead, long totalBytes) {
    if (!log.equals(reading)) {
      end();
      reading = log;
      bar = TerminalProgress.ofBytes("reading " + log.getFileName(), heartbeat);
    }
    bar.at(bytesRead, totalBytes);
  }

  @Override
  public void fitting(int count) {
    end();
    kicks = count;
    bar = TerminalProgress.ofSteps("fitting", " kicks", heartbeat);
  }

  @Override
  public synchronized void fitted() {
    bar.at(++fitted, kicks);
  }

  @Override
  public void diagnosing(String what) {
    if (!inWords) {
      end();
      bar = TerminalProgress.ofWords(heartbeat);
      inWords = true;
    }
    bar.say(what);
  }

  /** Of one bar, before the next one. */
  private void end() {
    if (bar != null) {
      bar.close();
      bar = null;
    }
  }

  @Override
  public void close() {
    end();
    heartbeat.close();
  }
}
