package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.effect.Arena;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.KickSpin;
import fieldcal.fit.joint.SharedSolution.StopReason;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Flat kicks show (1 − spin)·(1 − kSwitch) and nothing else of the two: what mechanics knows of kSwitch tells them apart, and the error says how well. */
class SpinAndSwitchTest {
  @Test
  void theMeanOfTheSpinHasAnErrorThatCoversWhatFlatKicksCannotTell() {
    FittedModel fitted = fit("kick_spin:fraction=-0.2,scatter=0.05");
    double spin = fitted.effects().get(0).value("fraction");
    double kSwitch = fitted.solution().values()[2];
    double error = fitted.errors(0).orElseThrow().get("fraction");
    // dspin = (1 − spin)/(1 − kSwitch)·dkSwitch; the mean of ten kicks errs beside it.
    double mechanics = (1 - spin) / (1 - kSwitch) * BallKnowledge.mechanicalSwitch().deviation();
    assertThat(error).isCloseTo(Math.hypot(mechanics, 0.05 / Math.sqrt(10)), within(0.01));
    assertThat(spin).isCloseTo(-0.2, within(2.5 * error));
    assertThat(fitted.solution().reducedChiSquare()).isLessThan(1.1);
  }

  @Test
  void theValleyBetweenTheTwoIsWalkedToItsEnd() {
    FittedModel fitted = fit("kick_spin:fraction=-0.5,scatter=0.12");
    assertThat(fitted.solution().stopReason()).isEqualTo(StopReason.CONVERGED);
    BallKnowledge known = BallKnowledge.mechanicalSwitch();
    // Nothing but what is known of kSwitch says where in the valley the ball is, and the scatter,
    // which grows with it.
    assertThat(fitted.solution().values()[2]).isCloseTo(known.mean(), within(known.deviation()));
    double error = fitted.errors(0).orElseThrow().get("fraction");
    assertThat(fitted.effects().get(0).value("fraction")).isCloseTo(-0.5, within(2.5 * error));
  }

  /** Bounces show the spin of chips: flat kicks need not have it, too. */
  @Test
  void chipsHaveAMeanOfTheirOwn() {
    ContactImpacts law = new ContactImpacts(0, 0.5, 0, 0, 10);
    FittedField field =
        FittedField.mixed(
            "contact_impacts:reversed=0,friction=0.5",
            "kick_spin:fraction=0.05,chips=-0.35,scatter=0.05");
    Component bounces = Component.of(law, law.magnitudes());
    FittedModel one = fit(field, Component.perKick(new KickSpin(0)), bounces);
    FittedModel two = fit(field, Component.perKick(new KickSpin(0, 0, true)), bounces);
    Map<String, Double> errors = two.errors(0).orElseThrow();
    KickSpin found = (KickSpin) two.effects().get(0);
    // Rolling resistance in impacts takes spin, too, and its strength is not known.
    assertThat(errors.get("chips")).isLessThan(0.16);
    assertThat(found.chips()).isCloseTo(-0.35, within(2.5 * errors.get("chips")));
    assertThat(found.fraction()).isCloseTo(0.05, within(2.5 * errors.get("fraction")));
    assertThat(two.scatter(0)).isLessThan(0.1);
    assertThat(one.scatter(0)).as("one mean takes the difference for chance").isGreaterThan(0.1);
    assertThat(one.evenCost()).isGreaterThan(two.evenCost() + 10);
  }

  @Test
  void whatFlatKicksFoundIsToldApartWhereThereAreChips() {
    Component flats = Component.perKick(new KickSpin(-0.2));
    Component both = flats.in(arena(true));
    assertThat(both.template()).isEqualTo(new KickSpin(-0.2, 0, true));
    assertThat(both.isPerKick()).isTrue();
    assertThat(both.magnitudeCount()).isEqualTo(2);
    assertThat(both.isSameCause(flats)).isTrue();
    assertThat(both.in(arena(false)).template()).isEqualTo(flats.template());
  }

  private static Arena arena(boolean chips) {
    return new Arena(-4, 4, -3, 3, new double[] {10, 30}, true, chips, List.of(), List.of());
  }

  private static FittedModel fit(String effects) {
    return fit(FittedField.flats(effects), Component.perKick(new KickSpin(0)));
  }

  private static FittedModel fit(FittedField field, Component... components) {
    return field
        .fitter()
        .fit(
            field.simple().model().with(List.of(components)),
            field.simple(),
            Weighing.ALIKE,
            FittedField.SOLVER);
  }
}
