package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.truth.CameraTruth;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The words for a tilted camera against one that is tilted in the simulation: they say which way it looks. */
class TiltWordsTest {
  private static final CauseWords WORDS =
      new CauseWords(SampleDiagnosis.explained(8), SampleDiagnosis.observers());

  @ParameterizedTest
  @CsvSource({
    "10, 0, to the right (−y)",
    "-10, 0, to the left (+y)",
    "10, 1.5707963, towards the +x goal",
    "-10, 1.5707963, towards the −x goal",
    "10, 3.1415927, to the left (+y)",
    "10, -0.7853982, towards the −x goal and to the right (−y)",
    "-10, -0.7853982, towards the +x goal and to the left (+y)"
  })
  void theyTellWhichWayTheCameraLooks(double mrad, double axis, String where) {
    CameraTruth camera = tilted(mrad, axis);
    double[] truth = centre(camera.trueCalibration());
    double[] published = centre(camera.publishedCalibration());
    String words = WORDS.of(new CameraPoseError(mrad, axis, 0, 0, 0, 1), Map.of()).what();

    assertThat(words)
        .isEqualTo(
            "Camera 1 looks 10 mrad (0.57°) farther "
                + where
                + ", direction "
                + degrees(truth[0] - published[0], truth[1] - published[1])
                + "°, than its calibration says.");
  }

  private static String degrees(double x, double y) {
    return String.valueOf(Math.round(Math.toDegrees(Math.atan2(y, x)))).replace('-', '−');
  }

  private static CameraTruth tilted(double mrad, double axis) {
    SimulationSettings settings =
        SimulationSettings.DEFAULT
            .withSeed(16)
            .withScenario(ScenarioSettings.of(ScenarioKind.FLAT, 1))
            .withCameras(CameraSettings.DEFAULT.withNoise(0, 0))
            .withNuisance(Nuisance.NONE)
            .withEffects("camera_pose_error:tilt_mrad=" + mrad + ",axis=" + axis + ",camera=1");
    return Simulation.record(settings).truth().cameras().stream()
        .filter(c -> c.trueCalibration().id() == 1)
        .findFirst()
        .orElseThrow();
  }

  /** Where on the carpet the middle of the image is. */
  private static double[] centre(CameraCalibration c) {
    double[] place = new double[2];
    Camera.of(c).pixelToPlane(c.principalPointX(), c.principalPointY(), 0, place);
    return place;
  }
}
