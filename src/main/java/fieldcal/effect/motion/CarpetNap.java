package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.RollingResistance;
import java.util.List;

/**
 * Nap of the carpet: rolling deceleration × (1 + amplitude·cos(θ − direction)), θ = direction of travel in the field frame. Sliding does not change.
 *
 * @param amplitude relative change of the rolling deceleration (–), 0 = none
 * @param direction direction of travel in which rolling brakes most (with a positive amplitude), rad, 0 = along x, counter-clockwise
 */
public record CarpetNap(double amplitude, double direction) implements RollingResistance {
  private static final String ID = "carpet_nap";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CarpetNap {
    EffectParameters.requireFinite(ID, amplitude, direction);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The carpet has a direction: balls roll farther with the nap than against it.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "amplitude",
            "",
            amplitude,
            0.05,
            -0.9,
            0.9,
            true,
            "up to 0.08 in matches of 2026; design, what real matches look like"),
        EffectParameters.direction("direction", direction));
  }

  @Override
  public CarpetNap withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new CarpetNap(v[0], v[1]);
  }

  @Override
  public boolean isAbsent() {
    return amplitude == 0;
  }

  @Override
  public double factor(BallMotion motion) {
    double speed = motion.groundSpeed();
    double along = motion.vx() * Math.cos(direction) + motion.vy() * Math.sin(direction);
    return speed == 0 ? 1 : 1 + amplitude * along / speed;
  }
}
