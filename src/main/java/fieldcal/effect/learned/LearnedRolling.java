package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.Varying;

/** A learned factor on the rolling deceleration: due to the ball's skin or the pile of the carpet, without effect on a sliding ball. */
sealed class LearnedRolling extends LearnedTerm implements RollingResistance, Varying
    permits LearnedFriction {

  LearnedRolling(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedRolling withParameters(double... values) {
    return new LearnedRolling(family(), values);
  }

  @Override
  public double factor(BallMotion motion) {
    // A carpet never pushes, however far an estimator strays.
    return Math.max(0, 1 + valueAt(0, motion));
  }

  @Override
  public double longestStep(BallMotion motion) {
    return longestStepFor(motion);
  }
}
