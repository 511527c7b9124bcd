package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.Sight;
import java.util.ArrayList;
import java.util.List;

/**
 * Published minus true position of one camera, or the same of all, where vision itself is right about the carpet: the image of the field fits, so balls on the ground are reported where they are, but a wrong focal length goes with a
 * wrong distance. A ball at height h above a resting one is reported at {@code P + (P − C)·h/(H − h)}, with P below the ball and the <em>true</em> camera above C, H higher than the centre of a resting ball; a program that uses the published one takes a flight from one place for
 * a flight from another. So it shows in chips only.
 *
 * @param xMm published minus true position along x, mm
 * @param yMm published minus true position along y, mm
 * @param heightMm published minus true height, mm
 * @param camera which camera, by id; {@link EffectParameters#ALL_CAMERAS} = the same of all cameras
 */
public record CameraPositionError(double xMm, double yMm, double heightMm, int camera)
    implements MeasurementEffect {
  private static final String ID = "camera_position_error";
  private static final double MILLI = 1e-3;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CameraPositionError {
    EffectParameters.requireFinite(ID, xMm, yMm, heightMm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "A camera hangs elsewhere than vision publishes, although balls on the carpet are"
        + " reported where they are.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "x_mm",
            "mm",
            xMm,
            50,
            -1000,
            1000,
            true,
            "a well-known simulator publishes positions some 100 mm off"),
        new Parameter("y_mm", "mm", yMm, 50, -1000, 1000, true, "as x_mm"),
        new Parameter(
            "height_mm",
            "mm",
            heightMm,
            50,
            -1000,
            1000,
            true,
            "a focal length 1 % off goes with 1 % of the height, some 50 mm"),
        EffectParameters.cameraOrAll(camera));
  }

  @Override
  public CameraPositionError withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 4);
    return new CameraPositionError(v[0], v[1], v[2], (int) v[3]);
  }

  @Override
  public List<Effect> candidates(Arena arena) {
    List<Effect> all = new ArrayList<>(MeasurementEffect.super.candidates(arena));
    if (all.size() > 1) {
      all.add(new CameraPositionError(0, 0, 0, EffectParameters.ALL_CAMERAS));
    }
    return List.copyOf(all);
  }

  @Override
  public List<List<String>> choices() {
    return List.of(List.of("x_mm", "y_mm"), List.of("height_mm"), magnitudes());
  }

  @Override
  public boolean isAbsent() {
    return xMm == 0 && yMm == 0 && heightMm == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("x_mm", "y_mm", "height_mm");
  }

  /** {@inheritDoc} Only flights show it. */
  @Override
  public boolean canShowIn(Arena arena) {
    return arena.chips() && MeasurementEffect.super.canShowIn(arena);
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return camera == EffectParameters.ALL_CAMERAS || observer.id() == camera;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return observer.camera().isPresent();
  }

  @Override
  public void moveCamera(Sight sight) {
    sight.moveBelief(-MILLI * xMm, -MILLI * yMm, -MILLI * heightMm);
  }
}
