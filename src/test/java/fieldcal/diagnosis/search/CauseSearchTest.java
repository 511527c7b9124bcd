package fieldcal.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Among all effects of the catalogue. */
class CauseSearchTest {
  private static final int MOST = 6;

  private static CauseSearch search(FittedField field) {
    return new CauseSearch(
        field.fitter(),
        new Dictionary(EffectCatalogue.all(), field.arena()),
        MOST,
        FittedField.SOLVER,
        part -> {});
  }

  @Test
  void twoCausesAtOnceAreFound() {
    FittedField field =
        FittedField.flats("air_drag:cd=0.45", "camera_offset:x_mm=10,y_mm=-4,camera=1");
    CauseSearch search = search(field);
    FittedModel found = search.search(field.simple(), true);
    List<Effect> effects = found.effects();
    assertThat(effects.stream().map(Effect::id))
        .as("%s", search.trace())
        .containsExactlyInAnyOrder("air_drag", "camera_offset");
    assertThat(found.solution().reducedChiSquare()).isCloseTo(1, within(0.15));
    for (int i = 0; i < effects.size(); i++) {
      if (effects.get(i).id().equals("air_drag")) {
        double error = found.errors(i).orElseThrow().get("cd");
        assertThat(effects.get(i).value("cd")).isCloseTo(0.45, within(3 * error + 0.01));
      }
    }
    assertThat(search.trace()).isNotEmpty();
  }

  @Test
  void nothingIsFoundOnASoundField() {
    for (FittedField field : List.of(FittedField.flats(), FittedField.chips())) {
      CauseSearch search = search(field);
      FittedModel found = search.search(field.simple(), true);
      assertThat(found.effects()).as("%s", search.trace()).isEmpty();
    }
  }
}
