package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect.AirFlow;
import fieldcal.effect.MotionEffect.Varying;
import fieldcal.effect.motion.AirDrag;
import java.util.List;

/** Learned velocities of air that moves differently from place to place, such as a draught from one door. */
final class LearnedAir extends LearnedTerm implements AirFlow, Varying {

  LearnedAir(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedAir withParameters(double... values) {
    return new LearnedAir(family(), values);
  }

  @Override
  public List<Effect> companions() {
    return List.of(AirDrag.USUAL);
  }

  @Override
  public Flow flow() {
    return (motion, air) -> {
      air[0] += valueAt(0, motion);
      air[1] += valueAt(1, motion);
    };
  }

  @Override
  public double longestStep(BallMotion motion) {
    return longestStepFor(motion);
  }
}
