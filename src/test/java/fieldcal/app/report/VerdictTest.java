package fieldcal.app.report;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.CalibrationReport.Kind;
import fieldcal.app.report.CalibrationReport.Model;
import fieldcal.app.report.CalibrationReport.ModelParameter;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VerdictTest {
  private static final CalibrationReport SESSION = SampleReport.session(3);

  @Test
  void saysWhatDiffersFromThePublishedModel() {
    Verdict verdict = of(parameter(-3.1, 0.02, 26, -3.0), parameter(-0.315, 0.004, 26, -0.26));
    assertThat(verdict.advice()).isEqualTo(Verdict.Advice.PUBLISH);
    assertThat(verdict.lines())
        .containsExactly(
            "Flat model from 26 of 28 kicks: accSlide −3.100 ± 0.020 m/s², accSlide −0.315 ± 0.004"
                + " m/s²; differs from the published model: accSlide +3 %, accSlide +21 % —"
                + " publish it.");
  }

  @ParameterizedTest
  @CsvSource({
    // mean, error, n, published, advice
    "-3.00, 0.02, 20, -3.00, KEEP",
    "-3.05, 0.001, 20, -3.00, KEEP", // certain, but too small to matter
    "-3.20, 0.10, 20, -3.00, KEEP", // large, but may be chance
    "-3.20, 0.02, 20, -3.00, PUBLISH",
    "-3.20, 0.02, 20, NaN, PUBLISH",
    "-3.20, 0.02, 4, -3.00, RECORD_MORE",
    "-3.20, 0.40, 20, -3.00, RECORD_MORE",
    "NaN, NaN, 0, -3.00, RECORD_MORE",
  })
  void advises(double mean, double error, int n, double published, Verdict.Advice advice) {
    assertThat(of(parameter(mean, error, n, published)).advice()).isEqualTo(advice);
  }

  @Test
  void asksForKicksWhenThereAreNone() {
    Verdict verdict = Verdict.of(SampleReport.of(List.of(), List.of(), Optional.empty()));
    assertThat(verdict.advice()).isEqualTo(Verdict.Advice.NO_KICKS);
    assertThat(verdict.lines().get(0)).startsWith("No kick found in session.log.gz");
  }

  @Test
  void kicksWithoutAnyModelAreNoVerdictButARequest() {
    Verdict verdict = Verdict.of(SampleReport.of(List.of(), SESSION.kicks(), Optional.empty()));
    assertThat(verdict.advice()).isEqualTo(Verdict.Advice.RECORD_MORE);
    assertThat(verdict.lines().get(0)).startsWith("None of the kicks found (60)");
  }

  @Test
  void theGravestAdviceOfTheModelsCounts() {
    Model good = model(parameter(-3.2, 0.02, 20, -3));
    Model poor = new Model(Kind.CHIP, List.of(parameter(-3.2, 0.02, 2, -3)), 1, "");
    CalibrationReport report =
        SampleReport.of(List.of(good, poor), SESSION.kicks(), Optional.empty());
    assertThat(Verdict.of(report).advice()).isEqualTo(Verdict.Advice.RECORD_MORE);
    assertThat(Verdict.of(report).lines()).hasSize(2);
  }

  @Test
  void aPublishedZeroHasNoPercentage() {
    assertThat(parameter(-3, 0.1, 20, 0).differencePercent()).isNaN();
    assertThat(parameter(-3, 0.1, 20, 0).differs()).isFalse();
  }

  private static Verdict of(ModelParameter... parameters) {
    return Verdict.of(
        SampleReport.of(List.of(model(parameters)), SESSION.kicks(), Optional.empty()));
  }

  private static Model model(ModelParameter... parameters) {
    return new Model(Kind.FLAT, List.of(parameters), 2, "");
  }

  private static ModelParameter parameter(double mean, double error, int n, double published) {
    return new ModelParameter(
        "accSlide", "m/s²", mean, error, n, 0.1, Double.NaN, Double.NaN, published, "");
  }
}
