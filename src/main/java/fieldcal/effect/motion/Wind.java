package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.AirFlow;
import java.util.List;

/**
 * Air that moves over the field: drag acts on the velocity relative to it, so without {@link AirDrag} it does nothing.
 *
 * @param speed of the air, m/s; 0 = still
 * @param direction towards which the air moves in the field frame, rad, 0 = along x, counter-clockwise
 */
public record Wind(double speed, double direction) implements AirFlow {
  private static final String ID = "wind";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public Wind {
    EffectParameters.requireFinite(ID, speed, direction);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The air moves over the field and carries the ball along.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "speed",
            "m/s",
            speed,
            0.3,
            -10,
            10,
            true,
            "chosen: an open hall door or air conditioning moves air at 0.3 to 2 m/s"),
        EffectParameters.direction("direction", direction));
  }

  @Override
  public Wind withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new Wind(v[0], v[1]);
  }

  @Override
  public boolean isAbsent() {
    return speed == 0;
  }

  @Override
  public List<Effect> companions() {
    return List.of(AirDrag.USUAL);
  }

  @Override
  public Flow flow() {
    double x = speed * Math.cos(direction);
    double y = speed * Math.sin(direction);
    return (motion, air) -> {
      air[0] += x;
      air[1] += y;
    };
  }
}
