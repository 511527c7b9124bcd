package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class LiveStateDocumentTest {
  private static BallSamples random(long seed, int from, int count) {
    Random random = new Random(seed);
    Map<BallParameter, List<BallSample>> all = new EnumMap<>(BallParameter.class);
    for (BallParameter parameter : BallParameter.values()) {
      List<BallSample> samples = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        samples.add(
            new BallSample(
                1.7e9 + from + i + random.nextDouble(),
                -random.nextDouble(),
                0.001 + random.nextDouble(),
                random.nextBoolean(),
                parameter.speedSensitive() ? 3 * random.nextDouble() : Double.NaN));
      }
      all.put(parameter, samples);
    }
    return new BallSamples(all);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void roundTrip(long seed) {
    BallSamples samples = random(seed, 0, 31);
    assertThat(LiveStateDocument.read(LiveStateDocument.of(samples))).isEqualTo(samples);
    assertThat(LiveStateDocument.read(LiveStateDocument.of(BallSamples.NONE)))
        .isEqualTo(BallSamples.NONE);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void poolingIsExactInAnyOrderAndCountsEachMatchOnce(long seed) {
    BallSamples a = random(seed, 0, 20);
    BallSamples b = random(seed + 100, 10, 25);
    BallSamples c = random(seed + 200, 30, 15);
    BallSamples all = a.merged(b).merged(c);
    assertThat(c.merged(a).merged(b)).isEqualTo(all);
    assertThat(a.merged(b.merged(c))).isEqualTo(all);
    assertThat(all.merged(b)).isEqualTo(all);
    assertThat(all.size()).isEqualTo(6 * 60);
  }

  static List<Object[]> broken() {
    Map<String, Object> noSamples = new HashMap<>(Map.of("schema", LiveStateDocument.SCHEMA));
    return List.of(
        new Object[] {Map.of(), "schema: must be"},
        new Object[] {Map.of("schema", "fieldcal.calibration/1"), "fieldcal.calibration/1"},
        new Object[] {noSamples, "samples: must be an object"},
        new Object[] {with("acc_rol", List.of()), "samples.acc_rol: is not a parameter"},
        new Object[] {with("acc_roll", "none"), "samples.acc_roll: must be a list"},
        new Object[] {with("acc_roll", List.of(3)), "samples.acc_roll[0]: must be an object"},
        new Object[] {
          with("acc_roll", List.of(Map.of("t", 1, "value", -0.3))),
          "standard_error must be a number"
        },
        new Object[] {
          with("acc_roll", List.of(Map.of("t", 1, "value", "x", "standard_error", 1))),
          "samples.acc_roll[0]: value must be a number, but is x"
        },
        new Object[] {
          with(
              "k_switch",
              List.of(Map.of("t", 1, "value", 1, "standard_error", 1, "possibly_spinning", 3))),
          "samples.k_switch[0]: possibly_spinning must be true or false, but is 3"
        },
        new Object[] {
          with("acc_roll", List.of(Map.of("t", 1, "value", 1, "standard_error", -1))),
          "standard error must be positive"
        },
        new Object[] {
          with("acc_roll", List.of(Map.of("t", Double.NaN, "value", 1, "standard_error", 1))),
          "must be finite"
        });
  }

  private static Map<String, Object> with(String name, Object samples) {
    return Map.of("schema", LiveStateDocument.SCHEMA, "samples", Map.of(name, samples));
  }

  @ParameterizedTest
  @MethodSource("broken")
  void aBrokenStateIsRefusedWithItsPlace(Map<?, ?> document, String message) {
    assertThatThrownBy(() -> LiveStateDocument.read(document))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }

  @Test
  void fieldsAreAsDocumented() {
    BallSamples one =
        new BallSamples(
            Map.of(BallParameter.ACC_ROLL, List.of(new BallSample(5, -0.3, 0.01, true))));
    assertThat(LiveStateDocument.of(one).get("samples").toString())
        .contains("acc_roll=[{t=5.0, value=-0.3, standard_error=0.01, possibly_spinning=true}]");
  }
}
