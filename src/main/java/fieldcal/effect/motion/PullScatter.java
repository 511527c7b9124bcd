package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.PathAcceleration;
import java.util.List;

/**
 * A pull across the path of a rolling ball that differs from kick to kick. Where the centre of mass lies off the centre by d along the axis about which the ball rolls, the weight has a torque about the point of contact, 1.4·m·r² being the moment of inertia about it: the path turns with d·g/(1.4·r),
 * whatever the speed. How large d is, and to which side, depends on how the ball lay when it was kicked. It has no name and cannot be predicted. It is in the model so that chance does not pass for a cause that all kicks share. It has no mean, because it acts to either side equally often.
 *
 * @param pull across the path while the ball rolls, m/s²; positive turns it to its left
 */
public record PullScatter(double pull) implements ChanceOfKick, PathAcceleration {
  private static final String ID = "pull_scatter";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public PullScatter {
    EffectParameters.requireFinite(ID, pull);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "A rolling ball is pulled to a side, another way in each kick by chance.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "pull",
            "m/s²",
            pull,
            0.02,
            -1,
            1,
            true,
            "chosen: a centre of mass that is 0.06 mm off the centre of a golf ball"));
  }

  @Override
  public PullScatter withParameters(double... values) {
    return new PullScatter(EffectParameters.require(ID, values, 1)[0]);
  }

  @Override
  public boolean isAbsent() {
    return pull == 0;
  }

  @Override
  public double across(BallMotion motion) {
    return motion.isSliding() ? 0 : pull;
  }

  @Override
  public double longestStep(BallMotion motion) {
    return Double.POSITIVE_INFINITY;
  }
}
