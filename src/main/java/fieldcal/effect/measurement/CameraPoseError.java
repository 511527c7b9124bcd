package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.Sight;
import java.util.List;

/**
 * Published minus true pose of one camera. The true ray goes from the true position to the ball; the published camera draws it, turned by the tilt, from the
 * published position. Neither needs the lens, so it applies to cameras of which only the position is known, too.
 *
 * @param tiltMrad angle by which the published camera is turned against the true one, by the right-hand rule about the axis, mrad; positive shifts what is reported below the camera by tilt × height towards axis + π/2
 * @param axis direction of the horizontal axis of that turn, through the camera, in the field frame, rad, 0 = along x, counter-clockwise
 * @param heightMm published minus true height, mm; positive moves reports away from the point below the camera
 * @param shiftXMm published minus true position along x, mm
 * @param shiftYMm published minus true position along y, mm
 * @param camera which camera, by id
 */
public record CameraPoseError(
    double tiltMrad, double axis, double heightMm, double shiftXMm, double shiftYMm, int camera)
    implements MeasurementEffect {
  private static final String ID = "camera_pose_error";
  private static final double MILLI = 1e-3;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CameraPoseError {
    EffectParameters.requireFinite(ID, tiltMrad, axis, heightMm, shiftXMm, shiftYMm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One camera's position or tilt differs from its calibration.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "tilt_mrad",
            "mrad",
            tiltMrad,
            1,
            -50,
            50,
            true,
            "1 mrad is 5 mm below a camera at 5 m"),
        EffectParameters.direction("axis", axis),
        new Parameter(
            "height_mm",
            "mm",
            heightMm,
            10,
            -1000,
            1000,
            true,
            "calibrations err by some centimetres in height"),
        new Parameter("shift_x_mm", "mm", shiftXMm, 5, -500, 500, true, "as camera_offset"),
        new Parameter("shift_y_mm", "mm", shiftYMm, 5, -500, 500, true, "as camera_offset"),
        EffectParameters.camera(camera));
  }

  @Override
  public CameraPoseError withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 6);
    return new CameraPoseError(v[0], v[1], v[2], v[3], v[4], (int) v[5]);
  }

  /** A shift alone is a camera offset; with one camera it cannot be distinguished from a shift of the field. */
  @Override
  public List<List<String>> choices() {
    return List.of(
        List.of("height_mm"),
        List.of("tilt_mrad"),
        List.of("tilt_mrad", "height_mm"),
        List.of("height_mm", "shift_x_mm", "shift_y_mm"),
        List.of("tilt_mrad", "shift_x_mm", "shift_y_mm"));
  }

  @Override
  public boolean isAbsent() {
    return tiltMrad == 0 && heightMm == 0 && shiftXMm == 0 && shiftYMm == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("tilt_mrad", "height_mm", "shift_x_mm", "shift_y_mm");
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return observer.camera().isPresent();
  }

  @Override
  public void moveCamera(Sight sight) {
    sight.moveCamera(-MILLI * shiftXMm, -MILLI * shiftYMm, -MILLI * heightMm);
  }

  @Override
  public void turnRay(Sight sight) {
    if (tiltMrad == 0) {
      return;
    }
    // Rodrigues' rotation about the horizontal axis (c, s, 0): the ray turns with its camera.
    double c = Math.cos(axis);
    double s = Math.sin(axis);
    double cos = Math.cos(MILLI * tiltMrad);
    double sin = Math.sin(MILLI * tiltMrad);
    double x = sight.rayX();
    double y = sight.rayY();
    double z = sight.rayZ();
    double along = (1 - cos) * (c * x + s * y);
    sight.turnRay(
        cos * x + sin * s * z + along * c,
        cos * y - sin * c * z + along * s,
        cos * z + sin * (c * y - s * x));
  }
}
