package fieldcal.fit;

import fieldcal.camera.Camera;
import java.util.Optional;

/**
 * What the fit knows of one camera: where it hangs, what offset it adds to every report, and how noisy it is. Immutable.
 *
 * @param id camera id
 * @param camera its geometry; absent when none was published, then a ball is taken to be reported where it is
 * @param offsetX what the camera adds to every reported x, relative to the mean of all cameras, m
 * @param offsetY what the camera adds to every reported y, m
 * @param noise standard deviation of a reported position per axis straight below the camera, m, positive
 */
public record CameraView(
    int id, Optional<Camera> camera, double offsetX, double offsetY, double noise) {

  /**
   * Noise of a ball on a good SSL camera at rest is 0.7 mm, of simulators 2 mm; 1.5 mm is between them and only a start for the
   * estimate from the residuals.
   */
  public static final double DEFAULT_NOISE = 0.0015;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when an offset is not finite, or the noise is not positive and finite
   */
  public CameraView {
    if (!Double.isFinite(offsetX) || !Double.isFinite(offsetY)) {
      throw new IllegalArgumentException(
          "offset of camera " + id + " is not finite: " + offsetX + ", " + offsetY);
    }
    if (!(noise > 0) || Double.isInfinite(noise)) {
      throw new IllegalArgumentException("noise of camera " + id + " must be positive: " + noise);
    }
  }

  /**
   * A camera without offset and with the default noise.
   *
   * @param id camera id
   * @param camera its geometry, if known
   * @return the view
   */
  public static CameraView of(int id, Optional<Camera> camera) {
    return new CameraView(id, camera, 0, 0, DEFAULT_NOISE);
  }

  /**
   * The same camera with another offset.
   *
   * @param x what it adds to x, m
   * @param y what it adds to y, m
   * @return the changed copy
   */
  public CameraView withOffset(double x, double y) {
    return new CameraView(id, camera, x, y, noise);
  }

  /**
   * The same camera with another noise.
   *
   * @param sigma standard deviation per axis, m; raised to {@link CameraNoise#FLOOR} when it is below
   * @return the changed copy
   */
  public CameraView withNoise(double sigma) {
    return new CameraView(id, camera, offsetX, offsetY, Math.max(sigma, CameraNoise.FLOOR));
  }
}
