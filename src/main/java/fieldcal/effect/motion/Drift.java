package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.RollingResistance;
import java.util.List;

/**
 * Rolling deceleration × (1 + percent/100 · session time/600 s), at every instant of the path: accRoll is the value at the beginning of the session, not at its middle.
 *
 * @param percentPer10Min change of the rolling deceleration, % of its first value per 10 minutes of session; positive = brakes more and more, 0 = none
 */
public record Drift(double percentPer10Min) implements RollingResistance {
  private static final String ID = "drift";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public Drift {
    EffectParameters.requireFinite(ID, percentPer10Min);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The carpet changes over the session: balls roll a longer or a shorter way as time goes"
        + " by.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "percent_per_10min",
            "%",
            percentPer10Min,
            5,
            -100,
            100,
            true,
            "chosen wide; a fresh carpet changes by some percent a day"));
  }

  @Override
  public Drift withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 1);
    return new Drift(v[0]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.kickTimes().length > 1;
  }

  @Override
  public boolean isAbsent() {
    return percentPer10Min == 0;
  }

  @Override
  public boolean changesWithTime() {
    return true;
  }

  @Override
  public double factor(BallMotion motion) {
    return 1 + percentPer10Min / 100 * motion.sessionTime() / 600;
  }
}
