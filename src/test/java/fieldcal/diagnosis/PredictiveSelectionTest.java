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
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
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

  /** The same with some balls pushed aside, 1 m/s² for a second. */
  private static FittedField gusts(FittedField calm, int... pushed) {
    List<KickFit> fits = new ArrayList<>(calm.problem().fits());
    for (int k : pushed) {
      double from = 0.2 + 0.05 * k;
      Kick kick =
          MovedBall.shifted(
              fits.get(k).kick(), t -> 0.5 * Math.pow(Math.min(1, Math.max(0, t - from)), 2));
      fits.set(k, calm.fit(kick, KickKind.FLAT));
    }
    return FittedField.of(calm.problem(fits));
  }

  /** What pushes a few balls is in no other kick. */
  @Test
  void nothingIsSelectedForAFewKicks() {
    FittedField calm = FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 14));
    FittedField field = gusts(calm, 2, 5, 8, 11);
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
    FittedField field = gusts(calm, 5);
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
