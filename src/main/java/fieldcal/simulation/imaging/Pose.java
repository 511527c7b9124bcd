package fieldcal.simulation.imaging;

import fieldcal.camera.CameraCalibration;

/**
 * Where a camera is and how it is turned: the quaternion (vector first) turns world vectors into the camera's frame.
 */
record Pose(double x, double y, double z, double qx, double qy, double qz, double qw) {

  /** Looks straight down, the image's x axis at an angle from the field's. */
  static Pose lookingDown(double x, double y, double z, double yaw) {
    // First turn the world by −yaw about z, then by 180° about x.
    double half = -0.5 * yaw;
    return new Pose(x, y, z, 1, 0, 0, 0).turnedWorld(0, 0, Math.sin(half), Math.cos(half));
  }

  /** The camera turned about a horizontal axis of the field through its own position. */
  Pose tilted(double angle, double axis) {
    if (angle == 0) {
      return this;
    }
    // The camera turns by +angle, so the world in its eyes by −angle.
    double half = -0.5 * angle;
    double s = Math.sin(half);
    return turnedWorld(s * Math.cos(axis), s * Math.sin(axis), 0, Math.cos(half));
  }

  Pose moved(double dx, double dy, double dz) {
    return new Pose(x + dx, y + dy, z + dz, qx, qy, qz, qw);
  }

  /** This rotation after another one of the world: the product of quaternions q·p. */
  private Pose turnedWorld(double px, double py, double pz, double pw) {
    return new Pose(
        x,
        y,
        z,
        qw * px + qx * pw + qy * pz - qz * py,
        qw * py - qx * pz + qy * pw + qz * px,
        qw * pz + qx * py - qy * px + qz * pw,
        qw * pw - qx * px - qy * py - qz * pz);
  }

  /** The calibration as it is published: 32-bit numbers, millimetres. */
  CameraCalibration calibration(int id, Lens lens, int width, int height) {
    double q0 = (float) qx;
    double q1 = (float) qy;
    double q2 = (float) qz;
    double q3 = (float) qw;
    // t = −R·C with the rotation as rounded.
    double r00 = q3 * q3 + q0 * q0 - q1 * q1 - q2 * q2;
    double r01 = 2.0 * (q0 * q1 - q3 * q2);
    double r02 = 2.0 * (q0 * q2 + q3 * q1);
    double r10 = 2.0 * (q0 * q1 + q3 * q2);
    double r11 = q3 * q3 - q0 * q0 + q1 * q1 - q2 * q2;
    double r12 = 2.0 * (q1 * q2 - q3 * q0);
    double r20 = 2.0 * (q0 * q2 - q3 * q1);
    double r21 = 2.0 * (q1 * q2 + q3 * q0);
    double r22 = q3 * q3 - q0 * q0 - q1 * q1 + q2 * q2;
    double tx = -(r00 * x + r01 * y + r02 * z);
    double ty = -(r10 * x + r11 * y + r12 * z);
    double tz = -(r20 * x + r21 * y + r22 * z);
    return new CameraCalibration(
        id,
        (float) lens.focalLength(),
        (float) lens.principalX(),
        (float) lens.principalY(),
        (float) lens.distortion(),
        q0,
        q1,
        q2,
        q3,
        Millimetres.rounded(tx),
        Millimetres.rounded(ty),
        Millimetres.rounded(tz),
        Millimetres.rounded(x),
        Millimetres.rounded(y),
        Millimetres.rounded(z),
        width,
        height);
  }

  /** Focal length and principal point in pixels, radial distortion. */
  record Lens(double focalLength, double principalX, double principalY, double distortion) {}
}
