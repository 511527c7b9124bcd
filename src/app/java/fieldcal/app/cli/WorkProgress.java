package fieldcal.app.cli;

import fieldcal.app.calibrate.CalibrationSession;
import java.nio.file.Path;

/** stub */
final class WorkProgress implements CalibrationSession.Progress, AutoCloseable {
  @Override
  public void read(Path log, long bytesRead, long totalBytes) {}

  @Override
  public void fitting(int kicks) {}

  @Override
  public void fitted() {}

  @Override
  public void close() {}
}
