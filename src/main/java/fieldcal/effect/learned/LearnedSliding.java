package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.SlidingResistance;
import fieldcal.effect.MotionEffect.Varying;

/**
 * Friction of a sliding ball that depends on the direction of the slip, as a part of the model's: more against it, and some across it. Physics engines whose friction is a box or a pyramid have it (ODE, MuJoCo, Bullet's multibodies: each axis of the field
 * has its own limit, so between the axes the friction is up to √2 times as large and the path bends).
 */
final class LearnedSliding extends LearnedTerm implements SlidingResistance, Varying {
  /** A slower slip ends within 8 ms, so its turn does not limit the step, m/s. */
  private static final double SLOWEST = 0.1;

  LearnedSliding(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedSliding withParameters(double... values) {
    return new LearnedSliding(family(), values);
  }

  /** Friction across the slip turns it, the faster the less is left of it. */
  @Override
  public double longestStep(BallMotion motion) {
    if (!motion.isSliding()) {
      return Double.POSITIVE_INFINITY;
    }
    double aside = Variable.SLIP.rate(motion) * Math.abs(slidingAcross(motion));
    return family().basis().resolution(0) * Math.max(SLOWEST, motion.slip()) / aside;
  }

  @Override
  public double slidingFactor(BallMotion motion) {
    // A carpet never pushes, however far an estimator strays.
    return Math.max(0, 1 + valueAt(0, motion.slipHeading(), 0));
  }

  @Override
  public double slidingAcross(BallMotion motion) {
    return valueAt(1, motion.slipHeading(), 0);
  }
}
