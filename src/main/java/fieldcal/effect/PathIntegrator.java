package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Gravity;
import fieldcal.ball.Phase;
import fieldcal.effect.MotionEffect.Bounce;
import fieldcal.effect.MotionEffect.FrictionZone;
import fieldcal.effect.MotionEffect.SpinAtKick;

/**
 * Integrates the path of one kick: classical Runge–Kutta steps of fourth order that end at the events (end of slip, impact, edge of a zone, stop).
 * Where no effect makes an acceleration vary, a phase is one exact step. Used once.
 */
final class PathIntegrator {
  static final int BY_RULE = -1;
  static final int NO_BOUNCES = 0;

  /** Longest step under varying acceleration, s. Forces vary over seconds, so the error per step is (0.1/10)^5: nothing. */
  private static final double MAX_STEP = 0.1;

  /** Largest turn of the direction of friction within a step, rad; the error of the path stays below a micrometre. */
  private static final double MAX_TURN = 0.1;

  /** Below this speed (m/s) a direction no longer turns: the rest of the path is shorter than a micrometre. */
  private static final double SLOW = 5e-4;

  /** Largest share of the time to a phase's end that a step covers while the direction of friction still turns. */
  private static final double MOST = 0.5;

  /** Below this ratio of the turning to the braking acceleration a direction does not turn. */
  private static final double STRAIGHT = 1e-12;

  private static final double TINY = 1e-12;

  private static final int MAX_STEPS = 20_000;

  private final MotionEffects effects;
  private final BallForces forces;
  private final int flightsGiven;
  private final double longest;
  private final Path path;
  private final boolean[] inside;
  private final double[] state = new double[BallForces.SIZE];
  private final double[] trial = new double[BallForces.SIZE];
  private final double[] at = new double[BallForces.SIZE];
  private final double[] k1 = new double[BallForces.SIZE];
  private final double[] k2 = new double[BallForces.SIZE];
  private final double[] k3 = new double[BallForces.SIZE];
  private final double[] k4 = new double[BallForces.SIZE];
  private final double[] acc0 = new double[3];
  private final double[] acc1 = new double[3];
  private double time;
  private double slipShare;
  private int flights;

  PathIntegrator(MotionEffects effects, double sessionStart, double accRoll, int flights) {
    this.effects = effects;
    forces = new BallForces(effects, sessionStart, accRoll);
    flightsGiven = flights;
    boolean varies = effects.forces.length + effects.resistances.length + effects.zones.length > 0;
    longest = varies ? MAX_STEP : ExtendedTrajectory.MAX_DURATION;
    path = new Path(varies ? 96 : 8);
    inside = new boolean[effects.zones.length];
  }

  Path path() {
    return path;
  }

  int flights() {
    return flights;
  }

  void slideFrom(FlatModel model, double t0, double x, double y, double vx, double vy) {
    start(t0, x, y, vx, vy, 0);
    forces.setSliding(model.accSlide(), model.kSwitch());
    slipShare = 1 - model.kSwitch();
    slide(t0 + ExtendedTrajectory.MAX_DURATION);
    roll(t0 + ExtendedTrajectory.MAX_DURATION);
  }

  void flyFrom(ChipModel model, double t0, double x, double y, double vx, double vy, double vz) {
    start(t0, x, y, vx, vy, flightsGiven == 0 ? 0 : vz);
    double limit = Math.sqrt(2 * Gravity.ACCELERATION * ChipModel.MIN_HOP_HEIGHT);
    boolean flies = flightsGiven != 0;
    while (flies) {
      fly();
      flights++;
      bounce(model);
      flies =
          flightsGiven == BY_RULE
              ? state[5] >= limit && flights < ChipModel.MAX_FLIGHTS
              : flights < flightsGiven;
    }
    state[5] = 0;
    roll(t0 + ExtendedTrajectory.MAX_DURATION);
  }

  private void start(double t0, double x, double y, double vx, double vy, double vz) {
    time = t0;
    state[0] = x;
    state[1] = y;
    state[3] = vx;
    state[4] = vy;
    state[5] = vz;
    double[] spin = new double[2];
    for (SpinAtKick effect : effects.spins) {
      effect.addSpin(vx, vy, spin);
    }
    state[6] = spin[0];
    state[7] = spin[1];
    for (int i = 0; i < inside.length; i++) {
      inside[i] = effects.zones[i].contains(x, y);
    }
    forces.setInside(inside);
  }

  private void slide(double until) {
    for (int n = 0; n < MAX_STEPS && time < until; n++) {
      double slipX = state[3] - state[6];
      double slipY = state[4] - state[7];
      double slip = Math.sqrt(slipX * slipX + slipY * slipY);
      if (slip < TINY) {
        return;
      }
      forces.derivative(Phase.SLIDING, time, state, k1);
      double rate = (slipX * (k1[3] - k1[6]) + slipY * (k1[4] - k1[7])) / slip;
      double across = Math.abs(slipX * (k1[4] - k1[7]) - slipY * (k1[3] - k1[6])) / slip;
      double step = limited(slip, across);
      boolean ends = slip + rate * step <= 0;
      boolean turns = across > STRAIGHT * -rate || effects.forces.length > 0;
      if (turns && slip > SLOW && step * -rate > MOST * slip) {
        // The direction turns fastest near the end, and external forces act fully only until then.
        step = MOST * slip / -rate;
        ends = false;
      }
      if (ends) {
        step = -slip / rate;
        forces.freeze(slipX / slip, slipY / slip);
      }
      boolean whole = advance(Phase.SLIDING, step);
      forces.unfreeze();
      if (ends && whole) {
        // What slip is left, by rounding or a force that changed meanwhile, friction takes at once.
        state[3] -= slipShare * (state[3] - state[6]);
        state[4] -= slipShare * (state[4] - state[7]);
        return;
      }
    }
  }

  private void roll(double until) {
    state[6] = state[3];
    state[7] = state[4];
    // A ball may have flown into a zone or out of it.
    for (int i = 0; i < inside.length; i++) {
      inside[i] = flights > 0 ? effects.zones[i].contains(state[0], state[1]) : inside[i];
    }
    forces.setInside(inside);
    for (int n = 0; n < MAX_STEPS && time < until; n++) {
      double speed = Math.sqrt(state[3] * state[3] + state[4] * state[4]);
      if (speed < TINY) {
        if (forces.holds(time, state)) {
          return;
        }
        continue;
      }
      forces.derivative(Phase.ROLLING, time, state, k1);
      double rate = (state[3] * k1[3] + state[4] * k1[4]) / speed;
      double across = Math.abs(state[3] * k1[4] - state[4] * k1[3]) / speed;
      double step = Math.min(limited(speed, across), until - time);
      boolean ends = speed + rate * step <= 0;
      if (across > STRAIGHT * -rate && speed > SLOW && step * -rate > MOST * speed) {
        // The direction turns fastest near the end.
        step = MOST * speed / -rate;
        ends = false;
      }
      if (ends) {
        step = -speed / rate;
        forces.freeze(state[3] / speed, state[4] / speed);
      }
      boolean whole = advance(Phase.ROLLING, step);
      forces.unfreeze();
      if (ends && whole) {
        state[3] = 0;
        state[4] = 0;
        state[6] = 0;
        state[7] = 0;
      }
    }
  }

  /** A step during which a direction does not turn too far. */
  private double limited(double size, double across) {
    return across * longest > MAX_TURN * size && size > SLOW ? MAX_TURN * size / across : longest;
  }

  private void fly() {
    double end = time + ExtendedTrajectory.MAX_DURATION;
    while (time < end) {
      forces.derivative(Phase.FLYING, time, state, k1);
      double g = -k1[5];
      double root = state[5] * state[5] + 2 * g * state[2];
      double landing = g > 0 ? (state[5] + Math.sqrt(root)) / g : Double.POSITIVE_INFINITY;
      boolean varies = effects.forces.length > 0;
      double step = Math.min(landing, varies ? MAX_STEP : end - time);
      rungeKutta(Phase.FLYING, step);
      boolean lands = step == landing || trial[2] < 0;
      for (int i = 0; i < 8 && lands && Math.abs(trial[2]) > TINY; i++) {
        step -= trial[2] / trial[5];
        if (step > MAX_STEP && varies) {
          // The landing lies beyond what a step may cover: go on and look again.
          step = MAX_STEP;
          lands = false;
        }
        rungeKutta(Phase.FLYING, step);
      }
      commit(Phase.FLYING, step);
      if (lands) {
        state[2] = 0;
        return;
      }
    }
  }

  private void bounce(ChipModel model) {
    double dampingXy = flights == 1 ? model.dampingXyFirstHop() : model.dampingXyOtherHops();
    double dampingZ = model.dampingZ();
    BallMotion arrival = forces.motion(time, state, true);
    for (Bounce effect : effects.bounces) {
      dampingZ = effect.dampingZ(arrival, dampingZ);
      dampingXy = effect.dampingXy(arrival, dampingXy);
    }
    dampingZ = Math.max(0, Math.min(0.99, dampingZ));
    dampingXy = Math.max(0, dampingXy);
    double lostX = (1 - dampingXy) * state[3];
    double lostY = (1 - dampingXy) * state[4];
    double slipX = state[3] - state[6];
    double slipY = state[4] - state[7];
    state[3] -= lostX;
    state[4] -= lostY;
    state[6] += lostX / effects.ball.inertiaFactor();
    state[7] += lostY / effects.ball.inertiaFactor();
    if ((state[3] - state[6]) * slipX + (state[4] - state[7]) * slipY < 0) {
      // Friction can stop the slip, not turn it round.
      state[6] = state[3];
      state[7] = state[4];
    }
    state[5] = -dampingZ * state[5];
  }

  /** One step on the carpet, which ends at the edge of a zone when there is one; tells whether it was made whole. */
  private boolean advance(Phase phase, double step) {
    rungeKutta(phase, step);
    for (int i = 0; i < inside.length; i++) {
      double share = effects.zones[i].otherSide(inside[i], state[0], state[1], trial[0], trial[1]);
      if (share <= 1) {
        return crossEdges(phase, step);
      }
    }
    commit(phase, step);
    return true;
  }

  /** The earliest of the edges that the tried step crosses. */
  private boolean crossEdges(Phase phase, double step) {
    double first = step;
    int crossed = -1;
    for (int i = 0; i < inside.length; i++) {
      double edge = edge(effects.zones[i], inside[i], step);
      if (edge <= first) {
        first = edge;
        crossed = i;
      }
    }
    if (first < step) {
      rungeKutta(phase, first);
    }
    commit(phase, first);
    if (crossed >= 0) {
      inside[crossed] = !inside[crossed];
      forces.setInside(inside);
    }
    return first == step && crossed < 0;
  }

  /** Time into the tried step at which an edge is met, by bisection on the parabola through it; infinite when none is. */
  private double edge(FrictionZone zone, boolean within, double step) {
    double share = zone.otherSide(within, state[0], state[1], trial[0], trial[1]);
    if (!(share <= 1)) {
      return Double.POSITIVE_INFINITY;
    }
    double before = 0;
    double after = timeAtShare(share, step);
    while (after - before > TINY) {
      double middle = 0.5 * (before + after);
      double x = state[0] + middle * (state[3] + 0.5 * k1[3] * middle);
      double y = state[1] + middle * (state[4] + 0.5 * k1[4] * middle);
      if (zone.contains(x, y) == within) {
        before = middle;
      } else {
        after = middle;
      }
    }
    return Math.min(after, step);
  }

  /** When a decelerated ball has made a share of a step's way. */
  private double timeAtShare(double share, double step) {
    double dx = trial[0] - state[0];
    double dy = trial[1] - state[1];
    double length = Math.sqrt(dx * dx + dy * dy);
    double v = (state[3] * dx + state[4] * dy) / length;
    double a = 0.5 * (k1[3] * dx + k1[4] * dy) / length;
    double low = 0;
    double high = step;
    while (high - low > TINY) {
      double middle = 0.5 * (low + high);
      if (middle * (v + a * middle) < share * length) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
  }

  /** The state after a step, in {@code trial}; {@code k1} is the rate at its begin. */
  private void rungeKutta(Phase phase, double step) {
    move(k1, 0.5 * step);
    forces.derivative(phase, time + 0.5 * step, at, k2);
    move(k2, 0.5 * step);
    forces.derivative(phase, time + 0.5 * step, at, k3);
    move(k3, step);
    forces.derivative(phase, time + step, at, k4);
    for (int i = 0; i < BallForces.SIZE; i++) {
      trial[i] = state[i] + step / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    }
  }

  private void move(double[] rate, double by) {
    for (int i = 0; i < BallForces.SIZE; i++) {
      at[i] = state[i] + by * rate[i];
    }
  }

  private void commit(Phase phase, double step) {
    if (step > 0) {
      acc0[0] = k1[3];
      acc0[1] = k1[4];
      acc0[2] = k1[5];
      forces.derivative(phase, time + step, trial, k2);
      acc1[0] = k2[3];
      acc1[1] = k2[4];
      acc1[2] = k2[5];
      path.add(phase, time, step, state, acc0, trial, acc1);
    }
    System.arraycopy(trial, 0, state, 0, state.length);
    time += step;
  }
}
