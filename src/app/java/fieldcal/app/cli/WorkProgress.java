package fieldcal.app.cli;

import fieldcal.app.calibrate.CalibrationSession;
import java.nio.file.Path;

/** Progress of a calibration on the terminal: reading in bytes, one recording after the other, then fitting in kicks. */
final class WorkProgress implements CalibrationSession.Progress, AutoCloseable {
  private TerminalProgress bar;
  private Path reading;
  private int kicks;
  private int fitted;

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
  public void close() {
    if (bar != null) {
      bar.close();
      bar = null;
    }
  }
}
