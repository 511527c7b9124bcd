package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.SpinAtKick;
import java.util.List;

/**
 * Spin right after the kick about the rolling axis.
 *
 * @param fraction spin about the rolling axis in units of rolling spin v/r (–): 1 rolls, negative = backspin
 */
public record KickSpin(double fraction) implements SpinAtKick {
  private static final String ID = "kick_spin";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public KickSpin {
    EffectParameters.requireFinite(ID, fraction);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The kicker gives the ball topspin or backspin.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "fraction",
            "",
            fraction,
            0.1,
            -2,
            2,
            true,
            "chosen: plungers and dribblers give some tenths"));
  }

  @Override
  public KickSpin withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new KickSpin(v[0]);
  }

  @Override
  public boolean differsFromKickToKick() {
    return true;
  }

  @Override
  public boolean isAbsent() {
    return fraction == 0;
  }

  @Override
  public List<BallKnowledge> ballKnowledge() {
    return List.of(BallKnowledge.mechanicalSwitch());
  }

  @Override
  public void addSpin(double vx, double vy, double[] spin) {
    spin[0] += fraction * vx;
    spin[1] += fraction * vy;
  }
}
