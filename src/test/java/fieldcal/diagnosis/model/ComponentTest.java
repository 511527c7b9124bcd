package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.Parameter;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.WornRegion;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Effects in coordinates that are smooth at their absence. */
class ComponentTest {
  private static final double TINY = 1e-12;

  private static Component all(Effect effect) {
    return Component.of(effect, effect.magnitudes());
  }

  static Stream<Effect> growing() {
    return EffectCatalogue.all().stream().filter(e -> e.starts().isEmpty());
  }

  @ParameterizedTest
  @MethodSource("growing")
  void zeroIsAbsent(Effect effect) {
    Component c = all(effect.withNone());
    assertThat(c.effect(new double[c.size()], 0).isAbsent()).isTrue();
    assertThat(c.coordinates()).allMatch(p -> p.value() == 0 && p.estimated());
    double[] some = new double[c.size()];
    some[c.size() - 1] = c.coordinates().get(c.size() - 1).scale();
    assertThat(c.effect(some, 0).isAbsent()).isFalse();
  }

  static Stream<Effect> laws() {
    return EffectCatalogue.all().stream().flatMap(e -> e.starts().stream());
  }

  /** Its absence is another law, and no slope leads from the one to the other. */
  @ParameterizedTest
  @MethodSource("laws")
  void aLawIsNowhereAbsentWithinItsBounds(Effect law) {
    Component c = all(law);
    for (int i = 0; i < c.size(); i++) {
      for (double bound :
          new double[] {c.coordinates().get(i).min(), c.coordinates().get(i).max()}) {
        double[] at = c.coordinates().stream().mapToDouble(Parameter::value).toArray();
        at[i] = bound;
        assertThat(c.effect(at, 0).isAbsent()).as("%s at %s", law, bound).isFalse();
      }
    }
  }

  @Test
  void aMagnitudeWithADirectionIsTwoCartesianCoordinates() {
    Component c = all(new FieldSlope(2, Math.PI / 6));
    assertThat(c.size()).isEqualTo(2);
    assertThat(c.coordinates().stream().map(Parameter::name))
        .containsExactly("field_slope percent x", "field_slope percent y");
    assertThat(c.coordinates().get(0).value()).isCloseTo(Math.sqrt(3), within(TINY));
    assertThat(c.coordinates().get(1).value()).isCloseTo(1, within(TINY));
    Effect there = c.effect(new double[] {Double.NaN, -0.3, 0.4}, 1);
    assertThat(there.value("percent")).isCloseTo(0.5, within(TINY));
    assertThat(there.value("direction")).isCloseTo(Math.atan2(0.4, -0.3), within(TINY));
    assertThat(c.coordinates()).allMatch(p -> p.min() == -p.max());
  }

  @Test
  void errorsOfMagnitudeAndDirectionFollowFromTheCoordinates() {
    Component c = all(new FieldSlope(0, 0));
    double[] at = {9, 3, 4};
    double[][] v = {{1, 0, 0}, {0, 0.04, 0.01}, {0, 0.01, 0.09}};
    Map<String, Double> errors = c.errors(at, v, 1);
    // Along (0.6, 0.8), and across it over the length.
    double along = 0.36 * 0.04 + 2 * 0.48 * 0.01 + 0.64 * 0.09;
    double across = 0.64 * 0.04 - 2 * 0.48 * 0.01 + 0.36 * 0.09;
    assertThat(errors).containsOnlyKeys("percent", "direction");
    assertThat(errors.get("percent")).isCloseTo(Math.sqrt(along), within(TINY));
    assertThat(errors.get("direction")).isCloseTo(Math.sqrt(across) / 5, within(TINY));
  }

  /** The same by differences: how far magnitude and direction move with each coordinate. */
  @Test
  void errorsAreThoseOfTheDerivatives() {
    Component c = all(new FieldSlope(0, 0));
    double[] at = {-0.7, 0.2};
    double[][] v = {{0.02, -0.004}, {-0.004, 0.01}};
    double h = 1e-6;
    for (String name : List.of("percent", "direction")) {
      double[] j = new double[2];
      for (int i = 0; i < 2; i++) {
        double[] up = at.clone();
        double[] down = at.clone();
        up[i] += h;
        down[i] -= h;
        j[i] = (c.effect(up, 0).value(name) - c.effect(down, 0).value(name)) / (2 * h);
      }
      double variance = j[0] * j[0] * v[0][0] + 2 * j[0] * j[1] * v[0][1] + j[1] * j[1] * v[1][1];
      assertThat(c.errors(at, v, 0).get(name)).isCloseTo(Math.sqrt(variance), within(1e-8));
    }
  }

  @Test
  void magnitudesThatAreNotFreeStayZero() {
    Component height = Component.of(new CameraPoseError(0, 0, 0, 0, 0, 1), List.of("height_mm"));
    assertThat(height.size()).isEqualTo(1);
    Effect there = height.effect(new double[] {12}, 0);
    assertThat(there.value("height_mm")).isEqualTo(12);
    assertThat(there.value("tilt_mrad")).isZero();
    assertThat(there.value("shift_x_mm")).isZero();
    assertThat(there.value("camera")).isEqualTo(1);
    assertThat(height.camera()).hasValue(1);
    assertThat(all(new AirDrag(0)).camera()).isEmpty();
  }

  @Test
  void valuesStayWithinTheirBounds() {
    Component c = all(new AirDrag(0));
    Parameter cd = new AirDrag(0).parameters().get(0);
    assertThat(c.effect(new double[] {1e6}, 0).value("cd")).isEqualTo(cd.max());
    assertThat(c.effect(new double[] {-1e6}, 0).value("cd")).isEqualTo(cd.min());
  }

  @Test
  void aPlaceIsFreeOnDemand() {
    Component held = all(new WornRegion(0.2, -1, 1, -2, 2));
    assertThat(held.hasPlace()).isTrue();
    assertThat(held.size()).isEqualTo(1);
    Component free = held.withPlaceFree();
    assertThat(free.size()).isEqualTo(5);
    assertThat(free.magnitudeCount()).isEqualTo(1);
    assertThat(free.effect(new double[] {0.3, -1.5, 1, -2, 2.5}, 0))
        .isEqualTo(new WornRegion(0.3, -1.5, 1, -2, 2.5));
    assertThat(free.withPlaceHeld().size()).isEqualTo(1);
    assertThat(held.isSameCause(all(new WornRegion(0, 0, 3, 0, 3))))
        .as("another place is the same cause")
        .isTrue();
  }

  @Test
  void knowledgeIsAboutAbsenceButForLawsThatReplaceAnother() {
    Prior drag = all(new AirDrag(0.4)).priors().get(0);
    assertThat(drag.mean()).isZero();
    assertThat(drag.precision()).isPositive();
    Effect start = new ContactImpacts(0, 0, 0, 0, 10).starts().get(0);
    assertThat(all(start).priors().get(1).mean()).isEqualTo(start.value("friction"));
  }
}
