package fieldcal.diagnosis.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.Basis;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Variable;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.WornRegion;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What kicks tell of a component when everything else follows. */
class InformationTest {
  private static FittedModel fitted(FittedField field, Effect... effects) {
    FittedModel simple = field.simple();
    List<Component> components =
        Arrays.stream(effects).map(e -> Component.of(e, e.magnitudes())).toList();
    return field
        .fitter()
        .fit(simple.model().with(components), simple, Weighing.ALIKE, FittedField.SOLVER);
  }

  @Test
  void twoThatAreTheSameDoTheSame() {
    FittedField field = FittedField.flats("worn_region:change=0.3,region=[-2,2,-2,2]");
    WornRegion absent = new WornRegion(0, -2, 2, -2, 2);
    Information two = Information.of(fitted(field, absent, absent));
    assertThat(two.shared(0, new int[] {1})).isCloseTo(1, within(1e-3));
    assertThat(two.shared(0, new int[0])).isZero();
  }

  /** A curve over the speed could do what drag does; as it is fitted, it corrects it by a tenth. */
  @Test
  void aCurveThatHardlyCorrectsACauseTakesLittleBack() {
    FittedField field = FittedField.flats("air_drag:cd=0.45");
    Basis speed = new Spline(0, 6.5, 6, true);
    Effect curve = LearnedFamily.of(Quantity.ACCELERATION_ALONG, Variable.SPEED, speed).absent();
    FittedModel model = fitted(field, new AirDrag(0), curve);
    assertThat(Information.of(model).shared(0, new int[] {1})).isBetween(-0.2, 0.0);
  }
}
