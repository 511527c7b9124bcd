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

  /** What a ball that was kicked without spin would not have: velocity and spin as {@link BallMotion#spinX}, x before y, m/s. */
  private final double[] spun = new double[4];

  Impacts(MotionEffects effects) {
    this.effects = effects;
  }

  /** A kick that gives the ball a spin, as {@link BallMotion#spinX}, m/s. */
  void begin(double spinX, double spinY) {
    spun[2] = spinX;
    spun[3] = spinY;
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
      lose(Math.max(0, dampingXy), grip(model), state);
    }
    state[5] = -dampingZ * state[5];
    if (turn != 0) {
      turn(3, turn, state);
      turn(6, turn, state);
      turn(0, turn, spun);
      turn(2, turn, spun);
    }
  }

  /** The part of the slip that an impact takes from the velocity: the first damping says it of a ball without spin, all of whose velocity is slip. No more than an ideally elastic contact does. */
  private double grip(ChipModel model) {
    double beta = effects.ball.inertiaFactor();
    double elastic = 2 * beta / (1 + beta);
    return Math.max(0, Math.min(elastic, 1 - model.dampingXyFirstHop()));
  }

  /** Turns a horizontal vector. */
  private static void turn(int at, double angle, double[] vectors) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    double x = vectors[at];
    vectors[at] = c * x - s * vectors[at + 1];
    vectors[at + 1] = s * x + c * vectors[at + 1];
  }

  /**
   * The ball stays down, and what slip the impacts have left is taken at once: hops that are too low to be counted and the carpet do so within milliseconds. Where the fixed losses hold, only spin of the kick leaves any.
   */
  void end(double[] state) {
    double share = effects.ball.inertiaFactor() / (1 + effects.ball.inertiaFactor());
    boolean law = effects.impacts != null;
    state[3] -= share * (law ? state[3] - state[6] : spun[0] - spun[2]);
    state[4] -= share * (law ? state[4] - state[7] : spun[1] - spun[3]);
  }

  /**
   * The fixed loss of an impact, and the contact law for what the kick's spin adds to it (see {@link ExtendedTrajectory}): the perturbation is taken out, and put back changed.
   *
   * @param dampingXy what is left of the velocity along the ground
   * @param grip part of the perturbation's slip that the velocity loses
   * @param state is changed
   */
  private void lose(double dampingXy, double grip, double[] state) {
    addSpun(-1, state);
    lose(dampingXy, state);
    for (int axis = 0; axis < 2; axis++) {
      double lost = grip * (spun[axis] - spun[2 + axis]);
      spun[axis] -= lost;
      spun[2 + axis] += lost / effects.ball.inertiaFactor();
    }
    addSpun(1, state);
  }

  private void addSpun(double sign, double[] state) {
    state[3] += sign * spun[0];
    state[4] += sign * spun[1];
    state[6] += sign * spun[2];
    state[7] += sign * spun[3];
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
