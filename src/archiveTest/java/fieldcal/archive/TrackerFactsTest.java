package fieldcal.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The same tracker in several matches. */
class TrackerFactsTest {
  private static TrackerFacts facts(
      String log,
      long samples,
      double delay,
      double position,
      long matched,
      double bias,
      double scatter) {
    return new TrackerFacts(
        "Made up",
        Set.of(log),
        samples,
        delay,
        position,
        Double.NaN,
        matched + 2,
        matched,
        1,
        2,
        bias,
        scatter,
        0,
        Double.NaN,
        Double.NaN);
  }

  @Test
  void countsAddUpAndErrorsAreWeighted() {
    TrackerFacts both =
        TrackerFacts.pooled(
            List.of(
                facts("a", 100, 0.01, 0.003, 2, 0.1, 0), facts("b", 300, 0.03, 0.005, 2, 0.3, 0)));
    assertThat(both.matches()).isEqualTo(2);
    assertThat(both.samples()).isEqualTo(400);
    assertThat(both.missed()).isEqualTo(2);
    assertThat(both.invented()).isEqualTo(4);
    assertThat(both.delay()).isCloseTo(0.025, within(1e-12));
    assertThat(both.position()).isCloseTo(Math.sqrt((9e-6 + 3 * 25e-6) / 4), within(1e-12));
    assertThat(both.velocity()).isNaN();
    assertThat(both.stopTime()).isNaN();
    // As the differences of the four kicks themselves: 0.1, 0.1, 0.3, 0.3 m/s.
    assertThat(both.speedBias()).isCloseTo(0.2, within(1e-12));
    assertThat(both.speedScatter()).isCloseTo(Math.sqrt(0.04 / 3), within(1e-12));
  }

  @Test
  void aTrackerThatIsStartedAgainIsStillInOneMatch() {
    TrackerFacts first = facts("a", 100, 0.01, 0.003, 2, 0.1, 0);
    TrackerFacts second = facts("a", 100, 0.01, 0.003, 2, 0.1, 0);
    assertThat(TrackerFacts.pooled(List.of(first, second)).matches()).isEqualTo(1);
  }

  @Test
  void aTrackerWithoutAnythingToCompareHasNoErrors() {
    TrackerFacts none =
        TrackerFacts.pooled(
            List.of(facts("a", 0, Double.NaN, Double.NaN, 0, Double.NaN, Double.NaN)));
    assertThat(none.delay()).isNaN();
    assertThat(none.position()).isNaN();
    assertThat(none.speedBias()).isNaN();
    assertThat(none.speedScatter()).isNaN();
  }
}
