package fieldcal.effect;

import fieldcal.camera.Camera;

/**
 * A look of a camera at a ball, on its way from the ball to the reported position: a working object that measurement effects change in turn. World frame,
 * m; directions are not normalised. Valid during the call only.
 */
public final class Sight {
  private final ObservedCamera observer;
  private double cameraX;
  private double cameraY;
  private double cameraZ;
  private double believedX;
  private double believedY;
  private double believedZ;
  private double rayX;
  private double rayY;
  private double rayZ;
  private double plane;
  private double offsetX;
  private double offsetY;

  Sight(ObservedCamera observer) {
    this.observer = observer;
    Camera camera = observer.camera().orElse(null);
    if (camera != null) {
      cameraX = camera.positionX();
      cameraY = camera.positionY();
      cameraZ = camera.positionZ();
      believedX = cameraX;
      believedY = cameraY;
      believedZ = cameraZ;
      plane = camera.ballPlane();
    }
  }

  double cameraX() {
    return cameraX;
  }

  double cameraY() {
    return cameraY;
  }

  double cameraZ() {
    return cameraZ;
  }

  double believedX() {
    return believedX;
  }

  double believedY() {
    return believedY;
  }

  double believedZ() {
    return believedZ;
  }

  double plane() {
    return plane;
  }

  double offsetX() {
    return offsetX;
  }

  double offsetY() {
    return offsetY;
  }

  /**
   * Who looks.
   *
   * @return what is known of the camera
   */
  public ObservedCamera camera() {
    return observer;
  }

  /**
   * Moves the true camera.
   *
   * @param dx shift along x, m
   * @param dy shift along y, m
   * @param dz shift upwards, m
   */
  public void moveCamera(double dx, double dy, double dz) {
    cameraX += dx;
    cameraY += dy;
    cameraZ += dz;
  }

  /**
   * Moves both the true camera and the one with which vision computes: for errors where vision is right about its camera and publishes another position.
   *
   * @param dx shift along x, m
   * @param dy shift along y, m
   * @param dz shift upwards, m
   */
  public void moveBelief(double dx, double dy, double dz) {
    moveCamera(dx, dy, dz);
    believedX += dx;
    believedY += dy;
    believedZ += dz;
  }

  /**
   * Direction of the ray.
   *
   * @return x, any length
   */
  public double rayX() {
    return rayX;
  }

  /**
   * Direction of the ray.
   *
   * @return y, any length
   */
  public double rayY() {
    return rayY;
  }

  /**
   * Direction of the ray.
   *
   * @return z, negative = downwards, any length
   */
  public double rayZ() {
    return rayZ;
  }

  /**
   * Gives the ray another direction.
   *
   * @param x any length
   * @param y any length
   * @param z any length
   */
  public void turnRay(double x, double y, double z) {
    rayX = x;
    rayY = y;
    rayZ = z;
  }

  /**
   * Raises the plane with which vision intersects the ray.
   *
   * @param height by how much, m
   */
  public void raisePlane(double height) {
    plane += height;
  }

  /**
   * Adds to the reported position.
   *
   * @param dx shift along x, m
   * @param dy shift along y, m
   */
  public void shiftReport(double dx, double dy) {
    offsetX += dx;
    offsetY += dy;
  }
}
