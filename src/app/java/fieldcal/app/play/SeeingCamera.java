package fieldcal.app.play;

import fieldcal.camera.Camera;

/**
 * A camera, and how large its image is.
 *
 * @param camera its geometry
 * @param width pixels; 0 when not known
 * @param height pixels; 0 when not known
 */
record SeeingCamera(Camera camera, int width, int height) {

  /** Whether it is known which balls are in the image. */
  boolean hasImage() {
    return camera.hasPixels() && width > 0 && height > 0;
  }

  /** Whether a ball is in the image. */
  boolean sees(double x, double y, double z) {
    double[] pixel = new double[2];
    camera.worldToPixel(x, y, z, pixel);
    return pixel[0] >= 0 && pixel[0] <= width && pixel[1] >= 0 && pixel[1] <= height;
  }

  double distance(double x, double y) {
    return Math.hypot(camera.positionX() - x, camera.positionY() - y);
  }
}
