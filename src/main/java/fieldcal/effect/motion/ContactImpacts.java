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
 *   <li>it undoes the part 1 + reversed of the slip, Δv = −(1 + reversed)·β/(1+β)·u, at most |Δv| = friction·J; its torque turns the ball, Δs = −Δv/β;
 *   <li>it takes the part {@code loss} of v and of s;
 *   <li>during the part of the impulse in which the contact point no longer slips, rolling resistance takes rolling·J·(1 − |Δv|/(friction·J)) of v and of s, along s, at most all of s.
 * </ol>
 *
 * <p>The spin stays until the next impact, so that later impacts take less. While the contact point slides, an impact takes speed and gives spin as sliding on the carpet does, whose kSwitch knows what resistance there is. A rolling ball shows a resistance of |accRoll|/g, about 0.03
 * (physics engines that let their rolling friction act in impacts, ODE and Bullet, lose that). e_z is the model's, with what other effects make of it.
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
    double sliding = stopSlip(arrival.slip(), friction * impulse, inertiaFactor, after);
    for (int i = 0; i < after.length; i++) {
      after[i] *= 1 - loss;
    }
    resistRolling(rolling * impulse * (1 - sliding), after);
  }

  /**
   * Lets friction act on the slip.
   *
   * @param most how much speed friction takes when it acts during the whole impact, m/s
   * @return the part of the impact that the contact point slides, 0 to 1
   */
  private double stopSlip(double slip, double most, double inertiaFactor, double[] after) {
    if (slip <= 0) {
      return 0;
    }
    double wanted = (1 + reversed) * inertiaFactor / (1 + inertiaFactor) * slip;
    double change = Math.min(wanted, most);
    double dx = change / slip * (after[0] - after[2]);
    double dy = change / slip * (after[1] - after[3]);
    after[0] -= dx;
    after[1] -= dy;
    after[2] += dx / inertiaFactor;
    after[3] += dy / inertiaFactor;
    return most > 0 ? change / most : 0;
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
