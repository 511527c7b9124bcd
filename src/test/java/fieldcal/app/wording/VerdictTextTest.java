package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.effect.EffectCatalogue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class VerdictTextTest {

  @Test
  void explainedNamesTheCausesAndTheGain() {
    VerdictText text = VerdictText.of(SampleDiagnosis.explained(4));
    assertThat(text.headline())
        .isEqualTo(
            "The model is wrong, and 2 causes are found: camera offset, camera 1; air drag.");
    assertThat(text.lines())
        .containsExactly(
            "With them in the model, kicks that it has never seen fit to 1.6 mm instead of 14.6 mm"
                + " (the cameras' noise is 1.5 mm). Predictions are off by 5.1 mm instead of 21 mm"
                + " 0.5 s ahead, 12 mm instead of 38 mm 1 s ahead, 29 mm instead of 65 mm 2 s"
                + " ahead.");
  }

  @Test
  void adequateIsCalm() {
    VerdictText text = VerdictText.of(SampleDiagnosis.adequate(4));
    assertThat(text.headline()).isEqualTo("The model is right: nothing to correct.");
    assertThat(text.lines().get(0)).contains("are 1.5 mm; their noise alone makes 1.5 mm");
    assertThat(text.lines().get(1))
        .startsWith(EffectCatalogue.all().size() + " sorts of causes were tried");
    assertThat(text.lines().get(2)).contains("1 s ahead to 13 mm");
  }

  @Test
  void unexplainedBlamesNobody() {
    VerdictText text = VerdictText.of(SampleDiagnosis.unexplained(4));
    assertThat(text.headline()).isEqualTo("Something is wrong that no known cause explains.");
    assertThat(text.lines().get(0))
        .isEqualTo(
            "Balls are off by 2.9 mm beyond the noise, depending on the time since the kick, then"
                + " on the speed of the ball.");
    assertThat(text.lines().get(1)).contains("none is blamed");
    assertThat(text.lines().get(2)).startsWith("Record flat kicks on one line");
  }

  @ParameterizedTest
  @EnumSource(StructureVariable.class)
  void everyVariableHasWords(StructureVariable variable) {
    assertThat(StructureWords.of(variable)).doesNotContain("_").isNotBlank();
    assertThat(StructureWords.brief(variable)).doesNotContain("_").isNotBlank();
    assertThat(StructureWords.kicksToRecord(variable)).endsWith(".");
  }
}
