package fieldcal.app.diagnose;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.verdict.Finding;
import java.util.Objects;
import java.util.Optional;

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

  /**
   * The calibration with what the diagnosis found: its verdict counts that.
   *
   * @return the changed copy
   */
  public CalibrationOutcome judged() {
    return calibration.knowing(
        Optional.of(
            new Finding(
                diagnosis.verdict(),
                diagnosis.causes().stream().map(c -> c.effect().id()).toList())),
        calibration.surroundings().vision());
  }
}
