package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.Bounce;
import java.util.List;

/**
 * Vertical damping × (1 + change), with another change in each kick: bounces differ at random because the carpet is rough, or because a simulator's steps meet the ground at random. It has no name and cannot be predicted. It is in the model so that chance does not pass for a cause that all kicks share. Its mean is the damping itself.
 *
 * @param change of the vertical damping of one kick (–)
 */
public record BounceScatter(double change) implements ChanceOfKick, Bounce {
  private static final String ID = "bounce_scatter";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public BounceScatter {
    EffectParameters.requireFinite(ID, change);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The height of bounces differs from kick to kick by chance.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "change",
            "",
            change,
            0.05,
            -0.9,
            0.9,
            true,
            "chosen: dampingZ of single chips scatters by 5 % in a rigid-body simulator"));
  }

  @Override
  public BounceScatter withParameters(double... values) {
    return new BounceScatter(EffectParameters.require(ID, values, 1)[0]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.chips();
  }

  @Override
  public boolean isAbsent() {
    return change == 0;
  }

  @Override
  public double dampingZ(BallMotion motion, double dampingZ) {
    return dampingZ * (1 + change);
  }
}
