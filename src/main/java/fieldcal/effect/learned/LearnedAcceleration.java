package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.PathAcceleration;

/** A learned acceleration on the carpet, along or across the path. */
final class LearnedAcceleration extends LearnedTerm implements PathAcceleration {
  private final boolean turns;
  private final boolean slidingOnly;

  LearnedAcceleration(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
    turns = family.quantity() == Quantity.ACCELERATION_ACROSS;
    slidingOnly = dependsOn(Variable.SLIP);
  }

  @Override
  public LearnedAcceleration withParameters(double... values) {
    return new LearnedAcceleration(family(), values);
  }

  @Override
  public double along(BallMotion motion) {
    return turns || isAway(motion) ? 0 : valueAt(0, motion);
  }

  @Override
  public double across(BallMotion motion) {
    return !turns || isAway(motion) ? 0 : valueAt(0, motion);
  }

  @Override
  public double longestStep(BallMotion motion) {
    return isAway(motion) ? Double.POSITIVE_INFINITY : longestStepFor(motion);
  }

  private boolean isAway(BallMotion motion) {
    return slidingOnly && !motion.isSliding();
  }
}
