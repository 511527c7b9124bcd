package fieldcal.camera;

/** Calibrations with some other values, also such as cannot be. */
public final class ChangedCalibration {
  private ChangedCalibration() {}

  /** The same with another focal length, pixels. */
  public static CameraCalibration withFocalLength(CameraCalibration c, double focalLength) {
    return with(c, focalLength, c.distortion(), c.tz(), c.derivedWorldX(), c.derivedWorldZ());
  }

  /** The same with another lens. */
  public static CameraCalibration withDistortion(CameraCalibration c, double distortion) {
    return with(c, c.focalLength(), distortion, c.tz(), c.derivedWorldX(), c.derivedWorldZ());
  }

  /** The same with another published x, m. */
  public static CameraCalibration withWorldX(CameraCalibration c, double x) {
    return with(c, c.focalLength(), c.distortion(), c.tz(), x, c.derivedWorldZ());
  }

  /** The same that hangs at another height, m, above the field's centre line, by its pose and by its published position. */
  public static CameraCalibration withHeight(CameraCalibration c, double height) {
    return with(c, c.focalLength(), c.distortion(), height, 0, height);
  }

  private static CameraCalibration with(
      CameraCalibration c, double focalLength, double distortion, double tz, double x, double z) {
    return new CameraCalibration(
        c.id(),
        focalLength,
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
