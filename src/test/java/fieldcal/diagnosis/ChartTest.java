package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.effect.Effect;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.FieldSlope;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What a fit sees of an effect must be smooth where the effect is absent, and lead back to the effect. */
class ChartTest {
  private static final Chart SLOPE = Chart.of(new FieldSlope(0, 0));

  private static double value(Effect effect, String name) {
    return effect.parameters().stream()
        .filter(p -> p.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }

  @Test
  void aMagnitudeWithADirectionIsTwoComponents() {
    assertThat(SLOPE.size()).isEqualTo(2);
    Effect up = SLOPE.effect(new double[] {9, 0.3, 0.4}, 1);
    assertThat(value(up, "percent")).isCloseTo(0.5, within(1e-12));
    assertThat(value(up, "direction")).isCloseTo(Math.atan2(0.4, 0.3), within(1e-12));
    assertThat(SLOPE.effect(new double[2], 0).isAbsent()).isTrue();
  }

  @Test
  void errorsOfComponentsBecomeThoseOfSizeAndDirection() {
    double[] at = {0.3, 0.4};
    double[][] covariance = {{4e-4, 1e-4}, {1e-4, 9e-4}};
    Map<String, Double> errors = SLOPE.errors(at, covariance, 0);
    double h = 1e-6;
    for (String name : new String[] {"percent", "direction"}) {
      double[] slope = new double[2];
      for (int k = 0; k < 2; k++) {
        double[] moved = at.clone();
        moved[k] += h;
        slope[k] = (value(SLOPE.effect(moved, 0), name) - value(SLOPE.effect(at, 0), name)) / h;
      }
      double variance =
          slope[0] * slope[0] * covariance[0][0]
              + 2 * slope[0] * slope[1] * covariance[0][1]
              + slope[1] * slope[1] * covariance[1][1];
      assertThat(errors.get(name)).as(name).isCloseTo(Math.sqrt(variance), within(1e-6));
    }
  }

  @Test
  void strengthsStayWithinWhatIsPossible() {
    Chart drag = Chart.of(new AirDrag(0));
    Effect most = drag.effect(new double[] {1e9}, 0);
    assertThat(value(most, "cd")).isEqualTo(drag.limit(0));
  }

  @Test
  void oneCauseIsOneWhateverIsFree() {
    assertThat(Chart.of(new AirDrag(0.4)).sameCause(Chart.of(new AirDrag(0)))).isTrue();
    assertThat(SLOPE.sameCause(Chart.of(new AirDrag(0)))).isFalse();
  }
}
