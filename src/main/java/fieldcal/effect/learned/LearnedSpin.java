package fieldcal.effect.learned;

import fieldcal.effect.BallKnowledge;
import fieldcal.effect.MotionEffect.SpinAtKick;
import java.util.List;

/** A learned spin right after the kick, as a fraction of rolling spin, over the kick's speed or direction. */
final class LearnedSpin extends LearnedTerm implements SpinAtKick {

  LearnedSpin(LearnedFamily family, double[] coefficients) {
    super(family, coefficients);
  }

  @Override
  public LearnedSpin withParameters(double... values) {
    return new LearnedSpin(family(), values);
  }

  @Override
  public List<BallKnowledge> ballKnowledge() {
    return List.of(BallKnowledge.mechanicalSwitch());
  }

  @Override
  public void addSpin(double vx, double vy, double vz, double[] spin) {
    double u = of(family().variables().get(0), vx, vy);
    double v = family().variables().size() > 1 ? of(family().variables().get(1), vx, vy) : 0;
    double fraction = valueAt(0, u, v);
    spin[0] += fraction * vx;
    spin[1] += fraction * vy;
  }

  private static double of(Variable variable, double vx, double vy) {
    return variable == Variable.HEADING ? Math.atan2(vy, vx) : Math.sqrt(vx * vx + vy * vy);
  }
}
