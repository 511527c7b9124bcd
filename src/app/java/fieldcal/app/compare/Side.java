package fieldcal.app.compare;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.limits.LimitsOutcome;
import fieldcal.app.statistics.FieldRecording;
import java.util.Objects;

/**
 * Everything that is known of the field, or of the simulator.
 *
 * @param diagnosis of its recordings
 * @param recording with all frames
 * @param limits of its robots
 */
public record Side(DiagnosisOutcome diagnosis, FieldRecording recording, LimitsOutcome limits) {
  /** Checks that nothing is missing. {@inheritDoc} */
  public Side {
    Objects.requireNonNull(diagnosis, "diagnosis");
    Objects.requireNonNull(recording, "recording");
    Objects.requireNonNull(limits, "limits");
  }
}
