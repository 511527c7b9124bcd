package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.ExternalForce;

/** A learned force along x and y of the field on a ball on the carpet: a floor that is not even, air that does not move everywhere alike. */
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
