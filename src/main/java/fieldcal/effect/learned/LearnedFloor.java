package fieldcal.effect.learned;

import fieldcal.ball.Gravity;
import fieldcal.effect.BallMotion;
import fieldcal.effect.MotionEffect.ExternalForce;
import fieldcal.effect.MotionEffect.Varying;

/** A learned height of the floor: mounds and troughs pull a ball on the carpet downhill. A ball that crosses one has its speed again behind it, which no force that depends on the place alone grants. */
final class LearnedFloor extends LearnedTerm implements ExternalForce, Varying {
  /** Acceleration for each mm of height per m of way, m/s². */
  private static final double DOWNHILL = -1e-3 * Gravity.ACCELERATION;

  private final Surface.Relief height;

  LearnedFloor(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
    height = ((Surface) family.basis()).curve(coefficients(), 0);
  }

  @Override
  public LearnedFloor withParameters(double... values) {
    return new LearnedFloor(family(), values);
  }

  @Override
  public void addAcceleration(BallMotion motion, double[] acceleration) {
    field().add(motion, acceleration);
  }

  @Override
  public Field field() {
    return (motion, acceleration) -> {
      if (!motion.isFlying()) {
        height.addGradient(motion.x(), motion.y(), DOWNHILL, acceleration);
      }
    };
  }

  @Override
  public double longestStep(BallMotion motion) {
    return longestStepFor(motion);
  }
}
