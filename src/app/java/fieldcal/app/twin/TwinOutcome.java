package fieldcal.app.twin;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.diagnosis.Cause;
import fieldcal.effect.Effect;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A twin and what became of its check.
 *
 * @param twin the simulated field
 * @param diagnosis of the recordings it was made from
 * @param recordings of the same kicks on the twin
 * @param check the comparison
 */
public record TwinOutcome(
    Twin twin, DiagnosisOutcome diagnosis, List<Path> recordings, TwinCheck check) {

  /** Copies the list. {@inheritDoc} */
  public TwinOutcome {
    recordings = List.copyOf(recordings);
  }

  /**
   * The causes in the twin, in words, with the spin that its kickers give.
   *
   * @return for example "air drag (cd 0.50)"
   */
  public List<String> causes() {
    Set<String> ids =
        twin.settings().effects().stream().map(e -> e.effect().id()).collect(Collectors.toSet());
    return diagnosis.diagnosis().model().effects().stream()
        .filter(e -> ids.contains(e.id()) || TwinBuilder.isSpin(e))
        .map(e -> TwinWords.cause(e, scatter(e)))
        .toList();
  }

  private double scatter(Effect effect) {
    return diagnosis.diagnosis().causes().stream()
        .filter(c -> c.effect().id().equals(effect.id()))
        .mapToDouble(Cause::scatter)
        .findFirst()
        .orElse(0);
  }
}
