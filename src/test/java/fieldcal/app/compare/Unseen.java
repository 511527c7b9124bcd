package fieldcal.app.compare;

import fieldcal.app.diagnose.DiagnosisSession;
import java.nio.file.Path;

/** Nobody looks. */
public enum Unseen implements DiagnosisSession.Progress {
  /** The only one. */
  PROGRESS;

  @Override
  public void read(Path log, long bytesRead, long totalBytes) {}

  @Override
  public void fitting(int kicks) {}

  @Override
  public void fitted() {}

  @Override
  public void diagnosing(String what) {}
}
