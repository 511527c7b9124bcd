package fieldcal.effect.motion;

import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.SpinAtKick;
import java.util.List;

/**
 * Spin right after the kick about the rolling axis, r·ω = fraction·v with the horizontal velocity v, of chips too. Where both kinds of kicks were recorded, chips have a mean of their own: another device kicks them, from below.
 *
 * @param fraction spin about the rolling axis in units of rolling spin v/r (–): 1 rolls, negative = backspin; the mean where it differs from kick to kick
 * @param chips what chips, kicks with a vertical speed above zero, have beyond that, in the same unit; the same in all chips
 * @param apart whether the recording distinguishes chips from flat kicks; otherwise {@code chips} is not estimated
 */
public record KickSpin(double fraction, double chips, boolean apart) implements SpinAtKick {
  private static final String ID = "kick_spin";
  private static final String SOURCE = "chosen: plungers and dribblers give some tenths";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public KickSpin {
    EffectParameters.requireFinite(ID, fraction, chips);
  }

  /**
   * The same spin for all kicks.
   *
   * @param fraction in units of rolling spin (–)
   */
  public KickSpin(double fraction) {
    this(fraction, 0, false);
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
        new Parameter("fraction", "", fraction, 0.1, -2, 2, true, SOURCE),
        new Parameter("chips", "", chips, 0.1, -2, 2, apart, SOURCE));
  }

  @Override
  public KickSpin withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new KickSpin(v[0], v[1], apart || v[1] != 0);
  }

  @Override
  public List<String> magnitudes() {
    return apart ? List.of("fraction", "chips") : List.of("fraction");
  }

  @Override
  public List<Effect> candidates(Arena arena) {
    return List.of(new KickSpin(0, 0, arena.flats() && arena.chips()));
  }

  @Override
  public String subject() {
    return "";
  }

  @Override
  public boolean differsFromKickToKick() {
    return true;
  }

  @Override
  public boolean isAbsent() {
    return fraction == 0 && chips == 0;
  }

  @Override
  public List<BallKnowledge> ballKnowledge() {
    return List.of(BallKnowledge.mechanicalSwitch());
  }

  /**
   * A rolling resistance that brakes the spin while the ball slides makes it roll from a lower speed on: with the torque that brakes a rolling ball by accRoll and with r = accRoll/accSlide, kSwitch = 1/(1 + β)·(1 − (1 + β)·r)/(1 − r), as with a spin of −r/(1 − r). Chips, which bounce, have none of that; where they are not told apart, nothing distinguishes them.
   * {@inheritDoc}
   */
  @Override
  public double[] imitatedBy(FlatModel ball) {
    double left = ball.accSlide() - ball.accRoll();
    double imitated = left < 0 ? -ball.accRoll() / left : 0;
    return apart ? new double[] {imitated, -imitated} : new double[] {imitated};
  }

  @Override
  public void addSpin(double vx, double vy, double vz, double[] spin) {
    double own = vz > 0 ? fraction + chips : fraction;
    spin[0] += own * vx;
    spin[1] += own * vy;
  }
}
