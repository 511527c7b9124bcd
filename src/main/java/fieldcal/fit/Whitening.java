package fieldcal.fit;

import fieldcal.camera.Camera;

/**
 * Turns residuals in the ground plane into ones with unit variance per component, {@code (w11·rx, w21·rx + w22·ry)}.
 *
 * <p>A camera's noise arises in its pixels: towards the edge of the image a pixel covers more ground, and more along the line of sight than across it.
 * Where the camera's pixels are unknown, or its lens does not see the place, the noise is taken to be that straight below it. Noise of the time stamp adds to it along the ball's velocity. A working object; not thread-safe.
 */
public final class Whitening {
  private final double[] jacobian = new double[4];
  private double w11;
  private double w21;
  private double w22;
  private boolean seen;

  /** Starts empty: the factors are 0 until a place was looked up. */
  public Whitening() {}

  /**
   * Looks up a place in a camera's view, for a ball at rest or time stamps without noise.
   *
   * @param view the camera with its noise
   * @param x reported place, m
   * @param y reported place, m
   */
  public void at(CameraView view, double x, double y) {
    at(view, x, y, 0, 0);
  }

  /**
   * Looks up a place in a camera's view.
   *
   * @param view the camera with its noise
   * @param x reported place, m
   * @param y reported place, m
   * @param jitterX noise of the time stamp times the ball's velocity, m
   * @param jitterY the same along y, m
   */
  public void at(CameraView view, double x, double y, double jitterX, double jitterY) {
    double variance = view.noise() * view.noise();
    double c11 = variance;
    double c21 = 0;
    double c22 = variance;
    seen = true;
    Camera camera = view.camera().orElse(null);
    if (camera != null && camera.hasPixels()) {
      camera.groundPerPixel(camera.positionX(), camera.positionY(), jacobian);
      double nadir = Math.abs(jacobian[0] * jacobian[3] - jacobian[1] * jacobian[2]);
      camera.groundPerPixel(x, y, jacobian);
      double area = Math.abs(jacobian[0] * jacobian[3] - jacobian[1] * jacobian[2]);
      seen = nadir > 0 && area >= LensCheck.LEAST_GROUND * nadir && area < Double.POSITIVE_INFINITY;
      if (seen) {
        double perPixel = variance / nadir;
        c11 = perPixel * (jacobian[0] * jacobian[0] + jacobian[1] * jacobian[1]);
        c21 = perPixel * (jacobian[0] * jacobian[2] + jacobian[1] * jacobian[3]);
        c22 = perPixel * (jacobian[2] * jacobian[2] + jacobian[3] * jacobian[3]);
      }
    }
    c11 += jitterX * jitterX;
    c21 += jitterX * jitterY;
    c22 += jitterY * jitterY;
    // Inverse of the Cholesky factor L of the covariance: L = (l11 0; l21 l22).
    double l11 = Math.sqrt(c11);
    double l21 = c21 / l11;
    double l22 = Math.sqrt(Math.max(c22 - l21 * l21, 1e-12 * variance));
    w11 = 1 / l11;
    w21 = -l21 / (l11 * l22);
    w22 = 1 / l22;
  }

  /** Whether the camera's lens, where it is known, sees the place that was looked up. */
  boolean isSeen() {
    return seen;
  }

  /**
   * Factor of the residual along x in the first component, of the place that was looked up last.
   *
   * @return 1/m, positive: 1 over the standard deviation along x
   */
  public double w11() {
    return w11;
  }

  /**
   * Factor of the residual along x in the second component, of the place that was looked up last.
   *
   * @return 1/m, of either sign; 0 where the noise is the same in all directions
   */
  public double w21() {
    return w21;
  }

  /**
   * Factor of the residual along y in the second component, of the place that was looked up last.
   *
   * @return 1/m, positive
   */
  public double w22() {
    return w22;
  }
}
