package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.effect.EffectCatalogue;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Collections;
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
        .isEqualTo(
            "The calibrated model is off by 38 mm after 1 s, the extended" + " model by 12 mm.");
    assertThat(text.verdict())
        .isEqualTo(
            "These kicks do not follow the model, and 2 causes are found: offset of camera 1; air"
                + " drag.");
    assertThat(text.lines())
        .containsExactly(
            "With the extended model, held-out kicks fit to 1.6 mm instead"
                + " of 14.6 mm (the cameras' noise is 1.5 mm). Predictions are off by 5.1 mm"
                + " instead of 21 mm 0.5 s ahead, 12 mm instead of 38 mm 1 s ahead, 29 mm instead"
                + " of 65 mm 2 s ahead.");
  }

  @Test
  void adequateIsCalm() {
    VerdictText text = VerdictText.of(SampleDiagnosis.adequate(12));
    assertThat(text.first())
        .isEqualTo(
            "The calibrated model is off by 13 mm after 1 s. These kicks show no error beyond"
                + " noise.");
    assertThat(text.lines().get(0))
        .contains("fit to 1.5 mm rms; the noise of the cameras alone is 1.5 mm");
    assertThat(text.lines().get(1))
        .startsWith(EffectCatalogue.all().size() + " kinds of causes were tried");
  }

  @Test
  void aFewKicksDoNotProveAModelRight() {
    assertThat(VerdictText.of(SampleDiagnosis.adequate(1)).verdict())
        .isEqualTo("These few kicks show nothing wrong with the model beyond noise.");
  }

  @Test
  void unexplainedBlamesNobody() {
    VerdictText text = VerdictText.of(SampleDiagnosis.unexplained(4));
    assertThat(text.headline()).isEqualTo("The calibrated model is off by 19 mm after 1 s.");
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
        .isEqualTo(
            "The calibrated model is off by 50 cm after 1 s, the extended" + " model by 9 cm.");
    assertThat(text.verdict())
        .startsWith(
            "These kicks do not follow the model, and a part of that is explained: air drag."
                + " Without")
        .contains(
            "Without a proven cause, held-out kicks also fit better with braking that depends on"
                + " the speed, height of bounces")
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

  /** What a law of the catalogue explains is not called unknown. */
  @Test
  void aLawWithoutCausesIsNamedFirst() {
    Diagnosis d = SampleDiagnosis.partly(4);
    Diagnosis lawAlone = SampleDiagnosis.with(d, List.of(), d.base(), d.problems());
    assertThat(VerdictText.of(lawAlone).verdict())
        .startsWith(
            "These kicks do not follow the model. Another law replaces one of its own: bounces that"
                + " build up spin. Without a proven cause, held-out kicks also fit better with ")
        .doesNotContain("no known cause", "Another law applies");
  }

  /** Of real recordings: spin that differs from kick to kick follows whole kicks ten times better, and the first 0.3 s of a kick do not show it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "103.6 | 95.7 | 104 mm after 1 s, the extended model by 96 mm, hardly better.",
        "60.0 | 55.0 | 60 mm after 1 s, the extended model by 55 mm, hardly better.",
        "12.5 | 12.4 | 13 mm after 1 s, the extended model by 12 mm, no better.",
        "41.6 | 47.6 | 42 mm after 1 s, the extended model by 48 mm, worse."
      })
  void theFirstLinePromisesNoMoreThanTheTableHolds(double before, double after, String said) {
    Diagnosis d = predicting(Map.of(1.0, before), Map.of(1.0, after));
    assertThat(VerdictText.of(d).headline())
        .isEqualTo(
            "The calibrated model is off by "
                + said
                + " Whole held-out kicks are followed to 1.6 mm instead of 14.6 mm.");
  }

  @Test
  void withoutPredictionsTheResidualIsTheHeadline() {
    Diagnosis d = SampleDiagnosis.explained(4);
    Quality few = SampleDiagnosis.quality(14.2, 1.5, Double.NaN, Map.of());
    assertThat(headline(d, few))
        .isEqualTo(
            "The calibrated model misses the kicks by 14.2 mm, the extended model by 1.5 mm.");
    Quality brief = SampleDiagnosis.quality(14.2, 1.5, 14.6, Map.of(0.5, 50.2));
    assertThat(headline(d, brief))
        .isEqualTo(
            "The calibrated model is off by 50 mm after 0.5 s, the extended" + " model by 5 mm.");
  }

  private static String headline(Diagnosis d, Quality base) {
    return VerdictText.of(SampleDiagnosis.with(d, d.causes(), base, List.of())).headline();
  }

  private static Diagnosis predicting(Map<Double, Double> before, Map<Double, Double> after) {
    Diagnosis d = SampleDiagnosis.explained(4);
    return SampleDiagnosis.leaving(
        SampleDiagnosis.with(
            d, d.causes(), SampleDiagnosis.quality(14.2, 1.5, 14.6, before), List.of()),
        SampleDiagnosis.quality(1.52, 1.5, 1.56, after),
        d.unexplained());
  }

  @Test
  void nothingHelpsAlsoWhereNoCauseIsNamed() {
    Diagnosis partly = SampleDiagnosis.partly(4);
    Diagnosis d =
        SampleDiagnosis.learning(
            partly,
            partly.learned().stream().filter(f -> f.kind() != LearnedFinding.Kind.LAW).toList());
    Diagnosis unnamed = SampleDiagnosis.with(d, List.of(), d.base(), List.of());
    assertThat(VerdictText.of(unnamed).verdict())
        .startsWith(
            "These kicks do not follow the model, and no cause is proven. Held-out kicks fit better"
                + " with ")
        .doesNotContain("also");
  }

  /** Where the extended model errs more, it has to be said. */
  @Test
  void anExplanationThatPredictsWorseSaysSo() {
    String caveat = "does not always predict them better from their first 0.3 s";
    Map<Double, Double> before = Map.of(0.5, 20.3, 1.0, 41.6, 2.0, 76.9);
    Diagnosis worse = predicting(before, Map.of(0.5, 24.7, 1.0, 47.6, 2.0, 100.8));
    assertThat(VerdictText.of(worse).lines()).anyMatch(line -> line.contains(caveat));
    Diagnosis partlyWorse = predicting(before, Map.of(0.5, 21.0, 1.0, 30.0, 2.0, 60.0));
    assertThat(VerdictText.of(partlyWorse).lines()).anyMatch(line -> line.contains(caveat));
    Diagnosis same = predicting(before, Map.of(0.5, 20.1, 1.0, 41.9, 2.0, 76.0));
    assertThat(VerdictText.of(same).lines())
        .anyMatch(line -> line.contains("predicts them as well as the calibrated one"));
    Diagnosis hardly = predicting(before, Map.of(0.5, 20.1, 1.0, 39.0, 2.0, 70.0));
    assertThat(VerdictText.of(hardly).headline()).contains("hardly better");
    assertThat(VerdictText.of(hardly).lines())
        .anyMatch(line -> line.contains("predicts them hardly better"));
    CauseWords words = new CauseWords(hardly, SampleDiagnosis.observers());
    assertThat(hardly.causes())
        .allSatisfy(c -> assertThat(words.of(c).advice()).doesNotContain("extended model"));
    Diagnosis better = predicting(before, Map.of(0.5, 20.1, 1.0, 30.0, 2.0, 60.0));
    assertThat(VerdictText.of(better).lines()).noneMatch(line -> line.contains("0.3 s"));
  }

  @Test
  void oneKickThatIsMetresOffIsNotTheHeadline() {
    Diagnosis d = SampleDiagnosis.explained(4);
    Quality base =
        new Quality(13.6, 1.5, 17.8, Map.of(0.5, 514.7, 1.0, 1048.7), Map.of(0.5, 28.1, 1.0, 54.3));
    VerdictText text = VerdictText.of(SampleDiagnosis.with(d, d.causes(), base, List.of()));
    assertThat(text.headline())
        .isEqualTo(
            "The calibrated model is off by 54 mm after 1 s, the extended" + " model by 12 mm.");
    assertThat(text.lines())
        .contains(
            "With the calibrated model, some kicks are predicted far worse than most: 1 s ahead,"
                + " the root mean square error of all kicks is 1049 mm, the typical error 54 mm.");
    assertThat(VerdictText.of(d).lines()).noneMatch(line -> line.contains("far worse"));
  }

  /** A low chip may be taken for a flat kick, and a wild flat kick for a chip. */
  @ParameterizedTest
  @CsvSource({
    "34, 1, 'For passes, the'",
    "9, 1, 'For passes, the'",
    "8, 2, The",
    "2, 8, The",
    "1, 9, 'For chips, the'",
    "1, 34, 'For chips, the'"
  })
  void kicksAreCalledWhatNearlyAllOfThemAre(int flats, int chips, String called) {
    Diagnosis d = SampleDiagnosis.adequate(8);
    List<KickResiduals> kicks = new ArrayList<>();
    kicks.addAll(Collections.nCopies(flats, first(d, KickKind.FLAT)));
    kicks.addAll(Collections.nCopies(chips, first(d, KickKind.CHIP)));
    assertThat(VerdictText.of(SampleDiagnosis.of(d, kicks)).headline())
        .isEqualTo(called + " calibrated model is off by 13 mm after 1 s.");
  }

  private static KickResiduals first(Diagnosis d, KickKind kind) {
    return d.kicks().stream().filter(k -> k.kind() == kind).findFirst().orElseThrow();
  }

  @Test
  void whatGainsNothingBeyondChanceIsNotSaidToHelp() {
    Diagnosis d = SampleDiagnosis.partly(4);
    List<LearnedFinding> learned = new ArrayList<>(d.learned());
    LearnedFinding braking = learned.get(1);
    learned.set(
        1,
        new LearnedFinding(
            braking.effect(),
            braking.actsOn(),
            braking.dependsOn(),
            braking.camera(),
            braking.curves(),
            braking.scatter(),
            braking.follows(),
            new Gain(0.011, 0.4, -1.2, 1.2)));
    String verdict = VerdictText.of(SampleDiagnosis.learning(d, learned)).verdict();
    assertThat(verdict)
        .contains(
            "Without a proven cause, held-out kicks also fit better with height of bounces that")
        .endsWith(
            " Held-out kicks do not show whether this helps: braking that depends on the"
                + " speed.");
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
