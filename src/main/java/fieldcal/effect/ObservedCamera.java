package fieldcal.effect;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import java.util.Objects;
import java.util.Optional;

/**
 * What measurement effects must know of a camera, as published.
 *
 * @param id camera id
 * @param cameraCount how many cameras look at the field, itself included
 * @param camera its geometry; absent when none was published
 * @param axisX optical axis in the field frame, unit vector; NaN when rotation and lens are not known
 * @param axisY see {@code axisX}
 * @param axisZ see {@code axisX}
 * @param distortion published radial distortion (see {@link CameraCalibration}); NaN when not known
 * @param imageHeight rows of the image; 0 when not known
 */
public record ObservedCamera(
    int id,
    int cameraCount,
    Optional<Camera> camera,
    double axisX,
    double axisY,
    double axisZ,
    double distortion,
    int imageHeight) {

  /**
   * Checks the count. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there is no camera
   */
  public ObservedCamera {
    Objects.requireNonNull(camera, "camera");
    if (cameraCount < 1) {
      throw new IllegalArgumentException("there must be a camera, but count is " + cameraCount);
    }
  }

  /**
   * A camera with published geometry.
   *
   * @param calibration as published
   * @param camera made from it, with the ball plane that vision is believed to use
   * @param cameraCount how many cameras look at the field
   * @return what effects know; without the lens when the camera has no pixels
   */
  public static ObservedCamera of(CameraCalibration calibration, Camera camera, int cameraCount) {
    CameraCalibration c = calibration;
    Optional<Camera> known = Optional.of(camera);
    if (!camera.hasPixels()) {
      double none = Double.NaN;
      return new ObservedCamera(
          c.id(), cameraCount, known, none, none, none, none, c.imageHeight());
    }
    double squared = c.q0() * c.q0() + c.q1() * c.q1() + c.q2() * c.q2() + c.q3() * c.q3();
    // Third row of the rotation from the world to the camera.
    double x = 2 * (c.q0() * c.q2() - c.q3() * c.q1()) / squared;
    double y = 2 * (c.q1() * c.q2() + c.q3() * c.q0()) / squared;
    double z = 1 - 2 * (c.q0() * c.q0() + c.q1() * c.q1()) / squared;
    return new ObservedCamera(c.id(), cameraCount, known, x, y, z, c.distortion(), c.imageHeight());
  }

  /**
   * A camera of which nothing is known: balls are taken to be reported where they are.
   *
   * @param id camera id
   * @param cameraCount how many cameras look at the field
   * @return the camera
   */
  public static ObservedCamera unknown(int id, int cameraCount) {
    double none = Double.NaN;
    return new ObservedCamera(id, cameraCount, Optional.empty(), none, none, none, none, 0);
  }

  /**
   * The same camera under another id.
   *
   * @param newId the id, for recordings in which two cameras share one
   * @return the changed copy
   */
  public ObservedCamera withId(int newId) {
    return new ObservedCamera(
        newId, cameraCount, camera, axisX, axisY, axisZ, distortion, imageHeight);
  }

  /**
   * Whether rotation and lens are known.
   *
   * @return true when they are
   */
  public boolean hasLens() {
    return !Double.isNaN(distortion);
  }
}
