package fieldcal.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.motion.AirDrag;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What would explain the same. */
class AlternativesTest {
  /** Odds of e³ = 20 : 1. */
  private static final double TOLERANCE = 6;

  private final FittedField field =
      FittedField.flats("air_drag:cd=0.45", "camera_offset:x_mm=10,y_mm=-4,camera=1");
  private final Alternatives alternatives =
      new Alternatives(field.fitter(), new Dictionary(EffectCatalogue.all(), field.arena()));

  private FittedModel withDragAnd(int camera) {
    Effect drag = new AirDrag(0.45);
    Effect offset = new CameraOffset(0, 0, camera);
    return field
        .fitter()
        .fit(
            field
                .simple()
                .model()
                .with(
                    List.of(
                        Component.of(drag, drag.magnitudes()),
                        Component.of(offset, offset.magnitudes()))),
            field.simple(),
            Weighing.ALIKE,
            FittedField.SOLVER);
  }

  @Test
  void ofTwoCamerasEitherMayBeTheOneThatIsOff() {
    Alternatives offsets =
        new Alternatives(
            field.fitter(),
            new Dictionary(List.of(new AirDrag(0), new CameraOffset(0, 0, 0)), field.arena()));
    assertThat(offsets.equalTo(withDragAnd(1), 1, TOLERANCE))
        .containsExactly("camera_offset of camera 0");
    assertThat(offsets.equalTo(withDragAnd(0), 1, TOLERANCE))
        .containsExactly("camera_offset of camera 1");
  }

  /** Poses of cameras, which may be wrong by an offset among others, explain a little more each. */
  @Test
  void moreGeneralEffectsLeaveRoomForAnEqual() {
    assertThat(alternatives.equalTo(withDragAnd(1), 1, TOLERANCE))
        .contains("camera_offset of camera 0");
  }

  @Test
  void whatOnlyItExplainsHasNoEqual() {
    assertThat(alternatives.equalTo(withDragAnd(1), 0, TOLERANCE)).isEmpty();
  }

  @Test
  void scoresBesideAModelAreBestFirst() {
    List<Alternatives.Scored> scores = alternatives.scores(field.simple());
    assertThat(scores.get(0).gain()).isGreaterThan(100);
    assertThat(scores).isSortedAccordingTo((a, b) -> Double.compare(b.gain(), a.gain()));
    List<Alternatives.Scored> left = alternatives.scores(withDragAnd(1));
    assertThat(left.get(0).gain()).isLessThan(0.1 * scores.get(0).gain());
  }
}
