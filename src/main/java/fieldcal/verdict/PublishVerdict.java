package fieldcal.verdict;

import fieldcal.kick.KickKind;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Whether a calibrated model may be published, and why.
 *
 * @param decision the most serious one that a reason asks for
 * @param reasons the most serious first; never empty
 * @param diagnose whether a diagnosis would help
 */
public record PublishVerdict(PublishDecision decision, List<Reason> reasons, boolean diagnose) {
  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws IllegalArgumentException if there is no reason
   */
  public PublishVerdict {
    Objects.requireNonNull(decision, "decision");
    reasons = List.copyOf(reasons);
    if (reasons.isEmpty()) {
      throw new IllegalArgumentException("a verdict needs a reason");
    }
  }

  /**
   * The verdict that follows from reasons.
   *
   * @param reasons at least one, in any order
   * @param diagnose whether a diagnosis would help
   * @return with the most serious decision
   */
  static PublishVerdict of(List<Reason> reasons, boolean diagnose) {
    List<Reason> sorted =
        reasons.stream().sorted(Comparator.comparing(Reason::decision).reversed()).toList();
    return new PublishVerdict(gravest(sorted), sorted, diagnose);
  }

  /**
   * The decision about one of the two models.
   *
   * @param kind flat or chip
   * @return empty when no kick in these recordings is of that kind
   */
  public Optional<PublishDecision> decision(KickKind kind) {
    boolean concerned = reasons.stream().anyMatch(r -> r.model().equals(Optional.of(kind)));
    return concerned
        ? Optional.of(
            gravest(
                reasons.stream()
                    .filter(r -> r.model().isEmpty() || r.model().get() == kind)
                    .toList()))
        : Optional.empty();
  }

  private static PublishDecision gravest(List<Reason> reasons) {
    return reasons.stream()
        .map(Reason::decision)
        .reduce(PublishDecision.PUBLISH, PublishDecision::or);
  }
}
