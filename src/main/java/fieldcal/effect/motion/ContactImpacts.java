package fieldcal.effect.motion;

import fieldcal.ball.ChipModel;
import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.ImpactLaw;
import java.util.List;

/**
 * Impacts that follow the contact law instead of the two horizontal dampings (R. L. Garwin, Am. J. Phys. 37, 1969; R. Cross, Am. J. Phys. 70, 2002). With the spin s as a velocity, the slip of the contact point u = v − s, and the normal impulse over the mass J = (1 + e_z)·|v_z|, an
 * impact does, in this order:
 *
 * <ol>
 *   <li>while the contact point slides, during the part j of J, friction takes friction·j of v along u, and friction and rolling resistance turn the ball: Δs = (friction·j·û − (1+β)·rolling·j·ŝ)/β, of which the component along u is taken. The contact point slides until the part
 *       1 + reversed of u is undone, or to the end of the impact;
 *   <li>the impact takes the part {@code loss} of v and of s;
 *   <li>while the ball grips, during the rest of J, rolling resistance takes rolling·(J − j) of v and of s, along s, at most all of s.
 * </ol>
 *
 * <p>The spin stays until the next impact, so that later impacts take less. The resistance is a torque that acts as long as ball and carpet touch: (1+β)·rolling times the normal force and the radius, so that a ball which rolls is braked by rolling·g. It is therefore |accRoll|/g, about 0.03, where the resistance
 * of impacts is that of rolling, as in physics engines that let their rolling friction act in contacts (ODE, Bullet). Then it brakes the spin while the ball slides on the carpet, too, which lowers kSwitch as some backspin does (see {@link KickSpin#imitatedBy}). e_z is the model's, with what other effects make of it.
 *
 * @param reversed part of the slip that an impact reverses (–): 0 = the contact point comes to rest, −1 = no grip, 1 = ideally elastic
 * @param friction coefficient of friction of ball and carpet in an impact (–), 0 = the fixed dampings hold
 * @param loss part of the speed over the ground and of the spin that each impact takes in addition (–)
 * @param rolling coefficient of rolling resistance in an impact (–)
 * @param lowestHopMm a ball whose next hop would be lower than that stays down, mm: what slip is left then ends by sliding on the carpet
 */
public record ContactImpacts(
    double reversed, double friction, double loss, double rolling, double lowestHopMm)
    implements ImpactLaw {
  private static final String ID = "contact_impacts";

  /** Least friction of a law that is there: 0 would be the fixed dampings, another law, to which no slope leads. Chosen: a fifteenth of what sliding on the carpet shows. */
  private static final double LEAST_FRICTION = 0.02;

  private static final double LEAGUE_LOWEST_HOP_MM = 1000 * ChipModel.MIN_HOP_HEIGHT;

  private static final double ENGINE_LOWEST_HOP_MM = 1000 * ChipModel.ENGINE_MIN_HOP_HEIGHT;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public ContactImpacts {
    EffectParameters.requireFinite(ID, reversed, friction, loss, rolling, lowestHopMm);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "Bounces follow the spin that the ball has gathered, not two fixed dampings.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "reversed",
            "",
            reversed,
            0.1,
            -1,
            1,
            true,
            "0 for a ball that grips, small negative values on soft carpets; Cross 2002"),
        new Parameter(
            "friction",
            "",
            friction,
            0.1,
            isAbsent() ? 0 : LEAST_FRICTION,
            2,
            true,
            "sliding on the carpet shows 0.3 to 0.35; impacts press fibres down and grip more"),
        new Parameter(
            "loss", "", loss, 0.02, -0.1, 0.3, true, "a few hundredths on carpets; chosen wide"),
        new Parameter(
            "rolling", "", rolling, 0.02, -0.05, 0.3, true, "0.03 of a ball that rolls; wide"),
        new Parameter(
            "lowest_hop_mm",
            "mm",
            lowestHopMm,
            1,
            0.1,
            100,
            false,
            "the league's models say 10 mm, physics engines about 0.5 mm"));
  }

  @Override
  public ContactImpacts withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 5);
    return new ContactImpacts(v[0], v[1], v[2], v[3], v[4]);
  }

  @Override
  public boolean isAbsent() {
    return friction == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("reversed", "friction", "loss", "rolling");
  }

  @Override
  public List<String> dependsOn() {
    return List.of("spin");
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return arena.chips();
  }

  /** A ball that grips with little loss, a softer grip, and one that friction limits; with hops as low as the league's models have them. */
  @Override
  public List<Effect> starts() {
    return startsWith(LEAGUE_LOWEST_HOP_MM);
  }

  /** The same with hops as low as physics engines have them. */
  @Override
  public List<Effect> forms() {
    return startsWith(ENGINE_LOWEST_HOP_MM);
  }

  private static List<Effect> startsWith(double lowest) {
    return List.of(
        new ContactImpacts(-0.1, 1, 0.02, 0, lowest),
        new ContactImpacts(-0.25, 0.5, 0, 0, lowest),
        new ContactImpacts(0, 0.25, 0, 0, lowest));
  }

  /** How low the hops are is a number of the law, which a search chooses, not what it acts on. */
  @Override
  public String subject() {
    return "";
  }

  @Override
  public double lowestHop() {
    return lowestHopMm / 1000;
  }

  @Override
  public void impact(BallMotion arrival, double dampingZ, double inertiaFactor, double[] after) {
    double impulse = (1 + dampingZ) * Math.abs(arrival.vz());
    double gripping = stopSlip(arrival.slip(), impulse, inertiaFactor, after);
    for (int i = 0; i < after.length; i++) {
      after[i] *= 1 - loss;
    }
    resistRolling(rolling * gripping, after);
  }

  /**
   * Lets friction and rolling resistance act on a ball whose contact point slides. The resistance opposes the spin along the slip: it helps friction to stop a ball that turns backward, and hinders it then.
   *
   * @param impulse of the impact over the mass, m/s
   * @return the part of the impulse that is left when the contact point no longer slides, m/s
   */
  private double stopSlip(double slip, double impulse, double inertiaFactor, double[] after) {
    if (slip <= 0) {
      return impulse;
    }
    double x = (after[0] - after[2]) / slip;
    double y = (after[1] - after[3]) / slip;
    double perVelocity = (1 + inertiaFactor) / inertiaFactor;
    // A ball that slides without turning takes no more resistance than friction overcomes.
    double most = friction / (1 + inertiaFactor);
    double resistance = Math.max(-most, Math.min(most, rolling));
    double undone = (1 + reversed) * slip;
    double backward = 0;
    double spin = after[2] * x + after[3] * y;
    if (spin < 0) {
      double gain = friction / inertiaFactor + perVelocity * resistance;
      double stop = perVelocity * (friction + resistance);
      backward = Math.min(impulse, Math.min(-spin / gain, undone / stop));
      undone -= stop * backward;
    }
    double stop = perVelocity * (friction - resistance);
    double forward = Math.min(impulse - backward, undone / stop);
    double speed = friction * (backward + forward);
    double turned = speed / inertiaFactor + perVelocity * resistance * (backward - forward);
    after[0] -= speed * x;
    after[1] -= speed * y;
    after[2] += turned * x;
    after[3] += turned * y;
    return impulse - backward - forward;
  }

  /** Takes that much speed, m/s, of ball and surface along the spin, at most all of the spin. */
  private static void resistRolling(double most, double[] after) {
    double spin = Math.hypot(after[2], after[3]);
    if (spin == 0) {
      return;
    }
    double perSpin = Math.min(most, spin) / spin;
    double dx = perSpin * after[2];
    double dy = perSpin * after[3];
    after[0] -= dx;
    after[1] -= dy;
    after[2] -= dx;
    after[3] -= dy;
  }
}
