package fieldcal.effect.motion;

import fieldcal.ball.Gravity;
import fieldcal.ball.Parameter;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.ExternalForce;
import java.util.List;

/**
 * A field that is not level: acceleration g·percent/100 downhill, in flight as well as on the carpet; a rolling ball feels 1/(1+β) = 5/7 of it.
 *
 * @param percent slope, height over length in %, 0 = level
 * @param direction downhill in the field frame, rad, 0 = along x, counter-clockwise
 */
public record FieldSlope(double percent, double direction) implements ExternalForce {
  private static final String ID = "field_slope";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public FieldSlope {
    EffectParameters.requireFinite(ID, percent, direction);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The field is not level: the ball is pulled downhill.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "percent",
            "%",
            percent,
            0.1,
            -3,
            3,
            true,
            "halls are level to some tenths of a percent"),
        EffectParameters.direction("direction", direction));
  }

  @Override
  public FieldSlope withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new FieldSlope(v[0], v[1]);
  }

  @Override
  public boolean isAbsent() {
    return percent == 0;
  }

  @Override
  public void addAcceleration(BallMotion motion, double[] acceleration) {
    field().add(motion, acceleration);
  }

  @Override
  public Field field() {
    double pull = Gravity.ACCELERATION * percent / 100;
    double x = pull * Math.cos(direction);
    double y = pull * Math.sin(direction);
    return (motion, acceleration) -> {
      acceleration[0] += x;
      acceleration[1] += y;
    };
  }
}
