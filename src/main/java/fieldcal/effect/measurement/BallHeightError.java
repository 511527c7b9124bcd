package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.Sight;
import java.util.List;

/**
 * In all cameras, vision intersects the ray through the ball's centre with a plane at a wrong height. If this is too high, balls are reported too near to the point below the camera.
 *
 * @param mm assumed minus true height of a resting ball's centre, mm; the true height is 21.5 mm
 */
public record BallHeightError(double mm) implements MeasurementEffect {
  private static final String ID = "ball_height_error";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public BallHeightError {
    EffectParameters.requireFinite(ID, mm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "Vision assumes a wrong height for the centre of the ball.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "mm", "mm", mm, 2, -30, 50, true, "some set-ups assume 30 mm instead of 21.5; design"));
  }

  @Override
  public BallHeightError withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new BallHeightError(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return mm == 0;
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return true;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return observer.camera().isPresent();
  }

  @Override
  public void report(Sight sight) {
    sight.raisePlane(1e-3 * mm);
  }
}
