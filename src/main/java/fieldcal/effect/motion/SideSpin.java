package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.SpinAtKick;
import java.util.List;

/**
 * Spin right after the kick about the horizontal direction of travel, not about the vertical: ω = fraction·v/r with the horizontal velocity v of the kick, of chips too. Friction uses it up while the ball slides. Field frame.
 *
 * @param fraction spin about the direction of travel in units of v/r (–), the mean where it differs from kick to kick; positive = right-handed about it, which curves the path to the right
 */
public record SideSpin(double fraction) implements SpinAtKick {
  private static final String ID = "side_spin";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public SideSpin {
    EffectParameters.requireFinite(ID, fraction);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The kicker gives the ball spin about its direction of travel, so its path curves while"
        + " it slides.";
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
            "chosen: off-centre kicks give some tenths"));
  }

  @Override
  public SideSpin withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new SideSpin(v[0]);
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
  public void addSpin(double vx, double vy, double vz, double[] spin) {
    // ω = fraction/r·v, so s = r·(ω_y, −ω_x).
    spin[0] += fraction * vy;
    spin[1] -= fraction * vx;
  }
}
