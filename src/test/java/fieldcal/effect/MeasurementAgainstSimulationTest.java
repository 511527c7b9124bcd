package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.CameraPositionError;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.measurement.ClockSkew;
import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.measurement.RollingShutter;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Reported positions with effects against the simulation's cameras, which err in their own way. */
class MeasurementAgainstSimulationTest {
  /** Required is 0.2 mm; 32-bit calibrations and pixels leave some hundredths. */
  private static final double LIMIT = 5e-5;

  private static final SimulationSettings FLAT =
      SimulationSettings.DEFAULT
          .withScenario(ScenarioSettings.of(ScenarioKind.FLAT, 2).withReception(0))
          .withCameras(CameraSettings.DEFAULT.withNoise(0, 0))
          .withNuisance(Nuisance.NONE)
          .withSeed(11);

  private static final SimulationSettings CHIP =
      FLAT.withScenario(ScenarioSettings.of(ScenarioKind.CHIP, 2).withReception(0));

  static Stream<Arguments> errors() {
    return Stream.of(
        Arguments.of("camera_offset:x_mm=0,camera=0", List.of(new CameraOffset(0, 0, 0))),
        Arguments.of(
            "camera_offset:x_mm=21,y_mm=-6,camera=1", List.of(new CameraOffset(21, -6, 1))),
        Arguments.of("camera_offset:y_mm=80,camera=3", List.of(new CameraOffset(0, 80, 3))),
        Arguments.of("camera_time_offset:ms=4,camera=1", List.of(new CameraTimeOffset(4, 1))),
        Arguments.of("camera_time_offset:ms=-20,camera=2", List.of(new CameraTimeOffset(-20, 2))),
        Arguments.of("clock_skew:ppm=500,camera=2", List.of(new ClockSkew(500, 2))),
        Arguments.of("clock_skew:ppm=-10000,camera=0", List.of(new ClockSkew(-10_000, 0))),
        Arguments.of(
            "camera_pose_error:height_mm=50,camera=1",
            List.of(new CameraPoseError(0, 0, 50, 0, 0, 1))),
        Arguments.of(
            "camera_pose_error:tilt_mrad=3,axis=0.7,camera=2",
            List.of(new CameraPoseError(3, 0.7, 0, 0, 0, 2))),
        Arguments.of(
            "camera_pose_error:tilt_mrad=-20,axis=2,height_mm=-80,shift_x_mm=30,shift_y_mm=-70,camera=0",
            List.of(new CameraPoseError(-20, 2, -80, 30, -70, 0))),
        Arguments.of(
            "camera_position_error:x_mm=90,y_mm=-40,height_mm=-120,camera=1",
            List.of(new CameraPositionError(90, -40, -120, 1))),
        Arguments.of(
            "camera_position_error:x_mm=-60,height_mm=80,camera=2"
                + " camera_pose_error:height_mm=50,shift_x_mm=12,camera=2",
            List.of(
                new CameraPositionError(-60, 0, 80, 2), new CameraPoseError(0, 0, 50, 12, 0, 2))),
        Arguments.of(
            "lens_distortion_error:delta=0.01,camera=1", List.of(new LensDistortionError(0.01, 1))),
        Arguments.of(
            "lens_distortion_error:delta=-0.05,camera=3",
            List.of(new LensDistortionError(-0.05, 3))),
        Arguments.of("ball_height_error:mm=8.5", List.of(new BallHeightError(8.5))),
        Arguments.of("ball_height_error:mm=-10", List.of(new BallHeightError(-10))),
        Arguments.of("rolling_shutter:ms=5", List.of(new RollingShutter(5))),
        Arguments.of("rolling_shutter:ms=15", List.of(new RollingShutter(15))),
        Arguments.of("rolling_shutter:ms=-15", List.of(new RollingShutter(-15))),
        Arguments.of(
            "camera_pose_error:tilt_mrad=10,axis=1,height_mm=40,camera=1"
                + " lens_distortion_error:delta=0.02,camera=1 ball_height_error:mm=8.5"
                + " camera_time_offset:ms=5,camera=1",
            List.of(
                new LensDistortionError(0.02, 1),
                new CameraPoseError(10, 1, 40, 0, 0, 1),
                new BallHeightError(8.5),
                new CameraTimeOffset(5, 1))));
  }

  @ParameterizedTest
  @MethodSource("errors")
  void flatKicksAgree(String setting, List<MeasurementEffect> effects) {
    compare(Simulation.record(FLAT.withEffects(setting.split(" "))), effects);
  }

  @ParameterizedTest
  @MethodSource("errors")
  void chipsAgree(String setting, List<MeasurementEffect> effects) {
    compare(Simulation.record(CHIP.withEffects(setting.split(" "))), effects);
  }

  private static void compare(SimulatedRecording recording, List<MeasurementEffect> effects) {
    List<CameraCalibration> published = recording.geometry().cameras();
    MeasurementEffects errors =
        MeasurementEffects.of(
            published.stream()
                .map(c -> ObservedCamera.of(c, Camera.of(c), published.size()))
                .toList(),
            effects);
    double[] ball = new double[3];
    double[] ground = new double[2];
    int compared = 0;
    for (KickTruth kick : recording.truth().commandedKicks()) {
      BallTrajectory path = path(kick);
      double end = Math.min(kick.time() + kick.duration(), path.restTime()) - 1e-3;
      for (VisionFrame frame : recording.frames()) {
        for (BallDetection seen : frame.balls()) {
          int camera = frame.cameraId();
          double t = errors.ballTime(camera, frame.captureTime(), seen.pixelY(), Double.NaN);
          if (t > kick.time() + 1e-3 && t < end) {
            path.positionAt(t, ball);
            errors.report(camera, ball, ground);
            assertThat(Math.hypot(ground[0] - seen.x(), ground[1] - seen.y())).isLessThan(LIMIT);
            compared++;
          }
        }
      }
    }
    assertThat(compared).isGreaterThan(300);
  }

  private static BallTrajectory path(KickTruth kick) {
    FlatModel flat = new FlatModel(-3.1, -0.28, 0.65);
    ChipModel chip = new ChipModel(0.75, 0.95, 0.52, -0.28);
    double x = kick.position().x();
    double y = kick.position().y();
    double vx = kick.velocity().x();
    double vy = kick.velocity().y();
    double vz = kick.velocity().z();
    return vz > 0
        ? ChipTrajectory.fromKick(chip, kick.time(), x, y, vx, vy, vz)
        : FlatTrajectory.fromKick(flat, kick.time(), x, y, vx, vy);
  }
}
