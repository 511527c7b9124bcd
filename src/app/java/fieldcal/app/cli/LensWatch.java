package fieldcal.app.cli;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.LensCounts;
import fieldcal.vision.BallDetection;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Finds cameras whose published lens cannot be the one they look through, from all balls that they report. {@code calibrate} looks at the kicks alone, which are not searched for here.
 */
final class LensWatch {
  private final Map<Integer, CameraCalibration> calibrations = new HashMap<>();
  private final Map<Integer, CameraView> views = new HashMap<>();
  private final LensCounts counts = new LensCounts();

  /** The cameras from now on; one that was calibrated again is another one. */
  void geometry(FieldGeometry geometry) {
    for (CameraCalibration calibration : geometry.cameras()) {
      if (!calibration.equals(calibrations.put(calibration.id(), calibration))) {
        views.put(calibration.id(), CameraView.of(calibration.id(), camera(calibration)));
        counts.forget(calibration.id());
      }
    }
  }

  private static Optional<Camera> camera(CameraCalibration calibration) {
    try {
      return Optional.of(Camera.of(calibration));
    } catch (IllegalArgumentException unusable) {
      // It has no lens to be judged.
      return Optional.empty();
    }
  }

  void accept(VisionFrame frame) {
    CameraView view = views.get(frame.cameraId());
    if (view != null) {
      for (BallDetection ball : frame.balls()) {
        counts.add(view, ball.x(), ball.y());
      }
    }
  }

  Map<Integer, Double> unusable() {
    return counts.unusable();
  }
}
