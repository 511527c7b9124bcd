package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.effect.EffectCatalogue;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class VerdictTextTest {

  @Test
  void explainedNamesTheCausesAndTheGain() {
    VerdictText text = VerdictText.of(SampleDiagnosis.explained(4));
    assertThat(text.headline())
        .isEqualTo("Passes are predicted 38 mm wrong after 1 s; with what was found 12 mm.");
    assertThat(text.verdict())
        .isEqualTo("The model is wrong, and 2 causes are found: offset of camera 1; air drag.");
    assertThat(text.lines())
        .containsExactly(
            "With what was found in the model, kicks that were held out fit to 1.6 mm instead"
                + " of 14.6 mm (the cameras' noise is 1.5 mm). Predictions are off by 5.1 mm"
                + " instead of 21 mm 0.5 s ahead, 12 mm instead of 38 mm 1 s ahead, 29 mm instead"
                + " of 65 mm 2 s ahead.");
  }

  @Test
  void adequateIsCalm() {
    VerdictText text = VerdictText.of(SampleDiagnosis.adequate(12));
    assertThat(text.first())
        .isEqualTo(
            "Passes are predicted 13 mm wrong after 1 s. The model is right: nothing to correct.");
    assertThat(text.lines().get(0))
        .contains("fit to 1.5 mm rms; the noise of the cameras alone makes 1.5 mm");
    assertThat(text.lines().get(1))
        .startsWith(EffectCatalogue.all().size() + " kinds of causes were tried");
  }

  @Test
  void aFewKicksDoNotProveAModelRight() {
    assertThat(VerdictText.of(SampleDiagnosis.adequate(1)).verdict())
        .isEqualTo("These few kicks show nothing wrong with the model.");
  }

  @Test
  void unexplainedBlamesNobody() {
    VerdictText text = VerdictText.of(SampleDiagnosis.unexplained(4));
    assertThat(text.headline()).isEqualTo("Passes are predicted 19 mm wrong after 1 s.");
    assertThat(text.verdict()).isEqualTo("Something is wrong that no known cause explains.");
    assertThat(text.lines().get(0))
        .isEqualTo(
            "Balls are off by 2.9 mm beyond the noise, depending on the time since the kick, then"
                + " on the speed of the ball.");
    assertThat(text.lines().get(1)).contains("none is named");
    assertThat(text.lines().get(2)).startsWith("Record flat kicks on one line");
  }

  @Test
  void partlyExplainedSaysWhatIsFoundWhatIsLeftAndWhatToDo() {
    VerdictText text = VerdictText.of(SampleDiagnosis.partly(4));
    assertThat(text.headline())
        .isEqualTo("Passes are predicted 50 cm wrong after 1 s; with what was found 9 cm.");
    assertThat(text.verdict())
        .startsWith("The model is wrong, and a part of it is explained: air drag. This also")
        .contains(
            "helps, without a known cause: braking that depends on the speed; height of bounces")
        .contains("Another law applies in the extended model: bounces that build up spin.")
        .endsWith("Chance plays a part: rolling that differs from kick to kick.");
    assertThat(text.lines().get(1))
        .isEqualTo(
            "Still unexplained: balls are off by 2.9 mm beyond the noise, depending on the height"
                + " of the ball, then on the row in the image.");
    assertThat(text.lines().get(2))
        .startsWith("Use the extended model")
        .contains("To find the rest: record chips of different height");
  }

  @Test
  void wherePredictionsGainLittleTheResidualIsTheHeadline() {
    Diagnosis d = SampleDiagnosis.explained(4);
    Quality base = new Quality(14.2, 1.5, 14.6, Map.of(0.5, 5.2, 1.0, 12.9));
    assertThat(headline(d, base))
        .isEqualTo(
            "The model misses kicks that were held out by 14.6 mm; with what was found by 1.6"
                + " mm.");
    Quality few = new Quality(14.2, 1.5, Double.NaN, Map.of());
    assertThat(headline(d, few))
        .isEqualTo("The model misses by 14.2 mm; with what was found by 1.5 mm.");
    Quality brief = new Quality(14.2, 1.5, 14.6, Map.of(0.5, 50.2));
    assertThat(headline(d, brief))
        .isEqualTo("Passes are predicted 50 mm wrong after 0.5 s; with what was found 5 mm.");
  }

  private static String headline(Diagnosis d, Quality base) {
    return VerdictText.of(SampleDiagnosis.with(d, d.causes(), base, List.of())).headline();
  }

  @ParameterizedTest
  @CsvSource({
    "NaN,odds not known",
    "Infinity,certain",
    "21,certain",
    "14,odds better than a million to one",
    "7,odds better than a thousand to one",
    "3.1,odds better than twenty to one",
    "2,odds below twenty to one"
  })
  void evidenceIsSaidAsOdds(double evidence, String words) {
    assertThat(Certainty.of(evidence)).isEqualTo(words);
  }

  @ParameterizedTest
  @EnumSource(StructureVariable.class)
  void everyVariableHasWords(StructureVariable variable) {
    assertThat(StructureWords.of(variable)).doesNotContain("_").isNotBlank();
    assertThat(StructureWords.brief(variable)).doesNotContain("_").isNotBlank();
    assertThat(StructureWords.kicksToRecord(variable)).endsWith(".");
  }
}
