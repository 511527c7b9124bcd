package fieldcal.simulation.imaging;

import fieldcal.camera.CameraCalibration;
import java.util.Arrays;

/**
 * Where a camera is and how it is turned: the quaternion (vector first) turns world vectors into the camera's frame.
 */
record Pose(double x, double y, double z, double qx, double qy, double qz, double qw) {

  /** The pose that a calibration says. */
  static Pose of(CameraCalibration c) {
    double norm = Math.sqrt(c.q0() * c.q0() + c.q1() * c.q1() + c.q2() * c.q2() + c.q3() * c.q3());
    Pose turned = new Pose(0, 0, 0, c.q0() / norm, c.q1() / norm, c.q2() / norm, c.q3() / norm);
    double[] r = turned.matrix();
    // C = −Rᵀ·t
    return turned.moved(
        -(r[0] * c.tx() + r[3] * c.ty() + r[6] * c.tz()),
        -(r[1] * c.tx() + r[4] * c.ty() + r[7] * c.tz()),
        -(r[2] * c.tx() + r[5] * c.ty() + r[8] * c.tz()));
  }

  /** A calibration that says another position and the same rotation; a placeholder that has no rotation keeps what it says of it. */
  static CameraCalibration displaced(CameraCalibration c, double dx, double dy, double dz) {
    if (dx == 0 && dy == 0 && dz == 0) {
      return c;
    }
    double[] r = new Pose(0, 0, 0, c.q0(), c.q1(), c.q2(), c.q3()).matrix();
    return c.withPosition(
        rounded(
            c.tx() - (r[0] * dx + r[1] * dy + r[2] * dz),
            c.ty() - (r[3] * dx + r[4] * dy + r[5] * dz),
            c.tz() - (r[6] * dx + r[7] * dy + r[8] * dz)),
        rounded(c.derivedWorldX() + dx, c.derivedWorldY() + dy, c.derivedWorldZ() + dz));
  }

  private static double[] rounded(double... metres) {
    return Arrays.stream(metres).map(Millimetres::rounded).toArray();
  }

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

  /** The rotation, row by row. */
  private double[] matrix() {
    return new double[] {
      qw * qw + qx * qx - qy * qy - qz * qz,
      2.0 * (qx * qy - qw * qz),
      2.0 * (qx * qz + qw * qy),
      2.0 * (qx * qy + qw * qz),
      qw * qw - qx * qx + qy * qy - qz * qz,
      2.0 * (qy * qz - qw * qx),
      2.0 * (qx * qz - qw * qy),
      2.0 * (qy * qz + qw * qx),
      qw * qw - qx * qx - qy * qy + qz * qz
    };
  }

  /** The calibration as it is published: 32-bit numbers, millimetres. */
  CameraCalibration calibration(int id, Lens lens, int width, int height) {
    double q0 = (float) qx;
    double q1 = (float) qy;
    double q2 = (float) qz;
    double q3 = (float) qw;
    // t = −R·C with the rotation as rounded.
    double[] r = new Pose(x, y, z, q0, q1, q2, q3).matrix();
    double tx = -(r[0] * x + r[1] * y + r[2] * z);
    double ty = -(r[3] * x + r[4] * y + r[5] * z);
    double tz = -(r[6] * x + r[7] * y + r[8] * z);
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
  record Lens(double focalLength, double principalX, double principalY, double distortion) {
    static Lens of(CameraCalibration c) {
      return new Lens(c.focalLength(), c.principalPointX(), c.principalPointY(), c.distortion());
    }

    Lens withDistortion(double coefficient) {
      return new Lens(focalLength, principalX, principalY, coefficient);
    }
  }
}
