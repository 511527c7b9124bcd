package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.app.statistics.Holm;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** How certain it is that only one side has a cause. */
class DifferencesTest {
  private static final int KICKS = 4;

  /** Recordings with nothing wrong in which the diagnosis names or learns something, at most (docs/diagnosis.md). */
  private static final double FALSE_DIAGNOSIS = 0.005;

  private static Cause spin(double mean, double scatter, double evidence) {
    return new Cause(
        new KickSpin(mean),
        Map.of("fraction", 0.04),
        scatter,
        evidence,
        new Gain(1, 10, 0.5, 1.5),
        List.of());
  }

  @Test
  void aCauseThatScattersIsThereWhateverItsMeanIs() {
    assertThat(Differences.ofPresence(spin(0.001, 0.2, 400), 0.025)).isLessThan(1e-12);
    // Two degrees of freedom: the probability is e to the minus half of chi-square.
    assertThat(Differences.ofPresence(spin(0.1, 0.2, 3), 2.5))
        .isCloseTo(Math.exp(-3), within(1e-9));
  }

  @Test
  void aCauseThatIsTheSameForAllKicksIsTestedByItsSize() {
    assertThat(Differences.ofPresence(spin(0.04, 0, 400), 1)).isCloseTo(0.3173, within(1e-4));
  }

  /** A learned term is not among what is corrected: its false alarms are those of the two diagnoses. */
  @Test
  void theDocumentAddsTheFalseAlarmsOfBothDiagnoses() throws IOException {
    Path document = Path.of(System.getProperty("fieldcal.projectDir", "."), "docs", "compare.md");
    double sum = FieldComparison.ALPHA + 2 * FALSE_DIAGNOSIS;
    assertThat(Files.readString(document).replaceAll("\\s+", " "))
        .contains(
            String.format(
                Locale.ROOT,
                "any difference is named with a probability of at most %.0f %%",
                100 * sum));
  }

  private static Diagnosis sloping(double percent, double direction) {
    Cause slope =
        new Cause(
            new FieldSlope(percent, direction),
            Map.of("percent", 0.01, "direction", 0.05),
            0,
            400,
            new Gain(1, 10, 0.5, 1.5),
            List.of());
    Diagnosis none = SampleDiagnosis.adequate(KICKS);
    return SampleDiagnosis.with(none, List.of(slope), none.base(), none.problems());
  }

  private static List<String> found(Diagnosis real, Diagnosis sim) {
    Differences all = Differences.of(real, sim);
    return all.judged(Holm.corrected(all.probabilities())).significant().stream()
        .map(Difference::id)
        .toList();
  }

  @Test
  void aSlopeInAnotherDirectionIsADifference() {
    assertThat(found(sloping(0.2, 1), sloping(0.21, 1.05))).isEmpty();
    assertThat(found(sloping(0.2, 1), sloping(0.2, 2))).containsExactly("field_slope.direction");
    assertThat(found(sloping(0.2, 1), sloping(0.3, 1))).containsExactly("field_slope");
  }

  @Test
  void directionsDifferTheShortWayRound() {
    assertThat(found(sloping(0.2, 3.13), sloping(0.2, -3.13))).isEmpty();
  }

  /** It is taken out of the simulator as a whole. */
  @Test
  void aCauseIsOneDifferenceHoweverManyOfItsNumbersDiffer() {
    assertThat(found(sloping(0.2, 1), sloping(0.5, 2))).containsExactly("field_slope");
    assertThat(found(sloping(0.2, 1), sloping(0.26, 3))).containsExactly("field_slope.direction");
  }
}
