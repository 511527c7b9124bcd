package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallBody;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.ExternalForce;
import java.util.List;

/**
 * Lift of a spinning ball, a = ½ρπr²·cl·(rω×v)/m, in all directions of ω. Where ω is across v, this is the usual ½ρπr²·C_L·|v|²/m along ω×v with C_L = cl·r|ω|/|v|.
 * v is relative to the field, not to the air; ω is constant in flight. On the carpet it presses the ball down (topspin) or relieves it.
 *
 * @param cl lift coefficient per unit of r|ω|/|v| (–), positive = backspin lifts, 0 = no lift
 */
public record Magnus(double cl) implements ExternalForce {
  private static final String ID = "magnus";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public Magnus {
    EffectParameters.requireFinite(ID, cl);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "A spinning ball is pushed sideways, up or down by the air.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "cl", "", cl, 0.1, -2, 2, true, "spheres about 0.3 to 1 at small spin; chosen wide"));
  }

  @Override
  public boolean actsThroughSpin() {
    return true;
  }

  @Override
  public Magnus withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new Magnus(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return cl == 0;
  }

  @Override
  public void addAcceleration(BallMotion motion, double[] acceleration) {
    // ω×v with r·ω = (−s_y, s_x, 0): the spin about the vertical does not follow from a kick.
    double lift = BallBody.AIR_FACTOR * cl;
    double sx = motion.spinX();
    double sy = motion.spinY();
    acceleration[0] += lift * sx * motion.vz();
    acceleration[1] += lift * sy * motion.vz();
    acceleration[2] -= lift * (sx * motion.vx() + sy * motion.vy());
  }
}
