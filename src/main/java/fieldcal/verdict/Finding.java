package fieldcal.verdict;

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
  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public Finding {
    Objects.requireNonNull(verdict, "verdict");
    causes = List.copyOf(causes);
  }
}
