package fieldcal.effect;

import fieldcal.ball.Gravity;
import fieldcal.ball.Phase;
import fieldcal.effect.MotionEffect.AirFlow;
import fieldcal.effect.MotionEffect.ExternalForce;
import fieldcal.effect.MotionEffect.FrictionOfKick;
import fieldcal.effect.MotionEffect.FrictionZone;
import fieldcal.effect.MotionEffect.PathAcceleration;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.SlidingResistance;
import fieldcal.effect.MotionEffect.Varying;

/** The right-hand side of the equations of motion in {@link ExtendedTrajectory}. State: x, y, z, vx, vy, vz, spin x, spin y. */
final class BallForces {
  static final int SIZE = 8;
  private static final double G = Gravity.ACCELERATION;

  /** Speed with which a ball leaves a rest that does not hold, m/s; chosen small enough to change nothing. */
  private static final double CREEP = 1e-4;

  private final MotionEffects effects;
  private final double rollingBrake;
  private final double rollingOfKick;
  private final double sessionStart;
  private final BallMotion motion = new BallMotion();
  private final double[] force = new double[3];
  private final double[] air = new double[2];

  /** A ball at rest that is about to move, and its rates. */
  private final double[] creep = new double[8];

  private final double[] creepRate = new double[8];

  /** Friction and speed at which it turns the ball, of the sliding phase: m/s², and spin gained per velocity lost. */
  private double accSlide = -1;

  private double spinPerVelocity = 1;

  private double kickTime;
  private double zoneFactor = 1;
  private double slidingOfKick = 1;
  private boolean frozen;
  private double frozenX;
  private double frozenY;

  BallForces(MotionEffects effects, double sessionStart, double accRoll, double kickTime) {
    this.effects = effects;
    this.sessionStart = sessionStart;
    rollingBrake = -accRoll;
    double ofKick = 1;
    for (FrictionOfKick effect : effects.frictions) {
      ofKick *= effect.rolling(kickTime - sessionStart);
      slidingOfKick *= effect.sliding(kickTime - sessionStart);
    }
    rollingOfKick = ofKick;
  }

  void setSliding(double acceleration, double kSwitch) {
    accSlide = acceleration;
    // 1/β of the model: kSwitch = 1/(1 + β).
    spinPerVelocity = kSwitch / (1 - kSwitch);
  }

  void setKick(double t0, double x, double y) {
    kickTime = t0;
    motion.kickX = x;
    motion.kickY = y;
  }

  void setHop(int hop) {
    motion.hop = hop;
  }

  /** The longest step, s, that does not skip over how forces on the carpet vary. */
  double longestStep(Phase phase, double t, double[] s) {
    double longest = ExtendedTrajectory.MAX_DURATION;
    if (effects.varying.length > 0) {
      longest = PathIntegrator.MAX_STEP;
      BallMotion m = motion(t, s, false);
      m.sliding = phase == Phase.SLIDING;
      m.slipX = s[3] - s[6];
      m.slipY = s[4] - s[7];
      for (Varying effect : effects.varying) {
        longest = Math.min(longest, effect.longestStep(m));
      }
    }
    return longest;
  }

  void setInside(boolean[] inside) {
    zoneFactor = 1;
    for (int i = 0; i < inside.length; i++) {
      FrictionZone zone = effects.zones[i];
      zoneFactor *= inside[i] ? zone.frictionFactor() : 1;
    }
  }

  /** Friction acts against this direction from now on: near its end a phase has none of its own. */
  void freeze(double x, double y) {
    frozen = true;
    frozenX = x;
    frozenY = y;
  }

  void unfreeze() {
    frozen = false;
  }

  /** What effects see of a state. */
  BallMotion motion(double t, double[] s, boolean flying) {
    BallMotion m = motion;
    m.x = s[0];
    m.y = s[1];
    m.vx = s[3];
    m.vy = s[4];
    m.vz = s[5];
    m.spinX = s[6];
    m.spinY = s[7];
    m.sessionTime = t - sessionStart;
    m.timeSinceKick = t - kickTime;
    m.flying = flying;
    m.sliding = false;
    addAir(m);
    return m;
  }

  private void addAir(BallMotion m) {
    if (effects.flows.length > 0) {
      air[0] = 0;
      air[1] = 0;
      for (AirFlow.Flow flow : effects.flows) {
        flow.add(m, air);
      }
      m.airX = air[0];
      m.airY = air[1];
    }
  }

  /** Rate of change of the state. */
  void derivative(Phase phase, double t, double[] s, double[] rate) {
    force[0] = 0;
    force[1] = 0;
    force[2] = 0;
    BallMotion m = motion(t, s, phase == Phase.FLYING);
    for (ExternalForce.Field field : effects.forces) {
      field.add(m, force);
    }
    rate[0] = s[3];
    rate[1] = s[4];
    rate[2] = s[5];
    switch (phase) {
      case FLYING -> {
        rate[3] = force[0];
        rate[4] = force[1];
        rate[5] = force[2] - G;
        rate[6] = 0;
        rate[7] = 0;
      }
      case SLIDING -> slide(m, s, rate);
      default -> roll(m, s, rate);
    }
  }

  private double pressure() {
    return Math.max(0, 1 - force[2] / G);
  }

  private void slide(BallMotion m, double[] s, double[] rate) {
    double directionX = frozenX;
    double directionY = frozenY;
    if (!frozen) {
      double slipX = s[3] - s[6];
      double slipY = s[4] - s[7];
      double slip = Math.sqrt(slipX * slipX + slipY * slipY);
      directionX = slip > 0 ? slipX / slip : 0;
      directionY = slip > 0 ? slipY / slip : 0;
    }
    double acceleration = accSlide * slidingOfKick * zoneFactor * pressure();
    double across = 0;
    if (effects.slidings.length > 0) {
      m.slipX = directionX;
      m.slipY = directionY;
      double against = acceleration;
      for (SlidingResistance effect : effects.slidings) {
        acceleration *= effect.slidingFactor(m);
        across -= against * effect.slidingAcross(m);
      }
    }
    double frictionX = acceleration * directionX - across * directionY;
    double frictionY = acceleration * directionY + across * directionX;
    rate[3] = frictionX + force[0];
    rate[4] = frictionY + force[1];
    rate[5] = 0;
    rate[6] = -spinPerVelocity * frictionX;
    rate[7] = -spinPerVelocity * frictionY;
    if (effects.accelerations.length > 0) {
      m.sliding = true;
      double speed = Math.sqrt(s[3] * s[3] + s[4] * s[4]);
      if (speed > 0) {
        accelerate(m, s[3] / speed, s[4] / speed, rate);
      }
    }
  }

  /** Adds what accelerates the ball relative to its path, whose direction is given. */
  private void accelerate(BallMotion m, double directionX, double directionY, double[] rate) {
    for (PathAcceleration effect : effects.accelerations) {
      double along = effect.along(m);
      double across = effect.across(m);
      rate[3] += along * directionX - across * directionY;
      rate[4] += along * directionY + across * directionX;
    }
  }

  private void roll(BallMotion m, double[] s, double[] rate) {
    double directionX = frozenX;
    double directionY = frozenY;
    if (!frozen) {
      double speed = Math.sqrt(s[3] * s[3] + s[4] * s[4]);
      directionX = speed > 0 ? s[3] / speed : 0;
      directionY = speed > 0 ? s[4] / speed : 0;
    } else if (s[3] * frozenX + s[4] * frozenY < CREEP) {
      // A trial step beyond the stop: what depends on the direction stays as it was at the stop.
      m.vx = CREEP * frozenX;
      m.vy = CREEP * frozenY;
    }
    double deceleration = rollingDeceleration(m);
    double share = 1 / (1 + effects.ball.inertiaFactor());
    rate[3] = -deceleration * directionX + share * force[0];
    rate[4] = -deceleration * directionY + share * force[1];
    accelerate(m, directionX, directionY, rate);
    rate[5] = 0;
    rate[6] = rate[3];
    rate[7] = rate[4];
  }

  private double rollingDeceleration(BallMotion m) {
    double deceleration = rollingBrake;
    double factor = rollingOfKick * zoneFactor * pressure();
    for (RollingResistance effect : effects.resistances) {
      deceleration += effect.addend(m);
      factor *= effect.factor(m);
    }
    return factor * deceleration;
  }

  /** Whether rolling resistance keeps a ball at rest where it is; if not, gives it a creeping velocity along the force. */
  boolean holds(double t, double[] s) {
    motion(t, s, false);
    force[0] = 0;
    force[1] = 0;
    force[2] = 0;
    for (ExternalForce.Field field : effects.forces) {
      field.add(motion, force);
    }
    double push = Math.hypot(force[0], force[1]);
    if (push == 0) {
      return true;
    }
    double directionX = force[0] / push;
    double directionY = force[1] / push;
    motion.vx = CREEP * directionX;
    motion.vy = CREEP * directionY;
    // The same equation as for a rolling ball, including the braking by learned terms: otherwise a
    // ball that they stop would start again and again.
    creep[3] = motion.vx;
    creep[4] = motion.vy;
    roll(motion, creep, creepRate);
    if (creepRate[3] * directionX + creepRate[4] * directionY <= 0) {
      return true;
    }
    s[3] = motion.vx;
    s[4] = motion.vy;
    s[6] = motion.vx;
    s[7] = motion.vy;
    return false;
  }
}
