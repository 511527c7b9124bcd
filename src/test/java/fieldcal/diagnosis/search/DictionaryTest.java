package fieldcal.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetSeam;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.Wind;
import fieldcal.effect.motion.WornRegion;
import fieldcal.simulation.ScenarioKind;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** What is proposed beside what a model has. */
class DictionaryTest {
  private static final FittedField FLATS = FittedField.flats();
  private static final EffectModel SIMPLE = FLATS.simple().model();

  private static Component all(Effect effect) {
    return Component.of(effect, effect.magnitudes());
  }

  private static Dictionary catalogue(Arena arena) {
    return new Dictionary(EffectCatalogue.all(), arena);
  }

  private static Set<String> ids(List<Proposal> proposals) {
    return proposals.stream()
        .flatMap(p -> p.components().stream())
        .map(c -> c.template().id())
        .collect(Collectors.toSet());
  }

  @Test
  void whatNeedsACompanionWaitsForIt() {
    Dictionary dictionary = new Dictionary(List.of(new AirDrag(0), new Wind(0, 0)), FLATS.arena());
    assertThat(ids(dictionary.everywhere(SIMPLE))).containsExactly("air_drag");
    EffectModel withDrag = SIMPLE.with(List.of(all(new AirDrag(0.4))));
    assertThat(ids(dictionary.everywhere(withDrag))).containsExactly("wind");
  }

  @Test
  void onlyWhatTheRecordingCanShowIsProposed() {
    Dictionary ofFlats = catalogue(FLATS.arena());
    assertThat(ids(ofFlats.everywhere(SIMPLE)))
        .contains("air_drag", "slip_dependent_friction")
        .doesNotContain("speed_dependent_restitution", "robot_kick_bias");
    assertThat(ofFlats.laws(SIMPLE)).isEmpty();
    FittedField chips = FittedField.chips();
    Dictionary ofChips = catalogue(chips.arena());
    assertThat(ids(ofChips.everywhere(chips.simple().model())))
        .contains("speed_dependent_restitution")
        .doesNotContain("slip_dependent_friction");
    assertThat(ofChips.laws(chips.simple().model()).stream().map(Effect::id))
        .containsExactly("contact_impacts");
  }

  @Test
  void whatTheModelHasIsNotProposedAgainUnlessItIsMore() {
    Dictionary dictionary =
        new Dictionary(
            List.of(new AirDrag(0), new KickSpin(0), new CameraPoseError(0, 0, 0, 0, 0, 0)),
            FLATS.arena());
    EffectModel model =
        SIMPLE.with(
            List.of(
                all(new AirDrag(0.4)),
                all(new KickSpin(0.1)),
                Component.of(new CameraPoseError(0, 0, 5, 0, 0, 0), List.of("height_mm"))));
    List<Proposal> left = dictionary.everywhere(model);
    assertThat(ids(left)).doesNotContain("air_drag");
    assertThat(left.stream().flatMap(p -> p.components().stream()))
        .filteredOn(c -> c.template().id().equals("kick_spin"))
        .isNotEmpty()
        .allMatch(Component::isPerKick);
    assertThat(left.stream().flatMap(p -> p.components().stream()))
        .filteredOn(c -> c.camera().equals(OptionalInt.of(0)))
        .isNotEmpty()
        .allMatch(c -> c.magnitudeCount() > 1);
  }

  @Test
  void otherFormsAreProposedOnlyWhenAskedFor() {
    Dictionary dictionary =
        new Dictionary(
            List.of(new AirDrag(0)), List.of(), LearnedLibrary.stopping(), FLATS.arena());
    assertThat(ids(dictionary.everywhere(SIMPLE))).containsExactly("air_drag");
    assertThat(ids(dictionary.withForms().orElseThrow().everywhere(SIMPLE)))
        .containsExactlyInAnyOrder("air_drag", "learned");
    assertThat(new Dictionary(List.of(new AirDrag(0)), FLATS.arena()).withForms()).isEmpty();
  }

  @Test
  void moreIsAValueForEachKickOrAnotherMagnitude() {
    Effect pose = new CameraPoseError(0, 0, 0, 0, 0, 0);
    Component height = Component.of(pose, List.of("height_mm"));
    Component each = Component.perKick(new KickSpin(0));
    Component same = all(new KickSpin(0));
    assertThat(Dictionary.isMore(all(pose), height)).isTrue();
    assertThat(Dictionary.isMore(height, all(pose))).isFalse();
    assertThat(Dictionary.isMore(each, same)).isTrue();
    assertThat(Dictionary.isMore(same, each)).isFalse();
    assertThat(Dictionary.isMore(same, same)).isFalse();
  }

  @Test
  void placesComeInFamiliesOfTheirOwn() {
    Dictionary dictionary =
        new Dictionary(List.of(new AirDrag(0), new WornRegion(0, 0, 0, 0, 0)), FLATS.arena());
    assertThat(ids(dictionary.everywhere(SIMPLE))).containsExactly("air_drag");
    List<List<Place>> families = dictionary.placed(SIMPLE);
    assertThat(families).hasSize(1);
    assertThat(ids(families.get(0).stream().map(Place::proposal).toList()))
        .containsExactly("worn_region");
    assertThat(families.get(0)).hasSizeGreaterThan(10);
  }

  @Test
  void moreOfWhatHasAPlaceIsProposedWhereItIs() {
    Dictionary dictionary = new Dictionary(List.of(new CarpetSeam(0, 0, 0, 0)), FLATS.arena());
    Component seam = Component.of(new CarpetSeam(0.1, 0, 0.3, 1.2), List.of("loss"));
    List<List<Place>> families = dictionary.placed(SIMPLE.with(List.of(seam)));
    assertThat(families).hasSize(1);
    assertThat(families.get(0)).hasSize(1);
    Component more = families.get(0).get(0).component();
    assertThat(more.magnitudeCount()).isEqualTo(2);
    assertThat(more.template().value("normal")).isEqualTo(0.3);
    assertThat(more.template().value("distance")).isEqualTo(1.2);
  }

  @Test
  void offsetsOfManyCamerasAreAGroupToo() {
    Arena two = FLATS.arena();
    assertThat(catalogue(two).everywhere(SIMPLE)).noneMatch(Proposal::group);
    FittedField four =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 6)
                .withCameras(FittedField.SOUND.cameras().withCount(4)));
    assertThat(catalogue(four.arena()).everywhere(four.simple().model()))
        .anySatisfy(
            p -> {
              assertThat(p.group()).isTrue();
              assertThat(p.components()).hasSize(4);
              assertThat(p.components().get(0).template().id()).isEqualTo("camera_offset");
            });
  }
}
