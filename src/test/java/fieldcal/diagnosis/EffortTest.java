package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.model.Effort;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.effect.EffectCatalogue;
import org.junit.jupiter.api.Test;

/** A diagnosis that may not work for long. */
class EffortTest {
  private static final String ENDED = "limit of work";

  private static Diagnosis diagnosed(FittedField field, long effort) {
    return new Diagnoser(EffectCatalogue.all(), effort).diagnose(field.problem(), said -> {});
  }

  @Test
  void isSpentByFits() {
    FittedField field = FittedField.flats("air_drag:cd=0.45");
    Effort effort = new Effort(50);
    ModelFitter fitter =
        new ModelFitter(
            field.fitter().kicks(), field.problem().sessionStart(), effort, fitted -> {});
    assertThat(effort.isSpent()).isFalse();
    assertThat(fitter.among(field.fitter().kicks().subList(0, 5)).effort()).isSameAs(effort);
    fitter.fit(field.simple().model(), FittedField.SOLVER);
    assertThat(effort.isSpent()).isTrue();
  }

  /** Ten kicks, four of which a gust pushes aside: no cause explains them, so that everything is tried. */
  @Test
  void endsTheSearchAndSaysSo() {
    FittedField field = FittedField.flats("air_drag:cd=0.45").withGusts(1, 3, 5, 7);
    Diagnosis ended = diagnosed(field, 20_000);
    assertThat(ended.problems()).hasSize(1).allMatch(p -> p.contains(ENDED));
    assertThat(ended.unexplained().significant()).isTrue();
    assertThat(ended.extended().holdoutRmsMm()).isLessThanOrEqualTo(ended.base().holdoutRmsMm());
    Diagnosis again = diagnosed(field, 20_000);
    assertThat(again.trace()).isEqualTo(ended.trace());
    assertThat(again.causes()).isEqualTo(ended.causes());
  }

  @Test
  void isEnoughForWhatTheCatalogueExplains() {
    FittedField field = FittedField.flats("air_drag:cd=0.45");
    assertThat(new Diagnoser().diagnose(field.problem(), said -> {}).problems()).isEmpty();
  }
}
