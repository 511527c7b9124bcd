package fieldcal.simulation.imaging;

import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.physics.Region;
import java.util.Objects;

/**
 * One camera as it was found: how vision projects with it, how good it is, and what goes wrong with it.
 *
 * @param vision calibration that vision projects with; complete, and with an image size
 * @param announced calibration in the geometry messages; another one where a source announces placeholders
 * @param reportsPixels whether detections contain their place in the image
 * @param view where it reports balls and robots, on the ground; {@link Region#NONE} = all of its image
 * @param ballNoise standard deviation of a ball's reported position straight below the camera, m
 * @param noiseGrowth whether the noise grows away from the point below the camera
 * @param robotNoise standard deviation of a robot's reported position, m
 * @param robotAngleNoise standard deviation of a robot's reported orientation, rad
 * @param rate frames per second, 1/s
 * @param phase session time of an exposure, s
 * @param latency from exposure to the detections leaving vision, s
 * @param latencySpread standard deviation of what is added to that, s
 * @param nuisance what goes wrong with it
 * @param errors what is wrong with it
 */
public record InstalledCamera(
    CameraCalibration vision,
    CameraCalibration announced,
    boolean reportsPixels,
    Region view,
    double ballNoise,
    NoiseGrowth noiseGrowth,
    double robotNoise,
    double robotAngleNoise,
    double rate,
    double phase,
    double latency,
    double latencySpread,
    Nuisance nuisance,
    CameraErrors errors) {

  /** How the noise of positions depends on the place. */
  public enum NoiseGrowth {
    /** The noise is the same everywhere in the image, as that of a sensor; on the ground it grows away from the point below the camera. */
    IMAGE,
    /** The noise is the same everywhere on the ground, as simulators add it. */
    NONE
  }

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is out of range or NaN, or the two calibrations are of different cameras
   */
  public InstalledCamera {
    Objects.requireNonNull(view, "view");
    Objects.requireNonNull(noiseGrowth, "noiseGrowth");
    Objects.requireNonNull(nuisance, "nuisance");
    Objects.requireNonNull(errors, "errors");
    if (vision.id() != announced.id()) {
      throw new IllegalArgumentException(
          "calibrations of camera " + vision.id() + " and camera " + announced.id());
    }
    range("image width", vision.imageWidth(), 1, 100_000);
    range("image height", vision.imageHeight(), 1, 100_000);
    range("ball noise", ballNoise, 0, 0.1);
    range("robot noise", robotNoise, 0, 0.1);
    range("robot angle noise", robotAngleNoise, 0, 1);
    range("rate", rate, 5, 1000);
    range("phase", phase, -1, 1);
    range("latency", latency, 0, 10);
    range("latency spread", latencySpread, 0, 1);
  }

  private static void range(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          name + " must lie in [" + min + ", " + max + "], but is " + value);
    }
  }

  /**
   * Its id.
   *
   * @return 0 or more
   */
  public int id() {
    return vision.id();
  }

  /**
   * The same camera with other errors.
   *
   * @param newErrors what is wrong with it
   * @return the changed camera
   */
  public InstalledCamera withErrors(CameraErrors newErrors) {
    return with(latency, newErrors);
  }

  /**
   * The same camera with another delay.
   *
   * @param newLatency from exposure to the detections leaving vision, s
   * @return the changed camera
   */
  public InstalledCamera withLatency(double newLatency) {
    return with(newLatency, errors);
  }

  private InstalledCamera with(double newLatency, CameraErrors newErrors) {
    return new InstalledCamera(
        vision,
        announced,
        reportsPixels,
        view,
        ballNoise,
        noiseGrowth,
        robotNoise,
        robotAngleNoise,
        rate,
        phase,
        newLatency,
        latencySpread,
        nuisance,
        newErrors);
  }
}
