package fieldcal.camera;

/** Pose and lens of a camera; heights are world heights here, without the ball's radius. See {@link CameraCalibration}. */
final class Pinhole {

  /** Position of the camera in the world, −Rᵀt, m. */
  final double cameraX;

  final double cameraY;
  final double cameraZ;

  private final double focalLength;
  private final double principalX;
  private final double principalY;
  private final RadialDistortion lens;

  // Rotation from the world into the camera's frame.
  private final double r00;
  private final double r01;
  private final double r02;
  private final double r10;
  private final double r11;
  private final double r12;
  private final double r20;
  private final double r21;
  private final double r22;

  private Pinhole(CameraCalibration c, double norm) {
    focalLength = c.focalLength();
    principalX = c.principalPointX();
    principalY = c.principalPointY();
    lens = new RadialDistortion(c.distortion());
    double i = c.q0() / norm;
    double j = c.q1() / norm;
    double k = c.q2() / norm;
    double w = c.q3() / norm;
    r00 = 1 - 2 * (j * j + k * k);
    r01 = 2 * (i * j - w * k);
    r02 = 2 * (i * k + w * j);
    r10 = 2 * (i * j + w * k);
    r11 = 1 - 2 * (i * i + k * k);
    r12 = 2 * (j * k - w * i);
    r20 = 2 * (i * k - w * j);
    r21 = 2 * (j * k + w * i);
    r22 = 1 - 2 * (i * i + j * j);
    cameraX = -(r00 * c.tx() + r10 * c.ty() + r20 * c.tz());
    cameraY = -(r01 * c.tx() + r11 * c.ty() + r21 * c.tz());
    cameraZ = -(r02 * c.tx() + r12 * c.ty() + r22 * c.tz());
  }

  /** The pose of a calibration; null when there is none: a rotation of length zero or a focal length that is not positive. */
  static Pinhole of(CameraCalibration c) {
    double norm = Math.hypot(Math.hypot(c.q0(), c.q1()), Math.hypot(c.q2(), c.q3()));
    return norm > 0 && c.focalLength() > 0 ? new Pinhole(c, norm) : null;
  }

  String position() {
    return Camera.point(cameraX, cameraY, cameraZ);
  }

  void worldToPixel(double x, double y, double z, double[] pixel) {
    double dx = x - cameraX;
    double dy = y - cameraY;
    double dz = z - cameraZ;
    double depth = r20 * dx + r21 * dy + r22 * dz;
    if (!(depth > 0)) {
      pixel[0] = Double.NaN;
      pixel[1] = Double.NaN;
      return;
    }
    double undistortedX = (r00 * dx + r01 * dy + r02 * dz) / depth;
    double undistortedY = (r10 * dx + r11 * dy + r12 * dz) / depth;
    double radius = Math.sqrt(undistortedX * undistortedX + undistortedY * undistortedY);
    double scale = focalLength * lens.distortingFactor(radius);
    pixel[0] = principalX + scale * undistortedX;
    pixel[1] = principalY + scale * undistortedY;
  }

  void pixelToPlane(double u, double v, double height, double[] plane) {
    double distortedX = (u - principalX) / focalLength;
    double distortedY = (v - principalY) / focalLength;
    double factor = lens.undistortingFactor(distortedX * distortedX + distortedY * distortedY);
    double rayX = factor * distortedX;
    double rayY = factor * distortedY;
    double downwards = r02 * rayX + r12 * rayY + r22;
    double s = (height - cameraZ) / downwards;
    if (!(s > 0)) {
      s = Double.NaN;
    }
    plane[0] = cameraX + s * (r00 * rayX + r10 * rayY + r20);
    plane[1] = cameraY + s * (r01 * rayX + r11 * rayY + r21);
  }

  /**
   * d(plane)/d(pixel) at a point of the plane, by the chain pixel → distorted d → undistorted u = (1 + k·|d|²)·d → plane. du/dd = (1 + k·|d|²)·I +
   * 2k·d·dᵀ; du/d(plane) = (R − u·R_z)/depth for the first two rows and columns of R, inverted here.
   */
  void planePerPixel(double x, double y, double height, double[] jacobian) {
    double dx = x - cameraX;
    double dy = y - cameraY;
    double dz = height - cameraZ;
    double depth = r20 * dx + r21 * dy + r22 * dz;
    double undistortedX = (r00 * dx + r01 * dy + r02 * dz) / depth;
    double undistortedY = (r10 * dx + r11 * dy + r12 * dz) / depth;
    double radius = Math.sqrt(undistortedX * undistortedX + undistortedY * undistortedY);
    double shrink = depth > 0 ? lens.distortingFactor(radius) : Double.NaN;
    double distortedX = shrink * undistortedX;
    double distortedY = shrink * undistortedY;
    double k = lens.coefficient();
    double diagonal = 1 + k * (distortedX * distortedX + distortedY * distortedY);
    double m00 = (diagonal + 2 * k * distortedX * distortedX) / focalLength;
    double m01 = 2 * k * distortedX * distortedY / focalLength;
    double m11 = (diagonal + 2 * k * distortedY * distortedY) / focalLength;

    double a00 = (r00 - undistortedX * r20) / depth;
    double a01 = (r01 - undistortedX * r21) / depth;
    double a10 = (r10 - undistortedY * r20) / depth;
    double a11 = (r11 - undistortedY * r21) / depth;
    double determinant = a00 * a11 - a01 * a10;
    jacobian[0] = (a11 * m00 - a01 * m01) / determinant;
    jacobian[1] = (a11 * m01 - a01 * m11) / determinant;
    jacobian[2] = (a00 * m01 - a10 * m00) / determinant;
    jacobian[3] = (a00 * m11 - a10 * m01) / determinant;
  }
}
