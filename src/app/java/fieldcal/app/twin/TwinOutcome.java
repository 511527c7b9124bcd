package fieldcal.app.twin;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.diagnose.DiagnosisOutcome;
import java.nio.file.Path;
import java.util.List;

/**
 * A twin and what became of its check.
 *
 * @param twin the simulated field
 * @param diagnosis of the recordings it was made from
 * @param recordings of the same kicks on the twin
 * @param again their calibration
 * @param check the comparison
 */
public record TwinOutcome(
    Twin twin,
    DiagnosisOutcome diagnosis,
    List<Path> recordings,
    CalibrationOutcome again,
    TwinCheck check) {

  /** Copies the list. {@inheritDoc} */
  public TwinOutcome {
    recordings = List.copyOf(recordings);
  }
}
