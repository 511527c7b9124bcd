package fieldcal.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class CameraCalibrationTest {

  private static CameraCalibration with(
      double focalLength, double derivedX, double derivedY, int width) {
    return new CameraCalibration(
        3,
        focalLength,
        400,
        300,
        -0.2,
        0,
        0,
        0,
        1,
        0,
        0,
        4,
        derivedX,
        derivedY,
        derivedX,
        width,
        600);
  }

  @Test
  void derivedPositionIsOptionalAsAWhole() {
    assertThat(with(500, Double.NaN, Double.NaN, 0).hasDerivedPosition()).isFalse();
    assertThat(with(500, 0, 1, 0).hasDerivedPosition()).isTrue();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> with(500, 1, Double.NaN, 0))
        .withMessage("camera 3: derived_camera_world_ty is NaN");
  }

  @Test
  void namesTheValueThatIsWrong() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> with(Double.NaN, 0, 1, 0))
        .withMessage("camera 3: focal_length is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> with(500, 0, 1, -1))
        .withMessage("camera 3: image size -1 x 600 is negative");
  }
}
