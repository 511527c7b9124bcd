package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.FrictionOfKick;
import java.util.List;

/**
 * Rolling deceleration × (1 + change), with another change in each kick: differences at random that no cause explains. It has no name and cannot be predicted. It is in the model so that chance does not pass for a cause that all kicks share. Its mean is the rolling deceleration itself.
 *
 * @param change of the rolling deceleration of one kick (–)
 */
public record RollScatter(double change) implements ChanceOfKick, FrictionOfKick {
  private static final String ID = "roll_scatter";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public RollScatter {
    EffectParameters.requireFinite(ID, change);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "Rolling deceleration differs from kick to kick by chance.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "change",
            "",
            change,
            0.1,
            -0.9,
            3,
            true,
            "chosen: accRoll scatters by 10 % in matches of 2026"));
  }

  @Override
  public RollScatter withParameters(double... values) {
    return new RollScatter(EffectParameters.require(ID, values, 1)[0]);
  }

  @Override
  public boolean isAbsent() {
    return change == 0;
  }

  @Override
  public double rolling(double kickTime) {
    return 1 + change;
  }

  @Override
  public double sliding(double kickTime) {
    return 1;
  }
}
