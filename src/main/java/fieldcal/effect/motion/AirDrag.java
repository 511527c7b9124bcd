package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallBody;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.ExternalForce;
import java.util.List;

/**
 * Air drag, f = −½ρ·cd·πr²·|v|·v/m (Rayleigh's drag equation), v relative to the air. A sliding or flying ball is braked by all of it, a rolling one by f/(1 + β) = 5/7·f, since it must be turned, too.
 *
 * @param cd drag coefficient (–), 0 = no air
 */
public record AirDrag(double cd) implements ExternalForce {
  /** That of a golf ball at SSL speeds; design, what real matches look like. */
  public static final AirDrag USUAL = new AirDrag(0.45);

  private static final String ID = "air_drag";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public AirDrag {
    EffectParameters.requireFinite(ID, cd);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The air brakes the ball, on the carpet and in flight.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "cd",
            "",
            cd,
            0.1,
            0,
            2,
            true,
            "golf ball at SSL speeds about 0.45; design, what real matches look like"));
  }

  @Override
  public AirDrag withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new AirDrag(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return cd == 0;
  }

  @Override
  public void addAcceleration(BallMotion motion, double[] acceleration) {
    double x = motion.vx() - motion.airX();
    double y = motion.vy() - motion.airY();
    double z = motion.vz();
    double perVelocity = -BallBody.AIR_FACTOR * cd * Math.sqrt(x * x + y * y + z * z);
    acceleration[0] += perVelocity * x;
    acceleration[1] += perVelocity * y;
    acceleration[2] += perVelocity * z;
  }
}
