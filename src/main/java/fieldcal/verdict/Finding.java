package fieldcal.verdict;

import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Verdict;
import java.util.List;
import java.util.Objects;

/**
 * What a diagnosis of the same kicks found.
 *
 * @param verdict of the diagnosis
 * @param causes ids of the effects that it names
 */
public record Finding(Verdict verdict, List<String> causes) {
  /** Copies the list. {@inheritDoc} */
  public Finding {
    Objects.requireNonNull(verdict, "verdict");
    causes = List.copyOf(causes);
  }

  /**
   * Takes what matters for publishing from a diagnosis.
   *
   * @param diagnosis of the same kicks
   * @return what matters for publishing
   */
  public static Finding of(Diagnosis diagnosis) {
    return new Finding(
        diagnosis.verdict(), diagnosis.causes().stream().map(c -> c.effect().id()).toList());
  }
}
