package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.Bounce;

/** A learned change of an impact: its vertical or tangential restitution, or its turn. */
final class LearnedBounce extends LearnedTerm implements Bounce {

  LearnedBounce(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedBounce withParameters(double... values) {
    return new LearnedBounce(family(), values);
  }

  @Override
  public double dampingZ(BallMotion motion, double dampingZ) {
    return dampingZ + change(Quantity.VERTICAL_RESTITUTION, motion);
  }

  @Override
  public double dampingXy(BallMotion motion, double dampingXy) {
    return dampingXy + change(Quantity.TANGENTIAL_RESTITUTION, motion);
  }

  @Override
  public double turn(BallMotion motion) {
    return change(Quantity.TURN, motion);
  }

  private double change(Quantity quantity, BallMotion motion) {
    return family().quantity() == quantity ? valueAt(0, motion) : 0;
  }
}
