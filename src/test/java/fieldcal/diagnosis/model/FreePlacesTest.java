package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.effect.motion.WornRegion;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Standard errors beside places that are not known exactly. */
class FreePlacesTest {
  /** Standard deviation of the prior of a bound, m. */
  private static final double PRIOR = 4;

  private final FittedField field = FittedField.flats("worn_region:change=0.3,region=[-2,20,-2,2]");

  @Test
  void whatIsNotKnownOfAPlaceMakesAStrengthLessCertain() {
    WornRegion region = new WornRegion(0.3, -2, 20, -2, 2);
    FittedModel simple = field.simple();
    FittedModel held =
        field
            .fitter()
            .fit(
                simple.resumedWith(List.of(Component.of(region, region.magnitudes()))),
                simple,
                Weighing.ALIKE,
                FittedField.SOLVER);
    FittedModel free = field.fitter().fitWithPlaces(held, Weighing.ALIKE, FittedField.SOLVER);
    Map<String, Double> before = held.errors(0).orElseThrow();
    Map<String, Double> after = free.errors(0).orElseThrow();
    assertThat(before).containsOnlyKeys("change");
    assertThat(after)
        .containsOnlyKeys("change", "region_x0", "region_x1", "region_y0", "region_y1");
    assertThat(after.get("change")).isGreaterThan(1.2 * before.get("change"));
    assertThat(after.get("region_x0")).isLessThan(0.05);
    // No ball gets as far as this bound.
    assertThat(after.get("region_x1")).isCloseTo(PRIOR, within(0.01 * PRIOR));
    assertThat(free.effects().get(0).value("region_x1")).isEqualTo(20);
  }
}
