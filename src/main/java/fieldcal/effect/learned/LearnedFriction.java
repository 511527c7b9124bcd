package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.SlidingResistance;
import fieldcal.effect.MotionEffect.Varying;

/** A learned factor on the carpet's friction, the same whether the ball slides or rolls: a carpet that is brushed, worn or damp somewhere is so for both. */
final class LearnedFriction extends LearnedTerm
    implements SlidingResistance, RollingResistance, Varying {

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

  @Override
  public double factor(BallMotion motion) {
    // Friction never pushes, however far an estimator strays.
    return Math.max(0, 1 + valueAt(0, motion));
  }

  @Override
  public double longestStep(BallMotion motion) {
    return longestStepFor(motion);
  }
}
