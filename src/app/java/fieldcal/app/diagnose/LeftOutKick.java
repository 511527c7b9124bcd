package fieldcal.app.diagnose;

import fieldcal.app.recording.DataProblem;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A kick that was found and that the diagnosis did not use.
 *
 * @param kick which one
 * @param source the recording it is in
 * @param reason why, in words
 */
public record LeftOutKick(Kick kick, String source, String reason) {
  /** Of a kick that takes part in a diagnosis until the others are explained. */
  private static final String STANDS_OUT =
      "what explains the other kicks does not explain it; the ball may have been touched, "
          + "it may be another one, or something acts where no other kick passed";

  /**
   * All that were left out.
   *
   * @param outcome of a diagnosis
   * @return in order of time; empty when all were used
   */
  public static List<LeftOutKick> of(DiagnosisOutcome outcome) {
    Set<Integer> used =
        outcome.diagnosis().kicks().stream().map(k -> k.kick().id()).collect(Collectors.toSet());
    Set<Integer> given =
        outcome.problem().fits().stream().map(f -> f.kick().id()).collect(Collectors.toSet());
    Map<Integer, CalibratedKick> judged =
        outcome.calibration().calibration().kicks().stream()
            .collect(Collectors.toMap(k -> k.fit().kick().id(), k -> k));
    return outcome.calibration().data().kicks().stream()
        .filter(k -> !used.contains(k.id()))
        .map(
            k ->
                new LeftOutKick(
                    k,
                    outcome.calibration().data().sources().getOrDefault(k.id(), ""),
                    given.contains(k.id()) ? STANDS_OUT : reason(judged.get(k.id()), outcome)))
        .toList();
  }

  private static String reason(CalibratedKick judged, DiagnosisOutcome outcome) {
    if (judged == null) {
      return "it could not be fitted";
    }
    KickFit fit = judged.fit();
    return outcome
        .calibration()
        .selection()
        .droppedBecause(outcome.calibration().key(fit.kick()))
        .or(fit::failure)
        .orElse("too few detections");
  }

  /**
   * The same as a remark on the data.
   *
   * @return with what to do
   */
  public DataProblem remark() {
    return new DataProblem(
        source,
        String.format(Locale.ROOT, "kick %d was left out: %s", kick.id(), reason),
        1,
        "Look at the kick in the console.");
  }
}
