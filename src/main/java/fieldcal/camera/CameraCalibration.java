package fieldcal.camera;

/**
 * One camera as a geometry packet describes it: SSL-Vision's pinhole model with one radial distortion coefficient.
 *
 * <p>A world point P is seen at camera coordinates {@code c = R(q)·P + t}, where R turns world vectors into the camera's frame (x to the
 * right of the image, y down, z along the optical axis). Its undistorted image point is {@code (cx/cz, cy/cz)}, of radius {@code ru}; the
 * lens draws it at radius {@code rd} in the same direction with {@code ru = rd·(1 + distortion·rd²)}; the pixel is {@code focalLength·d +
 * principalPoint}. Source: SSL-Vision, {@code CameraParameters::field2image} and {@code image2field}.
 *
 * <p>The values are as published, not as meant: some sources fill in placeholders. {@link Camera#of(CameraCalibration)} decides what to
 * believe. Quaternion order is the wire's: vector part first, scalar last; it need not be normalised. All required values are finite; the
 * derived position is finite in all three coordinates or NaN in all three. The constructor throws {@link IllegalArgumentException}
 * with the offending value where that does not hold, or where the id or the image size is negative.
 *
 * @param id camera number, 0 or more
 * @param focalLength pixels
 * @param principalPointX pixels
 * @param principalPointY pixels
 * @param distortion radial coefficient, dimensionless (radii are in focal lengths); either sign, 0 for a perfect lens
 * @param q0 x of the rotation quaternion world to camera
 * @param q1 y of the rotation quaternion
 * @param q2 z of the rotation quaternion
 * @param q3 scalar part of the rotation quaternion
 * @param tx world origin in the camera's frame, m
 * @param ty world origin in the camera's frame, m
 * @param tz world origin in the camera's frame, m
 * @param derivedWorldX position of the camera in the world, m; NaN when absent
 * @param derivedWorldY position of the camera in the world, m; NaN when absent
 * @param derivedWorldZ height of the camera above the carpet, m; NaN when absent
 * @param imageWidth pixels; 0 when absent
 * @param imageHeight pixels; 0 when absent
 */
public record CameraCalibration(
    int id,
    double focalLength,
    double principalPointX,
    double principalPointY,
    double distortion,
    double q0,
    double q1,
    double q2,
    double q3,
    double tx,
    double ty,
    double tz,
    double derivedWorldX,
    double derivedWorldY,
    double derivedWorldZ,
    int imageWidth,
    int imageHeight) {

  /**
   * Checks the values. {@inheritDoc}
   *
   * @throws IllegalArgumentException with the name and the value that is wrong
   */
  public CameraCalibration {
    if (id < 0) {
      throw new IllegalArgumentException("camera id must be 0 or more but is " + id);
    }
    requireFinite(id, "focal_length", focalLength);
    requireFinite(id, "principal_point_x", principalPointX);
    requireFinite(id, "principal_point_y", principalPointY);
    requireFinite(id, "distortion", distortion);
    requireFinite(id, "q0", q0);
    requireFinite(id, "q1", q1);
    requireFinite(id, "q2", q2);
    requireFinite(id, "q3", q3);
    requireFinite(id, "tx", tx);
    requireFinite(id, "ty", ty);
    requireFinite(id, "tz", tz);
    boolean absent =
        Double.isNaN(derivedWorldX) && Double.isNaN(derivedWorldY) && Double.isNaN(derivedWorldZ);
    if (!absent) {
      requireFinite(id, "derived_camera_world_tx", derivedWorldX);
      requireFinite(id, "derived_camera_world_ty", derivedWorldY);
      requireFinite(id, "derived_camera_world_tz", derivedWorldZ);
    }
    if (imageWidth < 0 || imageHeight < 0) {
      throw new IllegalArgumentException(
          "camera " + id + ": image size " + imageWidth + " x " + imageHeight + " is negative");
    }
  }

  /**
   * Whether the packet gave the camera's position in the world.
   *
   * @return true when the derived position is present
   */
  public boolean hasDerivedPosition() {
    return !Double.isNaN(derivedWorldX);
  }

  /**
   * The same camera published elsewhere.
   *
   * @param translation world origin in the camera's frame, m
   * @param position of the camera in the world, m; NaN where absent
   * @return the changed calibration
   */
  public CameraCalibration withPosition(double[] translation, double[] position) {
    return new CameraCalibration(
        id,
        focalLength,
        principalPointX,
        principalPointY,
        distortion,
        q0,
        q1,
        q2,
        q3,
        translation[0],
        translation[1],
        translation[2],
        position[0],
        position[1],
        position[2],
        imageWidth,
        imageHeight);
  }

  private static void requireFinite(int id, String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("camera " + id + ": " + name + " is " + value);
    }
  }
}
