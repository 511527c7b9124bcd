package fieldcal.app.diagnose;

import fieldcal.app.recording.DataProblem;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import java.util.LinkedHashMap;
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
      "not explained by what explains the other kicks; perhaps somebody touched the ball, it was"
          + " another ball, or something acts where no other kick passed";

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
   * The same as remarks on the data: one for all kicks of a recording that were left out for the same reason.
   *
   * @param kicks that were left out, in order of time
   * @return with what to do, in the order of the first kick of each
   */
  public static List<DataProblem> remarks(List<LeftOutKick> kicks) {
    return kicks.stream()
        .collect(
            Collectors.groupingBy(
                k -> List.of(k.source(), k.reason()), LinkedHashMap::new, Collectors.toList()))
        .values()
        .stream()
        .map(LeftOutKick::remark)
        .toList();
  }

  private static DataProblem remark(List<LeftOutKick> alike) {
    LeftOutKick first = alike.get(0);
    boolean one = alike.size() == 1;
    String numbers =
        alike.stream().map(k -> Integer.toString(k.kick().id())).collect(Collectors.joining(", "));
    return new DataProblem(
        first.source(),
        String.format(
            Locale.ROOT,
            one ? "kick %s was left out: %s" : "kicks %s were left out: %s",
            numbers,
            first.reason()),
        alike.size(),
        one ? "Look at the kick in the console." : "Look at the kicks in the console.");
  }
}
