package fieldcal.app.diagnose;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import java.util.Objects;

/**
 * A diagnosis and everything it was made from.
 *
 * @param calibration recordings, kicks, and the fit of each
 * @param problem what the diagnosis was given of that
 * @param diagnosis the result
 */
public record DiagnosisOutcome(
    CalibrationOutcome calibration, DiagnosisProblem problem, Diagnosis diagnosis) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public DiagnosisOutcome {
    Objects.requireNonNull(calibration, "calibration");
    Objects.requireNonNull(problem, "problem");
    Objects.requireNonNull(diagnosis, "diagnosis");
  }
}
