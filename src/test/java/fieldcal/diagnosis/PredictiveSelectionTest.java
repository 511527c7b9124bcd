package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.simulation.ScenarioKind;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What predicts kicks that were held out is selected, and nothing else. */
class PredictiveSelectionTest {
  private static final long SEED = 20260101;

  private final List<SearchStep> trace = new ArrayList<>();

  private FittedModel selected(FittedField field) {
    Arena arena = field.arena();
    List<Effect> effects = new ArrayList<>(EffectCatalogue.all());
    effects.addAll(LearnedLibrary.of(arena));
    effects.addAll(LearnedLibrary.maps(arena));
    return new PredictiveSelection(
            field.fitter(), new Dictionary(effects, arena), FittedField.SOLVER, SEED)
        .from(field.simple(), trace);
  }

  @Test
  void nothingIsSelectedFromNoise() {
    FittedField field = FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 14));
    assertThat(selected(field)).isSameAs(field.simple());
    assertThat(trace).isEmpty();
  }

  /** What pushes a few balls is in no other kick. */
  @Test
  void nothingIsSelectedForAFewKicks() {
    FittedField calm = FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 14));
    FittedField field = calm.withGusts(2, 5, 8, 11);
    assertThat(selected(field)).isSameAs(field.simple());
    assertThat(trace).isEmpty();
  }

  @Test
  void aKickThatNothingExplainsHidesNoCause() {
    FittedField calm =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 14)
                .withEffects("speed_dependent_roll:slope=0.08"));
    FittedField field = calm.withGusts(5);
    FittedModel found = selected(field);
    assertThat(found.effects())
        .as("%s", trace)
        .extracting(Effect::id)
        .startsWith("speed_dependent_roll");
    HoldOut before = HoldOut.of(field.simple(), true, SEED);
    HoldOut after = HoldOut.of(found, true, SEED);
    assertThat(after.followsMostBetterThan(before, SEED)).isTrue();
    assertThat(after.usualMm()).isLessThan(0.6 * before.usualMm());
  }
}
