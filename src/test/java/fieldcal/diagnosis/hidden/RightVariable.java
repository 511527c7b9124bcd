package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.Answer.Term;
import fieldcal.simulation.SimulatedEffect;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** What a cause without a name depends on, and whether an answer says so first. */
final class RightVariable {
  private static final Set<String> PLACE = Set.of("place", "x", "y", "position", "radius");

  private RightVariable() {}

  private record Expected(String actsOn, Set<String> words) {}

  /** Whether what is said first is what the cause depends on; empty when nothing is said. */
  static Optional<Boolean> first(SimulatedEffect cause, Answer answer) {
    Expected expected = expected(cause);
    if (!answer.learned().isEmpty()) {
      Term term = answer.learned().get(0);
      return Optional.of(
          term.actsOn().equals(expected.actsOn()) && anyIn(term.dependsOn(), expected.words()));
    }
    if (!answer.left().isEmpty()) {
      return Optional.of(anyIn(answer.left().subList(0, 1), expected.words()));
    }
    return Optional.empty();
  }

  private static boolean anyIn(List<String> variables, Set<String> words) {
    return variables.stream()
        .flatMap(v -> Arrays.stream(v.toLowerCase(Locale.ROOT).split("[^a-z]+")))
        .anyMatch(words::contains);
  }

  private static Expected expected(SimulatedEffect cause) {
    return switch (cause) {
      case UNNAMED_RESTITUTION_PLACE -> new Expected("impact", PLACE);
      case UNNAMED_ROLL_SQUARE, UNNAMED_ROLL_BUMP, UNNAMED_SIDE_FORCE ->
          new Expected("ground", Set.of("speed"));
      case UNNAMED_FADING_FRICTION -> new Expected("ground", Set.of("kick", "since", "slip"));
      case UNNAMED_RING, UNNAMED_PATCHES, CARPET_WAVES -> new Expected("ground", PLACE);
      case UNNAMED_ONCE_PER_TURN -> new Expected("ground", Set.of("path", "turn", "rolled"));
      case UNNAMED_FOUR_WAYS -> new Expected("ground", Set.of("heading", "direction"));
      case UNNAMED_IMPACT_SPEED -> new Expected("impact", Set.of("speed"));
      case UNNAMED_LENS_SHEAR ->
          new Expected("measurement", Set.of("image", "camera", "column", "row", "x", "y"));
      case CAMERA_SHAKE ->
          new Expected("measurement", Set.of("time", "session", "frequency", "camera"));
      default -> throw new IllegalArgumentException(cause + " has a name");
    };
  }
}
