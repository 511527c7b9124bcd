package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.vision.Epoch;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Learned terms go into files and come back the same; what is damaged is refused by the name of its field. */
class LearnedFieldsTest {
  private static final Epoch EPOCH = new Epoch(1_763_712_345_000_000_000L);

  static List<LearnedTerm> terms() {
    return LearnedTermTest.terms().stream().map(LearnedTermTest::present).toList();
  }

  @ParameterizedTest
  @MethodSource("terms")
  void aTermComesBack(LearnedTerm term) {
    assertThat(EffectFields.read(term.id(), EffectFields.of(term))).isEqualTo(term);
  }

  @Test
  void aModelComesBack() {
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(FlatModel.typical()),
            Optional.of(ChipModel.typical()),
            new ArrayList<>(terms()),
            12.25);
    Map<String, Object> document = ExtendedModelDocument.of(model, EPOCH);
    assertThat(ExtendedModelDocument.read(document, EPOCH)).isEqualTo(model);
    assertThat(document.get("needs").toString()).contains("the time since session_start_unix");
  }

  @ParameterizedTest
  @CsvSource({
    "acts_on, air, acts_on:",
    "quantity, mass, quantity:",
    "depends_on, speed, depends_on:",
    "camera, 1, camera:",
    "basis, spline, basis:",
    "coefficients, 1, coefficients:",
    "colour, red, colour:"
  })
  void aDamagedFieldIsNamed(String field, String value, String message) {
    Map<String, Object> fields = new HashMap<>(EffectFields.of(terms().get(0)));
    fields.put(field, field.equals("camera") ? (Object) Integer.valueOf(value) : value);
    refuses(fields, message);
    fields.put(field, null);
    if (!field.equals("camera")) {
      refuses(fields, message);
    }
  }

  @ParameterizedTest
  @CsvSource({"type, wave, basis.type:", "knots, 4.5, basis.knots:", "knots, 99, basis.knots:"})
  void aDamagedFieldOfTheBasisIsNamed(String field, String value, String message) {
    Map<String, Object> fields = new HashMap<>(EffectFields.of(terms().get(0)));
    Map<String, Object> basis = new HashMap<>();
    ((Map<?, ?>) fields.get("basis")).forEach((k, v) -> basis.put((String) k, v));
    fields.put("basis", basis);
    basis.put(field, field.equals("type") ? value : Double.valueOf(value));
    refuses(fields, message);
    basis.remove(field);
    refuses(fields, "basis." + field + ":");
  }

  @Test
  void numbersThatCannotBeAreRefused() {
    LearnedTerm term =
        terms().stream().filter(t -> t.family().size() == 5).findFirst().orElseThrow();
    Map<String, Object> fields = new HashMap<>(EffectFields.of(term));
    fields.put("coefficients", List.of(1, 2));
    refuses(fields, "coefficients: must be 5");
    fields.put("coefficients", List.of(0, 0, 0, 0, 1e6));
    refuses(fields, "coefficients: must be within");
    fields.put("coefficients", List.of(0, 0, 0, 0, Double.NaN));
    refuses(fields, "coefficients: must be a number");
    fields.put("coefficients", EffectFields.of(term).get("coefficients"));
    fields.put(
        "basis", Map.of("type", "spline", "range", List.of(2, 1), "knots", 6, "centred", true));
    refuses(fields, "basis.range:");
    fields.put("basis", Map.of("type", "spline", "range", List.of(0, 1), "knots", 6, "centred", 1));
    refuses(fields, "basis.centred:");
  }

  private static void refuses(Map<?, ?> fields, String message) {
    assertThatThrownBy(() -> EffectFields.read("learned", fields))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(message);
  }
}
