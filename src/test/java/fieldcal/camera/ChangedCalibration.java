package fieldcal.camera;

/** Calibrations with some values that cannot be. */
public final class ChangedCalibration {
  private ChangedCalibration() {}

  /** The same with another lens. */
  public static CameraCalibration withDistortion(CameraCalibration c, double distortion) {
    return with(c, distortion, c.tz(), c.derivedWorldX(), c.derivedWorldZ());
  }

  /** The same with another published x, m. */
  public static CameraCalibration withWorldX(CameraCalibration c, double x) {
    return with(c, c.distortion(), c.tz(), x, c.derivedWorldZ());
  }

  /** The same that hangs at another height, m, above the field's centre line, by its pose and by its published position. */
  public static CameraCalibration withHeight(CameraCalibration c, double height) {
    return with(c, c.distortion(), height, 0, height);
  }

  private static CameraCalibration with(
      CameraCalibration c, double distortion, double tz, double x, double z) {
    return new CameraCalibration(
        c.id(),
        c.focalLength(),
        c.principalPointX(),
        c.principalPointY(),
        distortion,
        c.q0(),
        c.q1(),
        c.q2(),
        c.q3(),
        c.tx(),
        c.ty(),
        tz,
        x,
        c.derivedWorldY(),
        z,
        c.imageWidth(),
        c.imageHeight());
  }
}
