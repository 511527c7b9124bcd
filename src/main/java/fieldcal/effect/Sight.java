package fieldcal.effect;

import fieldcal.camera.Camera;

/**
 * One look of a camera at a ball, on its way from the ball to the reported position: a working object that measurement effects change in turn. World frame,
 * m; directions are not normalised. Valid during the call only.
 */
public final class Sight {
  private final ObservedCamera observer;
  private final Camera camera;
  private double cameraX;
  private double cameraY;
  private double cameraZ;
  private double rayX;
  private double rayY;
  private double rayZ;
  private double plane;
  private double offsetX;
  private double offsetY;

  Sight(ObservedCamera observer) {
    this.observer = observer;
    camera = observer.camera().orElse(null);
    if (camera != null) {
      cameraX = camera.positionX();
      cameraY = camera.positionY();
      cameraZ = camera.positionZ();
      plane = camera.ballPlane();
    }
  }

  /** Draws the ray from where the camera is by now to the ball's centre. */
  void look(double[] ball) {
    rayX = ball[0] - cameraX;
    rayY = ball[1] - cameraY;
    rayZ = ball[2] + Camera.BALL_RADIUS - cameraZ;
  }

  /** Cuts the ray, drawn from the published position, with the plane. */
  void land(double[] ball, double[] ground) {
    if (camera == null) {
      ground[0] = ball[0] + offsetX;
      ground[1] = ball[1] + offsetY;
      return;
    }
    double way = rayZ < 0 ? (plane - camera.positionZ()) / rayZ : Double.NaN;
    ground[0] = camera.positionX() + way * rayX + offsetX;
    ground[1] = camera.positionY() + way * rayY + offsetY;
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
   * @param dx m
   * @param dy m
   * @param dz m
   */
  public void moveCamera(double dx, double dy, double dz) {
    cameraX += dx;
    cameraY += dy;
    cameraZ += dz;
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
   * Raises the plane that vision cuts the ray with.
   *
   * @param height m
   */
  public void raisePlane(double height) {
    plane += height;
  }

  /**
   * Adds to the reported position.
   *
   * @param dx m
   * @param dy m
   */
  public void shiftReport(double dx, double dy) {
    offsetX += dx;
    offsetY += dy;
  }
}
