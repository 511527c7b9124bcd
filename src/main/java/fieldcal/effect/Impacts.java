package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.effect.MotionEffect.Bounce;

/**
 * The impacts of one path: what they do to velocity and spin (see {@link ExtendedTrajectory}). State: x, y, z, vx, vy, vz, spin x, spin y. Used once.
 */
final class Impacts {
  private static final double TINY = 1e-12;

  /** A ball that keeps more of its vertical speed would bounce for ever. */
  private static final double MOST_DAMPING_Z = 0.99;

  private final MotionEffects effects;

  /** The part of the spin that comes from the kick and bounces have not used up, as {@link BallMotion#spinX}, m/s. */
  private double kickSpinX;

  private double kickSpinY;

  /** The part of the velocity that this spin gave the ball at bounces, m/s. */
  private double spunX;

  private double spunY;

  Impacts(MotionEffects effects) {
    this.effects = effects;
  }

  /** A kick that gives the ball a spin, as {@link BallMotion#spinX}, m/s. */
  void begin(double spinX, double spinY) {
    kickSpinX = spinX;
    kickSpinY = spinY;
  }

  /** One impact; changes the state. */
  void bounce(ChipModel model, boolean first, BallMotion arrival, double[] state) {
    double dampingXy = first ? model.dampingXyFirstHop() : model.dampingXyOtherHops();
    double dampingZ = model.dampingZ();
    double turn = 0;
    for (Bounce effect : effects.bounces) {
      turn += effect.turn(arrival);
      dampingZ = effect.dampingZ(arrival, dampingZ);
      dampingXy = effect.dampingXy(arrival, dampingXy);
    }
    dampingZ = Math.max(0, Math.min(MOST_DAMPING_Z, dampingZ));
    if (effects.impacts != null) {
      double[] after = {state[3], state[4], state[6], state[7]};
      effects.impacts.impact(arrival, dampingZ, effects.ball.inertiaFactor(), after);
      state[3] = after[0];
      state[4] = after[1];
      state[6] = after[2];
      state[7] = after[3];
    } else {
      lose(Math.max(0, dampingXy), Math.max(0, 1 - model.dampingXyFirstHop()), state);
    }
    state[5] = -dampingZ * state[5];
    if (turn != 0) {
      turn(3, turn, state);
      turn(6, turn, state);
    }
  }

  /** Turns a horizontal vector of the state. */
  private static void turn(int at, double angle, double[] state) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    double x = state[at];
    state[at] = c * x - s * state[at + 1];
    state[at + 1] = s * x + c * state[at + 1];
  }

  /**
   * The fixed loss of an impact, and what the kick's spin adds to it (see {@link ExtendedTrajectory}): the perturbation is taken out, and put back changed.
   *
   * @param dampingXy share of the velocity along the ground that is left (–)
   * @param grip change of velocity per slip in the contact law (–)
   * @param state is changed
   */
  private void lose(double dampingXy, double grip, double[] state) {
    state[3] -= spunX;
    state[4] -= spunY;
    state[6] -= kickSpinX;
    state[7] -= kickSpinY;
    lose(dampingXy, state);
    spunX = dampingXy * spunX + grip * kickSpinX;
    spunY = dampingXy * spunY + grip * kickSpinY;
    double left = Math.max(0, 1 - grip / effects.ball.inertiaFactor());
    kickSpinX *= left;
    kickSpinY *= left;
    state[3] += spunX;
    state[4] += spunY;
    state[6] += kickSpinX;
    state[7] += kickSpinY;
  }

  private void lose(double dampingXy, double[] state) {
    double lostX = (1 - dampingXy) * state[3];
    double lostY = (1 - dampingXy) * state[4];
    double slipX = state[3] - state[6];
    double slipY = state[4] - state[7];
    state[3] -= lostX;
    state[4] -= lostY;
    state[6] += lostX / effects.ball.inertiaFactor();
    state[7] += lostY / effects.ball.inertiaFactor();
    boolean turned = (state[3] - state[6]) * slipX + (state[4] - state[7]) * slipY < 0;
    if (turned || slipX * slipX + slipY * slipY < TINY * TINY) {
      // Friction can stop the slip, not turn it round, and does nothing to a ball that rolls.
      state[6] = state[3];
      state[7] = state[4];
    }
  }
}
