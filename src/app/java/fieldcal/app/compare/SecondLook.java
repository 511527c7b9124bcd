package fieldcal.app.compare;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Diagnoses one side again with only the causes that it or the other side has by name. Where a first diagnosis ends with terms that have no name, it may have lost its way among many causes that are not there, and its
 * ball then differs from that of the other side for no reason. The simpler model stands unless it predicts held-out kicks worse.
 */
final class SecondLook {
  /** A simpler model is taken unless the other predicts held-out kicks better by that share: a tenth of the noise's excess that matters, as in the diagnosis. */
  private static final double CLEARLY_BETTER = 0.01;

  private SecondLook() {}

  static DiagnosisOutcome at(
      DiagnosisOutcome own, DiagnosisOutcome other, Consumer<String> progress) {
    Diagnosis first = own.diagnosis();
    if (first.learned().isEmpty() && !first.unexplained().significant()) {
      return own;
    }
    Set<String> named =
        Stream.of(own, other)
            .flatMap(side -> side.diagnosis().causes().stream())
            .map(cause -> cause.effect().id())
            .collect(Collectors.toSet());
    List<? extends Effect> few =
        EffectCatalogue.all().stream().filter(e -> named.contains(e.id())).toList();
    progress.accept("diagnosing again with the causes of both sides");
    Diagnosis second = new Diagnoser(few).diagnose(own.problem(), progress);
    double allowed = first.extended().holdoutRmsMm() / (1 - CLEARLY_BETTER);
    return second.extended().holdoutRmsMm() <= allowed
        ? new DiagnosisOutcome(own.calibration(), own.problem(), second)
        : own;
  }
}
