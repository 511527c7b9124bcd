package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.Varying;

/** A learned nap that is not the same everywhere: rolls of carpet that were laid in different directions, or a pile that was brushed in circles. */
final class LearnedNap extends LearnedTerm implements RollingResistance, Varying {

  LearnedNap(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedNap withParameters(double... values) {
    return new LearnedNap(family(), values);
  }

  @Override
  public double factor(BallMotion motion) {
    double speed = motion.groundSpeed();
    if (speed == 0) {
      return 1;
    }
    double along = valueAt(0, motion) * motion.vx() + valueAt(1, motion) * motion.vy();
    // A carpet never pushes, however far an estimator strays.
    return Math.max(0, 1 + along / speed);
  }

  @Override
  public double longestStep(BallMotion motion) {
    return longestStepFor(motion);
  }
}
