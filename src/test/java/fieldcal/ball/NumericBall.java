package fieldcal.ball;

import java.util.function.UnaryOperator;

/**
 * A ball integrated in small Runge-Kutta steps from forces and torques, for comparison with the closed forms; shares nothing
 * with them. The state is x, y, z, vx, vy, vz and the angular velocity's horizontal components.
 */
final class NumericBall {
  private static final double RADIUS = 0.0215;

  /** Below this a step is over: events (slip gone, ball at rest, impact) are located to this precision, s. */
  private static final double EVENT = 1e-13;

  private enum Mode {
    SLIDING,
    ROLLING,
    FLYING,
    RESTING
  }

  private final double step;
  private double[] state;
  private double time;
  private Mode mode;

  // Flat: Coulomb friction and inertia. Chip: restitution.
  private double friction;
  private double inertiaFactor;
  private final double accRoll;
  private ChipModel chip;
  private int impacts;

  private NumericBall(double time, double[] state, Mode mode, double accRoll, double step) {
    this.time = time;
    this.state = state;
    this.mode = mode;
    this.accRoll = accRoll;
    this.step = step;
  }

  static NumericBall flat(
      FlatModel model, double t, double[] kick, double spinX, double spinY, double step) {
    // A ball that turns about (−sy, sx)/r rolls with (sx, sy).
    double[] state = {kick[0], kick[1], 0, kick[2], kick[3], 0, -spinY / RADIUS, spinX / RADIUS};
    NumericBall ball = new NumericBall(t, state, Mode.SLIDING, model.accRoll(), step);
    ball.friction = -model.accSlide();
    ball.inertiaFactor = model.inertiaFactor();
    return ball;
  }

  static NumericBall chip(ChipModel model, double t, double[] kick, double step) {
    double[] state = {kick[0], kick[1], 0, kick[2], kick[3], kick[4], 0, 0};
    NumericBall ball = new NumericBall(t, state, Mode.FLYING, model.accRoll(), step);
    ball.chip = model;
    return ball;
  }

  /** Moves on to a time and answers the state there. */
  double[] advanceTo(double t) {
    while (t - time > EVENT && mode != Mode.RESTING) {
      double h = Math.min(step, t - time);
      while (endsWithin(h) && h > EVENT) {
        h *= 0.5;
      }
      if (endsWithin(h)) {
        changeMode();
      } else {
        state = rungeKutta(h);
        time += h;
      }
    }
    return state;
  }

  /**
   * Whether the present mode ends within a step. Friction turns around at that moment, so no stage of the step may lie behind
   * it: the plain Euler step, which the last stages try, must be free of it, too.
   */
  private boolean endsWithin(double h) {
    return isOver(rungeKutta(h)) || mode != Mode.FLYING && isOver(sum(state, derivative(state), h));
  }

  private double[] rungeKutta(double h) {
    UnaryOperator<double[]> f = this::derivative;
    double[] k1 = f.apply(state);
    double[] k2 = f.apply(sum(state, k1, h / 2));
    double[] k3 = f.apply(sum(state, k2, h / 2));
    double[] k4 = f.apply(sum(state, k3, h));
    double[] next = state.clone();
    for (int i = 0; i < next.length; i++) {
      next[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return next;
  }

  private static double[] sum(double[] a, double[] b, double factor) {
    double[] result = a.clone();
    for (int i = 0; i < result.length; i++) {
      result[i] += factor * b[i];
    }
    return result;
  }

  private double[] derivative(double[] s) {
    double[] d = {s[3], s[4], s[5], 0, 0, 0, 0, 0};
    switch (mode) {
      case SLIDING -> {
        double[] slip = slip(s);
        double size = Math.hypot(slip[0], slip[1]);
        d[3] = -friction * slip[0] / size;
        d[4] = -friction * slip[1] / size;
        // Torque of the friction at the contact: (0, 0, −r) × F, over β·m·r².
        d[6] = d[4] / (inertiaFactor * RADIUS);
        d[7] = -d[3] / (inertiaFactor * RADIUS);
      }
      case ROLLING -> {
        double speed = Math.hypot(s[3], s[4]);
        d[3] = accRoll * s[3] / speed;
        d[4] = accRoll * s[4] / speed;
      }
      case FLYING -> d[5] = -9.81;
      default -> throw new IllegalStateException("a resting ball is not integrated");
    }
    return d;
  }

  /** Velocity of the contact: v + ω × (0, 0, −r). */
  private static double[] slip(double[] s) {
    return new double[] {s[3] - RADIUS * s[7], s[4] + RADIUS * s[6]};
  }

  private boolean isOver(double[] next) {
    return switch (mode) {
      case SLIDING -> {
        double[] before = slip(state);
        double[] after = slip(next);
        yield !(before[0] * after[0] + before[1] * after[1] > 0);
      }
      case ROLLING -> !(state[3] * next[3] + state[4] * next[4] > 0);
      case FLYING -> next[2] < 0;
      default -> false;
    };
  }

  private void changeMode() {
    switch (mode) {
      case SLIDING -> mode = Mode.ROLLING;
      case ROLLING -> mode = Mode.RESTING;
      default -> bounce();
    }
  }

  private void bounce() {
    double damping = impacts == 0 ? chip.dampingXyFirstHop() : chip.dampingXyOtherHops();
    impacts++;
    state[2] = 0;
    state[3] *= damping;
    state[4] *= damping;
    state[5] *= -chip.dampingZ();
    if (state[5] * state[5] / (2 * 9.81) < 0.01) {
      state[5] = 0;
      mode = Mode.ROLLING;
    }
  }
}
