package fieldcal.simulation.imaging;

/**
 * What is wrong with one camera: published minus true, and time stamps. Start from {@link #NONE}.
 *
 * @param tilt rotation of the published pose about {@code tiltAxis}, rad
 * @param tiltAxis direction of the horizontal axis in the field, rad
 * @param heightError published minus true height, m
 * @param shiftX published minus true position, m
 * @param shiftY published minus true position, m
 * @param distortionError published minus true radial distortion
 * @param offsetX added to everything it reports, m
 * @param offsetY added to everything it reports, m
 * @param timeOffset added to its time stamps, s
 * @param clockSkew its clock gains that much per second (–)
 * @param shakeAmplitude everything it reports swings along x by that much, m
 * @param shakeRate how often it swings, 1/s
 */
public record CameraErrors(
    double tilt,
    double tiltAxis,
    double heightError,
    double shiftX,
    double shiftY,
    double distortionError,
    double offsetX,
    double offsetY,
    double timeOffset,
    double clockSkew,
    double shakeAmplitude,
    double shakeRate) {

  /** Nothing is wrong. */
  public static final CameraErrors NONE = new CameraErrors(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /**
   * Another tilt of the published pose.
   *
   * @param angle rad
   * @param axis direction of the horizontal axis in the field, rad
   * @return the changed errors
   */
  public CameraErrors withTilt(double angle, double axis) {
    return new CameraErrors(
        angle,
        axis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate);
  }

  /**
   * Another published position.
   *
   * @param x published minus true, m
   * @param y published minus true, m
   * @param height published minus true, m
   * @return the changed errors
   */
  public CameraErrors withShift(double x, double y, double height) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        height,
        x,
        y,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate);
  }

  /**
   * Another published lens.
   *
   * @param error published minus true radial distortion
   * @return the changed errors
   */
  public CameraErrors withDistortion(double error) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        error,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate);
  }

  /**
   * Another offset of everything it reports.
   *
   * @param x m
   * @param y m
   * @return the changed errors
   */
  public CameraErrors withOffset(double x, double y) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        x,
        y,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate);
  }

  /**
   * Another clock.
   *
   * @param offset added to time stamps, s
   * @param skew gain per second (–)
   * @return the changed errors
   */
  public CameraErrors withTiming(double offset, double skew) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        offset,
        skew,
        shakeAmplitude,
        shakeRate);
  }

  /**
   * A mount that swings.
   *
   * @param amplitude m
   * @param rate 1/s
   * @return the changed errors
   */
  public CameraErrors withShake(double amplitude, double rate) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        amplitude,
        rate);
  }

  /**
   * Both at once; of two tilts and of two swings the larger one stays.
   *
   * @param other more errors
   * @return the sum
   */
  public CameraErrors plus(CameraErrors other) {
    CameraErrors tilted = Math.abs(tilt) >= Math.abs(other.tilt) ? this : other;
    CameraErrors shaken = Math.abs(shakeAmplitude) >= Math.abs(other.shakeAmplitude) ? this : other;
    return NONE.withTilt(tilted.tilt, tilted.tiltAxis)
        .withShift(shiftX + other.shiftX, shiftY + other.shiftY, heightError + other.heightError)
        .withDistortion(distortionError + other.distortionError)
        .withOffset(offsetX + other.offsetX, offsetY + other.offsetY)
        .withTiming(timeOffset + other.timeOffset, clockSkew + other.clockSkew)
        .withShake(shaken.shakeAmplitude, shaken.shakeRate);
  }

  /** Where the swing is at a time, m. */
  double shakeAt(double time) {
    return shakeAmplitude == 0 ? 0 : shakeAmplitude * Math.sin(2 * Math.PI * shakeRate * time);
  }
}
