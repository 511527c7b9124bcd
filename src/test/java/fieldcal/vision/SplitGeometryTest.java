package fieldcal.vision;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Sources that put one camera's calibration into each message, as grSim does. */
class SplitGeometryTest {
  private static final Epoch EPOCH = new Epoch(1_763_000_000_000_000_000L);

  private final VisionEncoder encoder = new VisionEncoder(EPOCH);
  private final VisionDecoder decoder = new VisionDecoder(EPOCH);

  private static CameraCalibration camera(int id, double x) {
    return new CameraCalibration(id, 500, 0, 0, 0.1, 1, 0, 0, 0, -x, 0, 4, x, 0, 4, 0, 0);
  }

  private static FieldGeometry field(double length, CameraCalibration... cameras) {
    return FieldGeometry.of(length, 9, 1.8, 0.18, 0.3, List.of(cameras))
        .withModels(Optional.of(FlatModel.typical()), Optional.empty());
  }

  private FieldGeometry send(FieldGeometry message) {
    return decoder.decode(encoder.encode(VisionPacket.of(message))).geometry().orElseThrow();
  }

  private static List<Integer> ids(FieldGeometry geometry) {
    return geometry.cameras().stream().map(CameraCalibration::id).toList();
  }

  @Test
  void partsAreOneGeometryThatDoesNotChange() {
    for (int id = 3; id >= 0; id--) {
      send(field(12, camera(id, id)));
    }
    FieldGeometry whole = send(field(12, camera(2, 2)));
    assertThat(ids(whole)).containsExactly(0, 1, 2, 3);
    assertThat(whole.flat()).isPresent();
    for (int id = 0; id < 4; id++) {
      assertThat(send(field(12, camera(id, id)))).isSameAs(whole);
    }
  }

  @Test
  void aPartReplacesWhatWasKnownOfItsCamera() {
    FieldGeometry before = send(field(12, camera(0, 0), camera(1, 1)));
    FieldGeometry after = send(field(12, camera(1, 2)));
    assertThat(ids(after)).containsExactly(0, 1);
    assertThat(after.camera(1).orElseThrow().derivedWorldX()).isEqualTo(2);
    assertThat(after.completes(before)).isFalse();
  }

  @Test
  void aWholeOneAndAnotherFieldReplaceAll() {
    send(field(12, camera(0, 0), camera(1, 1), camera(2, 2)));
    assertThat(ids(send(field(12, camera(0, 0), camera(1, 1))))).containsExactly(0, 1);
    assertThat(ids(send(field(9, camera(3, 3))))).containsExactly(3);
  }

  @Test
  void moreCamerasCompleteAGeometry() {
    FieldGeometry one = field(12, camera(0, 0));
    FieldGeometry two = field(12, camera(0, 0), camera(1, 1));
    assertThat(two.completes(one)).isTrue();
    assertThat(one.completes(two)).isFalse();
    assertThat(field(9, camera(0, 0)).completes(one)).isFalse();
    assertThat(two.withModels(Optional.empty(), Optional.empty()).completes(one)).isFalse();
  }
}
