package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.RollingResistance;
import java.util.List;

/**
 * Rolling deceleration −accRoll + slope·v: accRoll is the value in the limit of a ball at rest. Sliding does not change.
 *
 * @param slope growth of the rolling deceleration with speed, 1/s; 0 = none
 */
public record SpeedDependentRoll(double slope) implements RollingResistance {
  private static final String ID = "speed_dependent_roll";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public SpeedDependentRoll {
    EffectParameters.requireFinite(ID, slope);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "A fast ball is braked more by rolling than a slow one.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "slope",
            "1/s",
            slope,
            0.02,
            -0.1,
            0.5,
            true,
            "0.253 + 0.019 v² in matches of 2026 is about 0.05 1/s over 3 m/s; design"));
  }

  @Override
  public SpeedDependentRoll withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new SpeedDependentRoll(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return slope == 0;
  }

  @Override
  public double addend(BallMotion motion) {
    return slope * motion.groundSpeed();
  }
}
