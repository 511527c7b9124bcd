package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.Bounce;
import java.util.List;

/**
 * Vertical restitution e_z·(1 − slope·(|v_z| − 1.5 m/s)) of every impact, v_z right before it; kept between 0 and 0.99. So e_z is the value at 1.5 m/s.
 *
 * @param slope relative loss of e_z per speed of the impact, s/m; negative = hard bounces lose less, 0 = none
 */
public record SpeedDependentRestitution(double slope) implements Bounce {
  private static final String ID = "speed_dependent_restitution";

  /** Impact speed at which e_z is the model's, m/s; fixed by the design. */
  private static final double REFERENCE_SPEED = 1.5;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public SpeedDependentRestitution {
    EffectParameters.requireFinite(ID, slope);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "Hard bounces lose more height than soft ones.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "slope",
            "s/m",
            slope,
            0.02,
            -0.3,
            0.3,
            true,
            "0.47 at the first, 0.38 at later bounces in matches of 2026 is about -0.1; design"));
  }

  @Override
  public SpeedDependentRestitution withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new SpeedDependentRestitution(v[0]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.chips();
  }

  @Override
  public boolean isAbsent() {
    return slope == 0;
  }

  @Override
  public double dampingZ(BallMotion motion, double dampingZ) {
    return dampingZ * (1 - slope * (Math.abs(motion.vz()) - REFERENCE_SPEED));
  }
}
