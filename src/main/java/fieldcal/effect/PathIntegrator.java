package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Gravity;
import fieldcal.ball.Phase;
import fieldcal.effect.MotionEffect.SpinAtKick;

/**
 * Integrates the path of one kick: classical Runge–Kutta steps of fourth order that end at the events (end of slip, impact, edge of a zone, stop). On the carpet
 * the length of a step follows from how fast the acceleration changes, so that results change smoothly with the parameters: no step is tried and rejected. Where
 * no effect makes an acceleration vary, a phase is one exact step. Used once.
 */
final class PathIntegrator {
  static final int BY_RULE = -1;
  static final int NO_BOUNCES = 0;

  /** Longest step on the carpet under varying acceleration, s; keeps the interpolation between its ends below a hundredth of a micrometre. */
  static final double MAX_STEP = 0.6;

  /** Longest step in flight under varying acceleration, s: gravity turns the velocity, and with it drag and lift, within tenths of a second. A golf ball kicked at 6.5 m/s then lands within 2 µm of where steps of half a millisecond lead, within 15 µm where lift of 1.8 m/s² acts, too. */
  private static final double MAX_FLIGHT_STEP = 0.15;

  /** Error of the velocity that a step may make, m/s: over the ten seconds that a ball rolls it grows to a micrometre. */
  private static final double VELOCITY_ERROR = 5e-9;

  /** Error of the place that a step may make where the direction of friction turns, m. */
  private static final double PLACE_ERROR = 5e-8;

  /** Where friction turns the ball aside by less than this until a phase's end (m), its direction is taken to be constant. */
  private static final double STRAIGHT = 1e-7;

  /** Largest share of the time to a phase's end that a step covers while the direction of friction still turns. */
  private static final double LARGEST_SHARE_OF_PHASE = 0.5;

  /** Error constant of the method, for an acceleration that changes with time and velocity alike. */
  private static final double ORDER_5 = 120;

  /** A look ahead of this length shows how fast the acceleration changes at the beginning of a phase, s. */
  private static final double LOOK_AHEAD = 0.05;

  /** Velocity (m/s) below which a phase has ended, and height (m) at which a ball has landed. */
  private static final double END = 1e-7;

  private static final double LANDED = 1e-12;

  private static final double TINY = 1e-12;

  private static final int MAX_STEPS = 20_000;

  private final MotionEffects effects;
  private final BallForces forces;
  private final Impacts impacts;
  private final int flightsGiven;
  private final boolean varies;

  /** After this time nothing is asked of the ball on the carpet, s. */
  private final double until;

  private final Path path;
  private final boolean[] inside;
  private final boolean[] beyond;
  private final double[] crossing = new double[2];
  private final double[] state = new double[BallForces.SIZE];
  private final double[] trial = new double[BallForces.SIZE];
  private final double[] at = new double[BallForces.SIZE];
  private double[] k1 = new double[BallForces.SIZE];
  private final double[] k2 = new double[BallForces.SIZE];
  private final double[] k3 = new double[BallForces.SIZE];
  private final double[] k4 = new double[BallForces.SIZE];
  private double[] end = new double[BallForces.SIZE];
  private double time;

  /** Whether {@code k1} is the rate at the present state, left over from the end of the last step. */
  private boolean ready;

  /** How fast the acceleration along the way changes, m/s³. */
  private double variation;

  private double slipShare;
  private int flights;

  PathIntegrator(
      MotionEffects effects,
      double sessionStart,
      double accRoll,
      double kickTime,
      int flights,
      double until) {
    this.effects = effects;
    this.until = until;
    forces = new BallForces(effects, sessionStart, accRoll, kickTime);
    impacts = new Impacts(effects);
    flightsGiven = flights;
    varies = effects.forces.length + effects.resistances.length + effects.slidings.length > 0;
    path = new Path(varies ? 24 : 8);
    inside = new boolean[effects.zones.length];
    beyond = new boolean[effects.lines.length];
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

  void flyFrom(
      ChipModel model,
      FlatModel flat,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz) {
    start(t0, x, y, vx, vy, flightsGiven == 0 ? 0 : vz);
    double lowest = effects.impacts == null ? model.lowestHop() : effects.impacts.lowestHop();
    double limit = Math.sqrt(2 * Gravity.ACCELERATION * lowest);
    boolean flies = flightsGiven != 0;
    while (flies) {
      fly();
      flights++;
      forces.setHop(flights);
      impacts.bounce(model, flights == 1, forces.motion(time, state, true), state);
      flies =
          flightsGiven == BY_RULE
              ? state[5] >= limit && flights < ChipModel.MAX_FLIGHTS
              : flights < flightsGiven;
    }
    state[5] = 0;
    if (flights > 0) {
      land(flat, t0 + ExtendedTrajectory.MAX_DURATION);
    }
    roll(t0 + ExtendedTrajectory.MAX_DURATION);
  }

  /** A ball may have flown into a zone or out of it, or over a line. Where a law of impacts holds, it slides before it rolls. */
  private void land(FlatModel flat, double limit) {
    findSides();
    for (int i = 0; i < inside.length; i++) {
      inside[i] = effects.zones[i].contains(state[0], state[1]);
    }
    forces.setInside(inside);
    if (effects.impacts != null) {
      slipShare = effects.ball.inertiaFactor() / (1 + effects.ball.inertiaFactor());
      forces.setSliding(flat.accSlide(), 1 - slipShare);
      slide(limit);
    }
  }

  private void start(double t0, double x, double y, double vx, double vy, double vz) {
    time = t0;
    forces.setKick(t0, x, y);
    state[0] = x;
    state[1] = y;
    state[3] = vx;
    state[4] = vy;
    state[5] = vz;
    double[] spin = new double[2];
    for (SpinAtKick effect : effects.spins) {
      effect.addSpin(vx, vy, vz, spin);
    }
    state[6] = spin[0];
    state[7] = spin[1];
    impacts.begin(spin[0], spin[1]);
    for (int i = 0; i < inside.length; i++) {
      inside[i] = effects.zones[i].contains(x, y);
    }
    findSides();
    forces.setInside(inside);
  }

  private void findSides() {
    for (int i = 0; i < beyond.length; i++) {
      beyond[i] = effects.isBeyond(i, state[0], state[1]);
    }
  }

  private void slide(double limit) {
    ready = false;
    for (int n = 0; n < MAX_STEPS && goesOn(limit); n++) {
      double slipX = state[3] - state[6];
      double slipY = state[4] - state[7];
      double slip = Math.sqrt(slipX * slipX + slipY * slipY);
      if (slip < TINY) {
        return;
      }
      if (brake(Phase.SLIDING, slip, slipX / slip, slipY / slip, limit - time)) {
        // What slip is left, by rounding or a force that changed meanwhile, friction takes at once.
        state[3] -= slipShare * (state[3] - state[6]);
        state[4] -= slipShare * (state[4] - state[7]);
        return;
      }
    }
  }

  /** If the rest of the path is not wanted, it ends between two steps, so that up to there it equals the whole path. */
  private boolean goesOn(double limit) {
    return time < limit && time < until;
  }

  private void roll(double limit) {
    state[6] = state[3];
    state[7] = state[4];
    ready = false;
    for (int n = 0; n < MAX_STEPS && goesOn(limit); n++) {
      double speed = Math.sqrt(state[3] * state[3] + state[4] * state[4]);
      if (speed < TINY) {
        if (forces.holds(time, state)) {
          return;
        }
        ready = false;
        continue;
      }
      if (brake(Phase.ROLLING, speed, state[3] / speed, state[4] / speed, limit - time)) {
        state[3] = 0;
        state[4] = 0;
        state[6] = 0;
        state[7] = 0;
      }
    }
  }

  /**
   * A step on the carpet, during which a velocity shrinks: that of the slip or, rolling, the ball's.
   *
   * @param size of that velocity
   * @param x its direction
   * @param y its direction
   * @return whether it has shrunk to nothing
   */
  private boolean brake(Phase phase, double size, double x, double y, double longest) {
    double slides = phase == Phase.SLIDING ? 1 : 0;
    if (!ready) {
      forces.derivative(phase, time, state, k1);
      lookAhead(phase, slides, size, x, y);
    }
    double rate = along(k1, slides, x, y);
    double across = Math.abs(along(k1, slides, -y, x));
    double scale = size / Math.sqrt(rate * rate + across * across);
    double aside = across == 0 ? 0 : across * scale * scale;
    boolean straight = aside < STRAIGHT && rate < 0;
    double step = Math.min(longest, smoothFor(rate));
    step = Math.min(step, forces.longestStep(phase, time, state));
    if (straight) {
      forces.freeze(x, y);
      step = Math.min(step, -size / rate);
    } else if (across > TINY * rate) {
      // The direction turns fastest near the end.
      double share = Math.pow(PLACE_ERROR * ORDER_5 / aside, 0.2);
      step = Math.min(step, Math.min(LARGEST_SHARE_OF_PHASE, share) * scale);
    }
    attempt(phase, step);
    boolean ends = false;
    double left = along(trial, slides, x, y);
    if (straight && (left <= 0 || step == -size / rate)) {
      ends = true;
      for (int i = 0; i < 8 && Math.abs(left) > END && ends; i++) {
        double slope = along(end, slides, x, y);
        ends = slope < 0 && step - left / slope > 0;
        if (ends) {
          step -= left / slope;
          attempt(phase, step);
          left = along(trial, slides, x, y);
        }
      }
    }
    boolean whole = keep(phase, step);
    forces.unfreeze();
    variation = step > 0 ? Math.abs(along(k1, slides, x, y) - rate) / step : 0;
    return ends && whole;
  }

  /** The part of a velocity or its rate along a direction: the slip's or the ball's. */
  private static double along(double[] s, double slides, double x, double y) {
    return (s[3] - slides * s[6]) * x + (s[4] - slides * s[7]) * y;
  }

  private void lookAhead(Phase phase, double slides, double size, double x, double y) {
    variation = 0;
    double rate = along(k1, slides, x, y);
    if (varies && rate != 0) {
      double ahead = Math.min(LOOK_AHEAD, 0.25 * size / Math.abs(rate));
      move(k1, ahead);
      forces.derivative(phase, time + ahead, at, k2);
      variation = Math.abs(along(k2, slides, x, y) - rate) / ahead;
    }
  }

  /** A step during which the acceleration along the way changes so little that the method's error stays below its limit. */
  private double smoothFor(double rate) {
    if (!varies) {
      return ExtendedTrajectory.MAX_DURATION;
    }
    double perTime = variation / Math.abs(rate);
    double fifth = VELOCITY_ERROR * ORDER_5 / (variation * perTime * perTime * perTime);
    return fifth < MAX_STEP ? Math.min(MAX_STEP, Math.pow(fifth, 0.2)) : MAX_STEP;
  }

  private void fly() {
    double limit = time + ExtendedTrajectory.MAX_DURATION;
    boolean pulled = effects.forces.length > 0;
    ready = false;
    while (time < limit) {
      if (!ready) {
        forces.derivative(Phase.FLYING, time, state, k1);
      }
      double g = -k1[5];
      double root = state[5] * state[5] + 2 * g * state[2];
      double landing = g > 0 ? (state[5] + Math.sqrt(root)) / g : Double.POSITIVE_INFINITY;
      double step = Math.min(landing, pulled ? MAX_FLIGHT_STEP : limit - time);
      rungeKutta(Phase.FLYING, step);
      boolean lands = step == landing || trial[2] < 0;
      for (int i = 0; i < 8 && lands && Math.abs(trial[2]) > LANDED; i++) {
        step -= trial[2] / trial[5];
        if (step > MAX_FLIGHT_STEP && pulled) {
          // The landing lies beyond what a step may cover: go on and look again.
          step = MAX_FLIGHT_STEP;
          lands = false;
        }
        rungeKutta(Phase.FLYING, step);
      }
      forces.derivative(Phase.FLYING, time + step, trial, end);
      add(Phase.FLYING, step);
      accept(step);
      if (lands) {
        state[2] = 0;
        return;
      }
    }
  }

  /** The step just tried becomes the path's next piece, up to the edge of a zone when there is one; returns whether the whole step was made. */
  private boolean keep(Phase phase, double step) {
    if (!(step > 0)) {
      accept(step);
      return true;
    }
    add(phase, step);
    double first = step;
    int crossed = -1;
    for (int i = 0; i < inside.length; i++) {
      double edge = ZoneEdge.timeInto(path, effects.zones[i], inside[i], step);
      if (edge <= first) {
        first = edge;
        crossed = i;
      }
    }
    int line = -1;
    for (int i = 0; i < beyond.length; i++) {
      double edge = ZoneEdge.timeOver(path, effects, i, beyond[i], step);
      if (edge <= first) {
        first = edge;
        line = i;
        crossed = -1;
      }
    }
    if (first < step) {
      path.dropLast();
      attempt(phase, first);
      add(phase, first);
    }
    accept(first);
    if (crossed >= 0) {
      inside[crossed] = !inside[crossed];
      forces.setInside(inside);
      ready = false;
    }
    if (line >= 0) {
      cross(phase, line);
    }
    return first == step && crossed < 0 && line < 0;
  }

  private void cross(Phase phase, int line) {
    beyond[line] = !beyond[line];
    crossing[0] = state[3];
    crossing[1] = state[4];
    effects.lines[line].cross(crossing);
    state[3] = crossing[0];
    state[4] = crossing[1];
    if (phase == Phase.ROLLING) {
      state[6] = state[3];
      state[7] = state[4];
    }
    ready = false;
  }

  /** The state after a step, in {@code trial}, and the rate there, in {@code end}. */
  private void attempt(Phase phase, double step) {
    rungeKutta(phase, step);
    forces.derivative(phase, time + step, trial, end);
  }

  /** The state after a step, in {@code trial}; {@code k1} is the rate at its beginning. */
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

  private void add(Phase phase, double step) {
    if (step > 0) {
      path.add(phase, time, step, state, k1, trial, end);
    }
  }

  /** Goes on from where the step just tried ended, with the rate there. */
  private void accept(double step) {
    System.arraycopy(trial, 0, state, 0, state.length);
    double[] used = k1;
    k1 = end;
    end = used;
    ready = true;
    time += step;
  }
}
