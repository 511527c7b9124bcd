package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.motion.KickSpin;
import fieldcal.vision.Epoch;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every effect goes into the document and comes back the same. */
class ExtendedModelDocumentTest {
  private static final Epoch EPOCH = new Epoch(1_763_712_345_000_000_000L);

  /** Every effect of the catalogue with numbers that differ from each other. */
  static List<Effect> effects() {
    List<Effect> all = new ArrayList<>();
    for (Effect effect : EffectCatalogue.all()) {
      double[] values = new double[effect.parameters().size()];
      for (int i = 0; i < values.length; i++) {
        Parameter p = effect.parameters().get(i);
        boolean whole = !p.estimated() && p.unit().isEmpty();
        values[i] = whole ? 1 : p.min() + (0.55 + 0.05 * i) * (p.max() - p.min());
      }
      all.add(effect.withParameters(values));
    }
    return all;
  }

  @ParameterizedTest
  @MethodSource("effects")
  void anEffectComesBack(Effect effect) {
    Map<String, Object> fields = EffectFields.of(effect);
    assertThat(EffectFields.read(effect.id(), fields)).isEqualTo(effect);
    // The document's names are those of the contract: no bound of a region on its own.
    assertThat(fields.keySet()).noneMatch(name -> name.startsWith("region_"));
  }

  @Test
  void anErrorOfAllCamerasNamesNone() {
    Effect all = new LensDistortionError(0.01, LensDistortionError.ALL_CAMERAS);
    assertThat(EffectFields.of(all)).containsOnlyKeys("delta");
    assertThat(EffectFields.read(all.id(), Map.of("delta", 0.01))).isEqualTo(all);
    assertThatThrownBy(() -> EffectFields.read(all.id(), Map.of("delta", 0.01, "camera", -1)))
        .hasMessageStartingWith("camera: ");
    assertThatThrownBy(() -> EffectFields.read("clock_skew", Map.of("ppm", 100)))
        .hasMessageStartingWith("camera: ");
  }

  /** Files of before chips had a spin of their own name none. */
  @Test
  void whatWasNotToldApartIsLeftOut() {
    Effect all = new KickSpin(-0.2);
    assertThat(EffectFields.of(all)).containsOnlyKeys("fraction");
    assertThat(EffectFields.read(all.id(), Map.of("fraction", -0.2))).isEqualTo(all);
    Effect apart = new KickSpin(-0.1, -0.3, true);
    assertThat(EffectFields.of(apart)).containsOnlyKeys("fraction", "chips");
    assertThat(EffectFields.read(apart.id(), EffectFields.of(apart))).isEqualTo(apart);
    assertThatThrownBy(() -> EffectFields.read("kick_spin", Map.of("fraction", 0.1, "chips", 9)))
        .hasMessageStartingWith("chips: ");
  }

  @Test
  void aModelComesBack() {
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(FlatModel.typical()), Optional.of(ChipModel.typical()), effects(), 12.25);
    Map<String, Object> document = ExtendedModelDocument.of(model, EPOCH);
    assertThat(ExtendedModelDocument.read(document, EPOCH)).isEqualTo(model);
    assertThat(ExtendedModelDocument.read(document).sessionStart())
        .isEqualTo(1_763_712_357.25, within(1e-6));
  }

  @Test
  void theLowestHopComesBackWhereItIsNotTheLeagues() {
    ChipModel low = ChipModel.typical().withLowestHop(5e-4);
    ExtendedModel model = new ExtendedModel(Optional.empty(), Optional.of(low), List.of(), 0);
    Map<String, Object> document = ExtendedModelDocument.of(model, EPOCH);
    assertThat(ExtendedModelDocument.read(document, EPOCH)).isEqualTo(model);
    @SuppressWarnings("unchecked")
    Map<String, Object> chip = (Map<String, Object>) document.get("chip");
    assertThat(chip).containsEntry("lowest_hop_mm", 0.5);
    chip.put("lowest_hop_mm", 0.0);
    assertThatThrownBy(() -> ExtendedModelDocument.read(document, EPOCH))
        .hasMessageStartingWith("chip.lowest_hop_mm: ");
  }

  @Test
  void aModelWithoutChipsComesBack() {
    ExtendedModel model =
        new ExtendedModel(Optional.of(FlatModel.typical()), Optional.empty(), List.of(), 0);
    Map<String, Object> document = ExtendedModelDocument.of(model, EPOCH);
    assertThat(document.get("chip")).isNull();
    assertThat(document.get("needs"))
        .asInstanceOf(org.assertj.core.api.InstanceOfAssertFactories.LIST)
        .isEmpty();
    assertThat(ExtendedModelDocument.read(document, EPOCH)).isEqualTo(model);
  }

  @Test
  void whatIsNeededIsTold() {
    ExtendedModel model =
        new ExtendedModel(Optional.of(FlatModel.typical()), Optional.empty(), effects(), 0);
    assertThat(ExtendedModelDocument.of(model, EPOCH).get("needs").toString())
        .contains("what each robot is commanded when it kicks (robot_kick_bias)")
        .contains(
            "the time since session_start_unix (drift, clock_skew, camera_moved, ball_changed)")
        .contains("geometry of the cameras (camera_pose_error");
  }
}
