package fieldcal.simulation.physics;

import fieldcal.simulation.physics.ImpactLaw.Contact;
import fieldcal.simulation.physics.ImpactLaw.FixedLoss;
import java.util.Arrays;

/**
 * Moves a ball: fourth-order Runge–Kutta of at most 1 ms, with impacts, the end of slipping, the stop, seams and the edges of a worn region located inside the step. Not thread-safe.
 */
public final class BallIntegrator {
  /** Longest step, s: at 7 m/s and all effects the error of a kick stays far below a micrometre. */
  public static final double MAX_STEP = 1e-3;

  private static final double TIME_RESOLUTION = 1e-12;

  /** A slower slip is due to rounding, m/s. */
  private static final double ROLLING_SLIP = 1e-9;

  /** Steps of an impact's impulse while the contact point slides: only the direction of the resistance changes meanwhile. */
  private static final int IMPACT_STEPS = 64;

  private final BallPhysics physics;
  private final Forces forces;
  private final double[] trial = new double[9];
  private final double[] derivative = new double[9];
  private final RungeKutta rungeKutta;

  /**
   * An integrator for one set of laws.
   *
   * @param physics the laws
   */
  public BallIntegrator(BallPhysics physics) {
    this.physics = physics;
    forces = new Forces(physics);
    rungeKutta = new RungeKutta(forces);
  }

  /**
   * Moves the ball.
   *
   * @param ball the ball, changed
   * @param from session time now, s
   * @param to session time to reach, s
   * @param trace receives what happens
   */
  public void advance(BallBody ball, double from, double to, BallTrace trace) {
    double time = from;
    while (to - time > TIME_RESOLUTION) {
      double step = Math.min(MAX_STEP, to - time);
      forces.enterStep(ball, time);
      double x = ball.x();
      double y = ball.y();
      boolean flew = ball.phase() == MotionPhase.FLYING;
      double taken =
          switch (ball.phase()) {
            case RESTING -> rest(ball, to - time);
            case FLYING -> fly(ball, time, step, trace);
            case SLIDING -> slide(ball, time, step, trace);
            case ROLLING -> roll(ball, time, step, trace);
          };
      time += taken;
      if (flew) {
        double kept = Math.exp(-forces.spinDecay() * taken);
        ball.givenSpin[0] *= kept;
        ball.givenSpin[1] *= kept;
      } else {
        ball.addPath(Math.hypot(ball.x() - x, ball.y() - y));
      }
      trace.node(time, ball);
    }
  }

  private double rest(BallBody ball, double duration) {
    // A slope that rolling resistance cannot hold sets a resting ball in motion.
    forces.derivative(0, ball.state, derivative);
    if (!forces.holds()) {
      ball.setPhase(MotionPhase.ROLLING);
      return 0;
    }
    return duration;
  }

  private double fly(BallBody ball, double time, double step, BallTrace trace) {
    double[] state = ball.state;
    rungeKutta.step(state, step, trial);
    if (trial[2] > 0 || trial[5] >= 0) {
      commit(state);
      return step;
    }
    double used = Math.max(0, Math.min(step, step + trial[2] / -trial[5]));
    for (int i = 0; i < 20; i++) {
      rungeKutta.step(state, used, trial);
      double correction = trial[2] / trial[5];
      used -= correction;
      if (Math.abs(correction) < TIME_RESOLUTION) {
        break;
      }
    }
    rungeKutta.step(state, used, trial);
    commit(state);
    state[2] = 0;
    trace.node(time + used, ball);
    impact(ball, time + used, trace);
    return used;
  }

  private double slide(BallBody ball, double time, double step, BallTrace trace) {
    double[] state = ball.state;
    double slipX = forces.slipX(state);
    double slipY = forces.slipY(state);
    double slip = Math.hypot(slipX, slipY);
    forces.derivative(0, state, derivative);
    double rate =
        slip == 0
            ? 0
            : (slipX * forces.slipX(derivative) + slipY * forces.slipY(derivative)) / slip;
    boolean ends = slip + rate * step <= 0 || slip < 1e-12;
    double used = step;
    if (ends) {
      used = slip < 1e-12 ? 0 : Math.min(step, -slip / rate);
      // The direction of a vanishing slip is noise: keep the one it had.
      forces.freezeDirection(slipX / slip, slipY / slip);
    }
    double taken = 0;
    if (used > 0) {
      taken = stepWithinRegion(state, used);
      commit(state);
      meetSeam(ball, time + taken, trace);
    }
    if (ends && taken == used) {
      settleIntoRolling(ball);
      trace.event(event(BallEvent.Kind.SLIDE_TO_ROLL, time + taken, ball));
    }
    return taken;
  }

  private double roll(BallBody ball, double time, double step, BallTrace trace) {
    double[] state = ball.state;
    double speed = Math.hypot(state[3], state[4]);
    forces.derivative(0, state, derivative);
    double rate = speed == 0 ? 0 : (state[3] * derivative[3] + state[4] * derivative[4]) / speed;
    boolean ends = speed > 0 && speed + rate * step <= 0;
    double used = step;
    if (ends) {
      used = Math.min(step, -speed / rate);
      forces.freezeDirection(state[3] / speed, state[4] / speed);
    }
    double taken = stepWithinRegion(state, used);
    commit(state);
    forces.makeRolling(state);
    meetSeam(ball, time + taken, trace);
    if (ends && taken == used) {
      Arrays.fill(state, 3, 9, 0);
      if (forces.holds()) {
        ball.setPhase(MotionPhase.RESTING);
        trace.event(event(BallEvent.Kind.STOP, time + taken, ball));
      }
    }
    return taken;
  }

  private void meetSeam(BallBody ball, double time, BallTrace trace) {
    double[] s = ball.state;
    Seam seam = forces.crossed(s);
    if (seam == null) {
      return;
    }
    // The change of velocity lies between two nodes at the same time, as at an impact.
    trace.node(time, ball);
    double vx = s[3];
    double vy = s[4];
    seam.cross(s);
    if (ball.phase() == MotionPhase.ROLLING) {
      forces.makeRolling(s);
    }
    trace.event(
        new BallEvent(BallEvent.Kind.SEAM, time, s[0], s[1], vx, vy, s[5], s[3], s[4], s[5]));
  }

  /** A step that ends at the edge of the worn region or at a seam when it would cross it; returns its length. */
  private double stepWithinRegion(double[] state, double step) {
    rungeKutta.step(state, step, trial);
    if (forces.sameRegion(trial)) {
      return step;
    }
    double inside = 0;
    double outside = step;
    while (outside - inside > TIME_RESOLUTION) {
      double middle = 0.5 * (inside + outside);
      rungeKutta.step(state, middle, trial);
      if (forces.sameRegion(trial)) {
        inside = middle;
      } else {
        outside = middle;
      }
    }
    rungeKutta.step(state, outside, trial);
    return outside;
  }

  private void settleIntoRolling(BallBody ball) {
    double[] state = ball.state;
    // What is left of the slip is rounding, and ends as the friction before would have ended it.
    double share = forces.slidingInertiaFactor() / (1 + forces.slidingInertiaFactor());
    double slipX = forces.slipX(state);
    double slipY = forces.slipY(state);
    state[3] -= share * slipX;
    state[4] -= share * slipY;
    forces.makeRolling(state);
    ball.setPhase(MotionPhase.ROLLING);
  }

  private void impact(BallBody ball, double time, BallTrace trace) {
    double[] s = ball.state;
    ImpactLaw law = physics.impact();
    boolean first = ball.impacts() == 0;
    double vx = s[3];
    double vy = s[4];
    double vz = s[5];
    forces.moment(0, s);
    double dampingZ =
        ImpactLaw.limited(
            law.dampingZ(first, -vz) * forces.extraRestitution() + forces.addedRestitution());
    double along = forces.extraAlong();
    double addedAlong = forces.addedAlong();
    double turn = forces.turn();
    if (law.tangential() instanceof FixedLoss loss) {
      double damping = addedAlong + (first ? loss.firstHop() : loss.otherHops());
      double limit = physics.ground().slidingFriction() * (1 + dampingZ) * Math.abs(vz);
      loseFixedShare(ball, damping, spinShare(loss), limit);
    } else {
      touch(s, (Contact) law.tangential(), law.spinCoupling(), dampingZ);
      s[3] += addedAlong * vx;
      s[4] += addedAlong * vy;
    }
    s[3] *= along;
    s[4] *= along;
    ball.gainedVelocity[0] *= along;
    ball.gainedVelocity[1] *= along;
    if (turn != 0) {
      turn(ball, turn);
    }
    s[5] = -dampingZ * vz;
    ball.countImpact();
    boolean lands = s[5] * s[5] < 2 * BallPhysics.GRAVITY * law.minHopHeight();
    if (lands) {
      s[5] = 0;
      ball.setPhase(MotionPhase.SLIDING);
      if (law.tangential() instanceof FixedLoss) {
        boolean spins = ball.givenSpin[0] != 0 || ball.givenSpin[1] != 0;
        remove(s, ball.gainedVelocity, ball.givenSpin);
        forces.makeRolling(s);
        restore(s, ball.gainedVelocity, ball.givenSpin);
        ball.setPhase(spins ? MotionPhase.SLIDING : MotionPhase.ROLLING);
      }
    }
    trace.event(
        new BallEvent(
            lands ? BallEvent.Kind.LAND : BallEvent.Kind.BOUNCE,
            time,
            s[0],
            s[1],
            vx,
            vy,
            vz,
            s[3],
            s[4],
            s[5]));
  }

  /**
   * The fixed damping of a ball that was launched without spin, and on top of it what given spin changes: the difference of the two balls' velocities u and surface velocities w obeys the contact law, by which
   * the part (1 + ρ)·β/(1+β) of the slip u − w of the contact point is taken from u, and 1/β of that given to w (Garwin, Am. J. Phys. 37, 88 (1969); Cross, Am. J. Phys. 70, 1093 (2002)). Of a ball that does not
   * spin, all velocity is slip, so that part is 1 − e_xy1. Without given spin the damping holds exactly.
   *
   * @param share of the slip that is taken from the velocity
   * @param limit of Coulomb friction on the change of the velocity, m/s; what the damping itself takes is always within it
   */
  private void loseFixedShare(BallBody ball, double damping, double share, double limit) {
    double[] s = ball.state;
    double[] spin = ball.givenSpin;
    double[] gained = ball.gainedVelocity;
    double e = Math.max(0, damping - physics.impact().spinCoupling() * forces.spinFraction(s));
    double lostX = (1 - e) * (s[3] - gained[0]);
    double lostY = (1 - e) * (s[4] - gained[1]);
    double addedX = share * (forces.radius() * spin[1] - gained[0]);
    double addedY = share * (-forces.radius() * spin[0] - gained[1]);
    double change = Math.hypot(addedX - lostX, addedY - lostY);
    double most = Math.max(limit, Math.hypot(lostX, lostY));
    if (change > most) {
      addedX = lostX + most / change * (addedX - lostX);
      addedY = lostY + most / change * (addedY - lostY);
    }
    remove(s, gained, spin);
    double beforeX = forces.slipX(s);
    double beforeY = forces.slipY(s);
    s[3] -= lostX;
    s[4] -= lostY;
    forces.addSpinOfImpulse(s, -lostX, -lostY);
    // Friction can stop the slip, but not reverse it. For a ball that already rolled, rounding
    // would decide between the two.
    boolean rolled = Math.hypot(beforeX, beforeY) < ROLLING_SLIP;
    if (rolled || forces.slipX(s) * beforeX + forces.slipY(s) * beforeY < 0) {
      forces.makeRolling(s);
    }
    double turn = 1 / (forces.inertiaFactor() * forces.radius());
    spin[0] += turn * addedY;
    spin[1] -= turn * addedX;
    gained[0] += addedX;
    gained[1] += addedY;
    restore(s, gained, spin);
  }

  /** Turns all that an impact left, about the vertical. */
  private static void turn(BallBody ball, double angle) {
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    turn(ball.state, 3, cos, sin);
    turn(ball.state, 6, cos, sin);
    turn(ball.givenSpin, 0, cos, sin);
    turn(ball.gainedVelocity, 0, cos, sin);
  }

  private static void turn(double[] v, int at, double cos, double sin) {
    double x = v[at];
    v[at] = cos * x - sin * v[at + 1];
    v[at + 1] = sin * x + cos * v[at + 1];
  }

  private static void remove(double[] s, double[] velocity, double[] spin) {
    s[3] -= velocity[0];
    s[4] -= velocity[1];
    s[6] -= spin[0];
    s[7] -= spin[1];
  }

  private static void restore(double[] s, double[] velocity, double[] spin) {
    s[3] += velocity[0];
    s[4] += velocity[1];
    s[6] += spin[0];
    s[7] += spin[1];
  }

  /** Share of the slip that an impact takes from the velocity, limited to the range from no contact to a super ball. */
  private double spinShare(FixedLoss loss) {
    double superBall = 2 * forces.inertiaFactor() / (1 + forces.inertiaFactor());
    return Math.max(0, Math.min(superBall, 1 - loss.firstHop()));
  }

  private void touch(double[] s, Contact contact, double coupling, double dampingZ) {
    double restitution =
        Math.max(-1, Math.min(1, contact.restitution() - coupling * forces.spinFraction(s)));
    double impulse = (1 + dampingZ) * Math.abs(s[5]);
    double gripping = slideThrough(s, contact, restitution, impulse);
    s[3] *= 1 - contact.loss();
    s[4] *= 1 - contact.loss();
    s[6] *= 1 - contact.spinLoss();
    s[7] *= 1 - contact.spinLoss();
    resist(s, contact.rolling() * gripping);
  }

  /**
   * The part of an impact during which the contact point slides, in small steps of the impulse: friction pushes against the slip, and the torque of rolling resistance opposes the spin.
   *
   * @return the part of the impulse that is left when the slip is undone
   */
  private double slideThrough(double[] s, Contact contact, double restitution, double impulse) {
    double slip = Math.hypot(forces.slipX(s), forces.slipY(s));
    if (slip == 0) {
      return impulse;
    }
    double x = forces.slipX(s) / slip;
    double y = forces.slipY(s) / slip;
    double beta = forces.inertiaFactor();
    double radius = physics.ball().radius();
    double friction = contact.friction();
    double torque = (1 + beta) * contact.rolling();
    double undone = (1 + restitution) * slip;
    double left = impulse;
    double longest = torque == 0 ? impulse : impulse / IMPACT_STEPS;
    while (left > 0 && undone > 0) {
      double spinX = radius * s[7];
      double spinY = -radius * s[6];
      double spin = Math.hypot(spinX, spinY);
      double along = spinX * x + spinY * y;
      // A ball that does not turn yet begins to turn as friction makes it, unless the torque holds
      // it.
      boolean starts = spin <= ROLLING_SLIP;
      double held = starts ? Math.min(torque, friction) : torque;
      double brakeX = held * (starts ? x : spinX / spin) / beta;
      double brakeY = held * (starts ? y : spinY / spin) / beta;
      double gain = friction / beta - (brakeX * x + brakeY * y);
      // A torque that is stronger than friction lets the slip of a turning ball grow.
      double closing = friction + gain;
      double step = Math.min(longest, left);
      step = closing > 0 ? Math.min(step, undone / closing) : step;
      if (Math.abs(along) > ROLLING_SLIP && along * gain < 0) {
        step = Math.min(step, -along / gain);
      }
      s[3] -= friction * step * x;
      s[4] -= friction * step * y;
      forces.addSpinOfImpulse(s, -friction * step * x, -friction * step * y);
      s[7] -= brakeX * step / radius;
      s[6] += brakeY * step / radius;
      undone -= closing * step;
      left = step < left ? left - step : 0;
    }
    return left;
  }

  /** Takes that much speed of the ball and of its surface in the direction in which the spin rolls it, at most all of the spin. */
  private void resist(double[] s, double most) {
    double radius = physics.ball().radius();
    double spin = radius * Math.hypot(s[6], s[7]);
    if (most == 0 || spin == 0) {
      return;
    }
    double kept = 1 - Math.min(most, spin) / spin;
    s[3] -= (1 - kept) * radius * s[7];
    s[4] += (1 - kept) * radius * s[6];
    s[6] *= kept;
    s[7] *= kept;
  }

  private void commit(double[] state) {
    System.arraycopy(trial, 0, state, 0, state.length);
  }

  private static BallEvent event(BallEvent.Kind kind, double time, BallBody ball) {
    double[] s = ball.state;
    return new BallEvent(kind, time, s[0], s[1], s[3], s[4], s[5], s[3], s[4], s[5]);
  }
}
