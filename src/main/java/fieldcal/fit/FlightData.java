package fieldcal.fit;

import fieldcal.camera.Camera;
import fieldcal.kick.Observations;

/**
 * The observations of a kick, ready for the inner loop: offsets taken out, camera positions and whitening factors looked up.
 *
 * <p>Whitening turns a residual in the ground plane into one with unit variance per component. A camera's noise is one of its
 * pixels: towards the edge of the image a pixel covers more ground, and more along the line of sight than across it. Where the
 * camera's pixels are unknown, the noise is taken to be the same everywhere.
 */
final class FlightData {
  final int size;
  final double[] time;
  final double[] x;
  final double[] y;
  final double[] cameraX;
  final double[] cameraY;
  final double[] cameraHeight;
  final double[] w11;
  final double[] w21;
  final double[] w22;

  private FlightData(int size) {
    this.size = size;
    time = new double[size];
    x = new double[size];
    y = new double[size];
    cameraX = new double[size];
    cameraY = new double[size];
    cameraHeight = new double[size];
    w11 = new double[size];
    w21 = new double[size];
    w22 = new double[size];
  }

  static FlightData of(Observations observations, CameraViews views) {
    FlightData data = new FlightData(observations.size());
    double[] jacobian = new double[4];
    for (int i = 0; i < data.size; i++) {
      CameraView view = views.get(observations.camera(i));
      data.time[i] = observations.time(i);
      data.x[i] = observations.x(i) - view.offsetX();
      data.y[i] = observations.y(i) - view.offsetY();
      Camera camera = view.camera().orElse(null);
      // Without geometry: infinitely high, so that a ball is reported where it is.
      data.cameraX[i] = camera == null ? 0 : camera.positionX();
      data.cameraY[i] = camera == null ? 0 : camera.positionY();
      data.cameraHeight[i] = camera == null ? 1e9 : camera.heightAboveBallPlane();
      data.whiten(i, view, camera, jacobian);
    }
    return data;
  }

  private void whiten(int i, CameraView view, Camera camera, double[] jacobian) {
    double c11 = 1;
    double c21 = 0;
    double c22 = 1;
    if (camera != null && camera.hasPixels()) {
      camera.groundPerPixel(camera.positionX(), camera.positionY(), jacobian);
      double nadir = Math.abs(jacobian[0] * jacobian[3] - jacobian[1] * jacobian[2]);
      camera.groundPerPixel(x[i], y[i], jacobian);
      c11 = (jacobian[0] * jacobian[0] + jacobian[1] * jacobian[1]) / nadir;
      c21 = (jacobian[0] * jacobian[2] + jacobian[1] * jacobian[3]) / nadir;
      c22 = (jacobian[2] * jacobian[2] + jacobian[3] * jacobian[3]) / nadir;
    }
    // Inverse of the Cholesky factor L of the covariance: L = (l11 0; l21 l22).
    double l11 = Math.sqrt(c11);
    double l21 = c21 / l11;
    double l22 = Math.sqrt(Math.max(c22 - l21 * l21, 1e-12));
    w11[i] = 1 / (l11 * view.noise());
    w21[i] = -l21 / (l11 * l22 * view.noise());
    w22[i] = 1 / (l22 * view.noise());
  }

  /** These observations only. */
  FlightData pick(int[] indices) {
    FlightData part = new FlightData(indices.length);
    for (int k = 0; k < indices.length; k++) {
      int i = indices[k];
      part.time[k] = time[i];
      part.x[k] = x[i];
      part.y[k] = y[i];
      part.cameraX[k] = cameraX[i];
      part.cameraY[k] = cameraY[i];
      part.cameraHeight[k] = cameraHeight[i];
      part.w11[k] = w11[i];
      part.w21[k] = w21[i];
      part.w22[k] = w22[i];
    }
    return part;
  }
}
