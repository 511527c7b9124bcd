package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.Bounce;
import java.util.List;

/**
 * Tangential restitution e_xy − coefficient·φ, at least 0, with the spin fraction φ = (s·v)/|v|² right before the impact ({@link BallMotion#spinFraction}): 1 = rolls, negative = backspin. So with a positive coefficient
 * topspin loses more speed and backspin less; a ball that grips shows a negative one. It comes on top of what the spin of the kick does at impacts anyway ({@link fieldcal.effect.ExtendedTrajectory}), and does
 * nothing beside {@link ContactImpacts}, which uses no e_xy.
 *
 * @param coefficient loss of tangential restitution per unit of spin fraction (–), 0 = none
 */
public record BounceSpinCoupling(double coefficient) implements Bounce {
  private static final String ID = "bounce_spin_coupling";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public BounceSpinCoupling {
    EffectParameters.requireFinite(ID, coefficient);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "How much speed a bounce takes depends on the ball's spin.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "coefficient",
            "",
            coefficient,
            0.05,
            -1,
            1,
            true,
            "chosen: −2/7 to 0 for a ball that grips"));
  }

  @Override
  public boolean actsThroughSpin() {
    return true;
  }

  @Override
  public BounceSpinCoupling withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new BounceSpinCoupling(v[0]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.chips();
  }

  @Override
  public boolean isAbsent() {
    return coefficient == 0;
  }

  @Override
  public double dampingXy(BallMotion motion, double dampingXy) {
    return dampingXy - coefficient * motion.spinFraction();
  }
}
