package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.hidden.FrozenCases.Frozen;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Outcome;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * The diagnosis must find what is hidden in the {@link FrozenCases}, which were drawn and not chosen: so what is asked for is not that each comes out right, but how many of all do. Rates are measured by {@code
 * ./gradlew hiddenEffectStudy}.
 */
class HiddenEffectTest {
  /** Seeds with a wrong name, which stay in the list until they are right: of this one's waves in the carpet the strip that is worn most is named; the model predicts held-out kicks to 1.1 times the noise. */
  private static final java.util.Set<Long> KNOWN_WRONG = java.util.Set.of(2026000016L);

  /** Visible named causes that are found at least: of the fourteen that are visible; measured of the diagnosis of 2026-11-22, to be raised with what it learns. */
  private static final int LEAST_FOUND = 12;

  /** The extended model may be that much worse on held-out kicks than the simple one, by chance. */
  private static final double NOT_WORSE = 1.02;

  private static List<StudiedCase> cases;

  @BeforeAll
  static void study() {
    List<Frozen> frozen = FrozenCases.all();
    cases =
        frozen.parallelStream()
            .map(f -> StudiedCase.of(f.hidden(), f.visibility()))
            .collect(Collectors.toList());
  }

  private static String all() {
    return cases.stream()
        .map(StudiedCase::toString)
        .collect(Collectors.joining(System.lineSeparator()));
  }

  @Test
  void allComeToAnEnd() {
    assertThat(cases).hasSize(FrozenCases.all().size());
    for (StudiedCase c : cases) {
      c.failure()
          .ifPresent(
              failure -> {
                throw new AssertionError("seed " + c.hidden().seed(), failure);
              });
    }
  }

  @Test
  void nothingIsFoundWhereNothingIs() {
    assertThat(cases.stream().filter(c -> c.hidden().category() == Category.NULL))
        .as(all())
        .isNotEmpty()
        .allMatch(c -> c.outcome().orElseThrow() == Outcome.RIGHT);
  }

  @Test
  void noNameIsWrong() {
    assertThat(
            cases.stream()
                .filter(c -> !c.judgement().orElseThrow().wrong().isEmpty())
                .map(c -> c.hidden().seed()))
        .as(all())
        .isSubsetOf(KNOWN_WRONG);
  }

  @Test
  void visibleCausesAreNamed() {
    long found =
        cases.stream()
            .flatMap(c -> c.judgement().orElseThrow().visible().stream())
            .filter(f -> f.how() != How.NOT)
            .count();
    assertThat(found).as(all()).isGreaterThanOrEqualTo(LEAST_FOUND);
  }

  @Test
  void theExtendedModelIsNeverWorse() {
    assertThat(cases).as(all()).allMatch(c -> !(c.rmsAfter() > NOT_WORSE * c.rmsBefore()));
  }
}
