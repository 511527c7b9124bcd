package fieldcal.simulation.imaging;

/**
 * What is wrong with one camera: published minus true, and time stamps.
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
    double clockSkew) {

  /** Nothing is wrong. */
  public static final CameraErrors NONE = new CameraErrors(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /**
   * Both at once; of two tilts the larger one stays.
   *
   * @param other more errors
   * @return the sum
   */
  public CameraErrors plus(CameraErrors other) {
    boolean keep = Math.abs(tilt) >= Math.abs(other.tilt);
    return new CameraErrors(
        keep ? tilt : other.tilt,
        keep ? tiltAxis : other.tiltAxis,
        heightError + other.heightError,
        shiftX + other.shiftX,
        shiftY + other.shiftY,
        distortionError + other.distortionError,
        offsetX + other.offsetX,
        offsetY + other.offsetY,
        timeOffset + other.timeOffset,
        clockSkew + other.clockSkew);
  }
}
