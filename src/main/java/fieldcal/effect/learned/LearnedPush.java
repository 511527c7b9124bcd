package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.ExternalForce;

/** A learned force along x and y of the field on a ball on the carpet: an uneven floor, or air that moves differently from place to place. */
final class LearnedPush extends LearnedTerm implements ExternalForce {

  LearnedPush(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedPush withParameters(double... values) {
    return new LearnedPush(family(), values);
  }

  @Override
  public void addAcceleration(BallMotion motion, double[] acceleration) {
    if (!motion.isFlying()) {
      acceleration[0] += valueAt(0, motion);
      acceleration[1] += valueAt(1, motion);
    }
  }
}
