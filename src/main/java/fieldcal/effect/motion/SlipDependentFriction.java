package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.SlidingResistance;
import java.util.List;

/**
 * Sliding friction × (1 + slope·(slip − 2 m/s)), at least × 0.05, slip = speed |v − s| of the ball's lowest point over the carpet: accSlide is the value at a slip of 2 m/s.
 *
 * @param slope growth of the sliding friction with the slip, s/m; 0 = none
 */
public record SlipDependentFriction(double slope) implements SlidingResistance {
  private static final String ID = "slip_dependent_friction";

  /** Slip at which the friction is the model's, m/s; fixed by the design. */
  private static final double REFERENCE_SLIP = 2;

  /** Friction never pushes; chosen small. */
  private static final double LEAST_FACTOR = 0.05;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public SlipDependentFriction {
    EffectParameters.requireFinite(ID, slope);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The friction of a sliding ball depends on how fast it slips over the carpet.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "slope",
            "s/m",
            slope,
            0.02,
            -0.45,
            1,
            true,
            "chosen: below −0.2 the friction of a kick of 6.5 m/s, above 0.5 that of a ball that"
                + " hardly slips is at its least"));
  }

  @Override
  public SlipDependentFriction withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new SlipDependentFriction(v[0]);
  }

  @Override
  public boolean isAbsent() {
    return slope == 0;
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.flats();
  }

  @Override
  public double slidingFactor(BallMotion motion) {
    return Math.max(LEAST_FACTOR, 1 + slope * (motion.slip() - REFERENCE_SLIP));
  }
}
