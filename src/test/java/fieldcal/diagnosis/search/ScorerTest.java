package fieldcal.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.WornRegion;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Score tests against what joint refits gain. */
class ScorerTest {
  /** Second-order terms of these effects make up less than that share. */
  private static final double SECOND_ORDER = 0.05;

  private final FittedField field =
      FittedField.flats("air_drag:cd=0.05", "camera_offset:x_mm=2,y_mm=-1,camera=1");

  private static Component all(Effect effect) {
    return Component.of(effect, effect.magnitudes());
  }

  private final Component drag = all(new AirDrag(0));
  private final Component offset = all(new CameraOffset(0, 0, 1));
  private final Component other = all(new CameraOffset(0, 0, 0));
  private final Component nap = all(new CarpetNap(0, 0));

  private FittedModel fitted(FittedModel start, Component... components) {
    return field
        .fitter()
        .fit(
            start.model().with(List.of(components)),
            start,
            Weighing.EXPLAINED_FIRST,
            FittedField.SOLVER);
  }

  @Test
  void gainBesideTheModelIsWhatARefitGains() {
    Scorer scorer =
        new Scorer(field.simple(), List.of(drag, offset, nap), Weighing.EXPLAINED_FIRST);
    for (Component c : List.of(drag, offset)) {
      double expected =
          new Price(Weighing.EXPLAINED_FIRST).gain(field.simple(), fitted(field.simple(), c));
      assertThat(scorer.gain(Proposal.of(c), scorer.sweep()))
          .isCloseTo(expected, within(SECOND_ORDER * expected));
    }
    double both =
        new Price(Weighing.EXPLAINED_FIRST)
            .gain(field.simple(), fitted(field.simple(), drag, offset));
    assertThat(scorer.gain(new Proposal(List.of(drag, offset), false), scorer.sweep()))
        .isCloseTo(both, within(SECOND_ORDER * both));
  }

  @Test
  void withoutAComponentItsOwnColumnsGainWhatItExplains() {
    FittedModel both = fitted(field.simple(), drag, offset);
    Scorer scorer = new Scorer(both, List.of(other, nap), Weighing.EXPLAINED_FIRST);
    for (int i : new int[] {0, 1}) {
      FittedModel without = fitted(both, both.model().components().get(1 - i));
      double expected = -new Price(Weighing.EXPLAINED_FIRST).gain(both, without);
      assertThat(scorer.without(List.of(i)).gain(scorer.modelColumns(i)))
          .isCloseTo(expected, within(SECOND_ORDER * expected));
    }
  }

  /** Of two cameras the one's offset is the opposite of the other's. */
  @Test
  void withoutAComponentItsEqualGainsAsMuch() {
    FittedModel both = fitted(field.simple(), drag, offset);
    Scorer scorer = new Scorer(both, List.of(other, nap), Weighing.EXPLAINED_FIRST);
    Sweep without = scorer.without(List.of(1));
    double own = without.gain(scorer.modelColumns(1));
    assertThat(without.gain(scorer.columns(other))).isCloseTo(own, within(1e-3 * own));
    assertThat(without.gain(scorer.columns(nap))).isLessThan(0.5 * own);
    // With the component in, its equal has nothing to add.
    assertThat(scorer.sweep().gain(scorer.columns(other))).isLessThan(1e-3 * own);
  }

  /** To first order a region does what its tiles do together. */
  @Test
  void tilesGainTogetherWhatTheirRegionGains() {
    List<Place> places =
        Place.of(new WornRegion(0, 0, 0, 0, 0).mosaic(field.arena()).orElseThrow());
    List<Place> few = List.of(places.get(3), places.get(places.size() / 2));
    List<Component> all = new ArrayList<>(Place.tiles(few));
    few.forEach(p -> all.add(p.component()));
    Scorer scorer = new Scorer(field.simple(), all, Weighing.EXPLAINED_FIRST);
    for (Place p : few) {
      double whole = scorer.gain(p.proposal(), scorer.sweep());
      assertThat(p.tiles()).hasSizeGreaterThan(2);
      assertThat(whole).isPositive();
      assertThat(p.gain(scorer, scorer.sweep())).isCloseTo(whole, within(SECOND_ORDER * whole));
    }
  }
}
