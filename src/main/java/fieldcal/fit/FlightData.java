package fieldcal.fit;

import fieldcal.camera.Camera;
import fieldcal.kick.Observations;

/**
 * The observations of a kick, ready for the inner loop: offsets taken out, camera positions and whitening factors looked up.
 */
final class FlightData {
  final int size;
  final int[] camera;
  final double[] time;
  final double[] x;
  final double[] y;
  final double[] cameraX;
  final double[] cameraY;
  final double[] cameraHeight;
  final double[] w11;
  final double[] w21;
  final double[] w22;

  /** The least variance of a camera as a share of its assumed variance. */
  final double[] floor;

  private FlightData(int size) {
    this.size = size;
    camera = new int[size];
    time = new double[size];
    x = new double[size];
    y = new double[size];
    cameraX = new double[size];
    cameraY = new double[size];
    cameraHeight = new double[size];
    w11 = new double[size];
    w21 = new double[size];
    w22 = new double[size];
    floor = new double[size];
  }

  static FlightData of(Observations observations, CameraViews views) {
    FlightData data = new FlightData(observations.size());
    Whitening whitening = new Whitening();
    for (int i = 0; i < data.size; i++) {
      CameraView view = views.get(observations.camera(i));
      data.camera[i] = observations.camera(i);
      data.time[i] = observations.time(i);
      data.x[i] = observations.x(i) - view.offsetX();
      data.y[i] = observations.y(i) - view.offsetY();
      Camera camera = view.camera().orElse(null);
      // Without geometry: infinitely high, so that a ball is reported where it is.
      data.cameraX[i] = camera == null ? 0 : camera.positionX();
      data.cameraY[i] = camera == null ? 0 : camera.positionY();
      data.cameraHeight[i] = camera == null ? 1e9 : camera.heightAboveBallPlane();
      whitening.at(view, data.x[i], data.y[i]);
      data.w11[i] = whitening.w11();
      data.w21[i] = whitening.w21();
      data.w22[i] = whitening.w22();
      double least = CameraNoise.FLOOR / view.noise();
      data.floor[i] = Math.min(1, least * least);
    }
    return data;
  }

  /** Factor by which a ball at height {@code z} is reported farther from the point below the camera than it is. */
  double stretch(int i, double z) {
    // Exactly one on the carpet, where most detections are and nothing has to be divided.
    return z == 0 ? 1 : cameraHeight[i] / (cameraHeight[i] - z);
  }

  /** Seen minus predicted x in the ground plane, m, when the ball is at (x, y, z) in the world, whose {@link #stretch} is given. */
  double residualX(int i, double[] xyz, double stretch) {
    return x[i] - cameraX[i] - (xyz[0] - cameraX[i]) * stretch;
  }

  /** Seen minus predicted y in the ground plane, m, when the ball is at (x, y, z) in the world, whose {@link #stretch} is given. */
  double residualY(int i, double[] xyz, double stretch) {
    return y[i] - cameraY[i] - (xyz[1] - cameraY[i]) * stretch;
  }

  /** Squared whitened length of a vector in the ground plane at an observation. */
  double squared(int i, double dx, double dy) {
    double r1 = w11[i] * dx;
    double r2 = w21[i] * dx + w22[i] * dy;
    return r1 * r1 + r2 * r2;
  }

  /** These observations only. */
  FlightData pick(int[] indices) {
    FlightData part = new FlightData(indices.length);
    for (int k = 0; k < indices.length; k++) {
      int i = indices[k];
      part.camera[k] = camera[i];
      part.time[k] = time[i];
      part.x[k] = x[i];
      part.y[k] = y[i];
      part.cameraX[k] = cameraX[i];
      part.cameraY[k] = cameraY[i];
      part.cameraHeight[k] = cameraHeight[i];
      part.w11[k] = w11[i];
      part.w21[k] = w21[i];
      part.w22[k] = w22[i];
      part.floor[k] = floor[i];
    }
    return part;
  }
}
