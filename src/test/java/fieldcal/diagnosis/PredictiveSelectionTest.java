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
            field.fitter(), new Dictionary(effects, arena), FittedField.SOLVER, SEED, trace)
        .from(field.simple());
  }

  @Test
  void nothingIsSelectedFromNoise() {
    FittedField field = FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 14));
    assertThat(selected(field)).isSameAs(field.simple());
    assertThat(trace).isEmpty();
  }

  /** A gust pushes one ball aside, 1 m/s² for a second; no other kick shows it, and no model can predict it. */
  @Test
  void aKickThatNothingExplainsHidesNoCause() {
    FittedField calm =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 14)
                .withEffects("speed_dependent_roll:slope=0.08"));
    List<KickFit> fits = new ArrayList<>(calm.problem().fits());
    Kick kick = fits.get(5).kick();
    Kick pushed =
        MovedBall.shifted(kick, t -> 0.5 * Math.pow(Math.min(1, Math.max(0, t - 0.5)), 2));
    fits.set(5, calm.fit(pushed, KickKind.FLAT));
    FittedField field = FittedField.of(calm.problem(fits));
    FittedModel found = selected(field);
    assertThat(found.effects())
        .as("%s", trace)
        .extracting(Effect::id)
        .contains("speed_dependent_roll");
    HoldOut before = HoldOut.of(field.simple(), true, SEED);
    HoldOut after = HoldOut.of(found, true, SEED);
    System.out.printf("usual kick held out: %.2f -> %.2f mm%n", before.usualMm(), after.usualMm());
    assertThat(after.followsMostBetterThan(before, SEED)).isTrue();
    assertThat(after.usualMm()).isLessThan(0.6 * before.usualMm());
    assertThat(trace).hasSameSizeAs(found.model().components());
  }
}
