package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.SlidingResistance;

/** A learned factor on the carpet's friction, the same whether the ball slides or rolls: a carpet that is brushed, worn or damp somewhere is so for both. */
final class LearnedFriction extends LearnedRolling implements SlidingResistance {

  LearnedFriction(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedFriction withParameters(double... values) {
    return new LearnedFriction(family(), values);
  }

  @Override
  public double slidingFactor(BallMotion motion) {
    return factor(motion);
  }
}
