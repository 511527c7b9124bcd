package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.FrictionOfKick;
import java.util.Arrays;
import java.util.List;

/**
 * Another ball from some time on: rolling deceleration × (1 + roll), sliding friction × (1 + slide). Balls are changed between kicks, so the time of the kick decides, for the whole of its path.
 *
 * @param roll relative change of the rolling deceleration (–), 0 = none
 * @param slide relative change of the sliding friction (–), 0 = none
 * @param at from when on, s since the beginning of the session
 */
public record BallChanged(double roll, double slide, double at) implements FrictionOfKick {
  private static final String ID = "ball_changed";

  /** How many instants a search begins with; chosen. */
  private static final int INSTANTS = 8;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public BallChanged {
    EffectParameters.requireFinite(ID, roll, slide, at);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "From some time on another ball is in play, which rolls or slides differently.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "roll", "", roll, 0.05, -0.9, 2, true, "chosen wide; balls differ by some percent"),
        new Parameter("slide", "", slide, 0.05, -0.9, 2, true, "as roll"),
        EffectParameters.instant(at));
  }

  @Override
  public BallChanged withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 3);
    return new BallChanged(v[0], v[1], v[2]);
  }

  @Override
  public boolean isAbsent() {
    return roll == 0 && slide == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("roll", "slide");
  }

  @Override
  public List<List<String>> choices() {
    return List.of(List.of("roll"), List.of("slide"), List.of("roll", "slide"));
  }

  @Override
  public boolean changesWithTime() {
    return true;
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.kickTimes().length > 1;
  }

  @Override
  public List<Effect> candidates(Arena arena) {
    return Arrays.stream(arena.instantsBetweenKicks(INSTANTS))
        .<Effect>mapToObj(instant -> new BallChanged(0, 0, instant))
        .toList();
  }

  @Override
  public List<String> places() {
    return List.of("at");
  }

  @Override
  public double rolling(double kickTime) {
    return kickTime >= at ? 1 + roll : 1;
  }

  @Override
  public double sliding(double kickTime) {
    return kickTime >= at ? 1 + slide : 1;
  }
}
