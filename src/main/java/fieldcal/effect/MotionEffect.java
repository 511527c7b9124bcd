package fieldcal.effect;

import fieldcal.ball.ChipModel;

/**
 * An effect that changes how the ball moves. What it changes is said by the interfaces below, of which an effect implements one or
 * more: the integrator asks each only where it may act.
 */
public interface MotionEffect extends Effect {
  @Override
  MotionEffect withParameters(double... values);

  /**
   * Whether it acts on a ball that is in the air or hits the ground, and not only on one that slides or rolls.
   *
   * @return also true of what acts everywhere
   */
  default boolean actsOffTheGround() {
    return this instanceof SpinAtKick
        || this instanceof ExternalForce
        || this instanceof AirFlow
        || this instanceof Bounce
        || this instanceof ImpactLaw;
  }

  /**
   * Whether it may change the path of a kick; where it does not, a path need not be integrated to see what it does.
   *
   * @param chip false for a flat kick
   * @param kickTime session time of the kick, s
   * @return also true where it may only turn out to change nothing
   */
  default boolean mayAct(boolean chip, double kickTime) {
    return true;
  }

  /** Spin right after the kick. */
  interface SpinAtKick extends MotionEffect {
    /**
     * Adds the kick's spin, given as the horizontal velocity at which a ball with this spin rolls without slip: {@code s = r·(ω_y, −ω_x)}.
     *
     * @param vx velocity right after the kick, m/s
     * @param vy velocity right after the kick, m/s
     * @param vz velocity right after the kick, m/s; positive for chips, 0 for flat kicks
     * @param spin x and y of s, m/s; add to it
     */
    void addSpin(double vx, double vy, double vz, double[] spin);
  }

  /** A force that does not come from the contact with the carpet. */
  interface ExternalForce extends MotionEffect {
    /**
     * Adds the force over the mass. On the carpet the horizontal part moves the ball and the vertical one presses it down or lifts it.
     *
     * @param motion how the ball moves
     * @param acceleration x, y, z, m/s²; add to it
     */
    void addAcceleration(BallMotion motion, double[] acceleration);

    /**
     * The same force, with everything that does not depend on the motion computed beforehand; the integrator asks this one.
     *
     * @return does what {@link #addAcceleration} does
     */
    default Field field() {
      return this::addAcceleration;
    }

    /** A force over the mass, without the effect that it comes from. */
    @FunctionalInterface
    interface Field {
      /**
       * Adds it.
       *
       * @param motion how the ball moves
       * @param acceleration x, y, z, m/s²; add to it
       */
      void add(BallMotion motion, double[] acceleration);
    }
  }

  /** Air that moves. Forces of the air ask {@link BallMotion#airX} and {@link BallMotion#airY}, the sum over all flows. */
  interface AirFlow extends MotionEffect {
    /**
     * How the air moves.
     *
     * @return the flow, asked for once and used for many instants
     */
    Flow flow();

    /** Velocities of air. */
    @FunctionalInterface
    interface Flow {
      /**
       * Adds the velocity where a ball is.
       *
       * @param motion how the ball moves
       * @param air x and y, m/s; add to it
       */
      void add(BallMotion motion, double[] air);
    }
  }

  /** What makes sliding differ from a constant friction: accSlide·∏ factors against the slip. */
  interface SlidingResistance extends MotionEffect {
    /**
     * Factor on the friction of the model.
     *
     * @param motion how the ball moves
     * @return 1 = as in the model
     */
    double slidingFactor(BallMotion motion);

    /**
     * Friction across the slip, as on a carpet or in an engine whose friction is not the same in all directions.
     *
     * @param motion how the ball moves
     * @return as a part of the model's friction, positive to the left of the slip; 0 = as in the model
     */
    default double slidingAcross(BallMotion motion) {
      return 0;
    }
  }

  /** What makes a whole kick differ from the next: asked once per kick. */
  interface FrictionOfKick extends MotionEffect {
    /**
     * Factor on the rolling deceleration, with what other effects add to it.
     *
     * @param kickTime session time of the kick, s
     * @return 1 = as in the model
     */
    double rolling(double kickTime);

    /**
     * Factor on the sliding friction of the model.
     *
     * @param kickTime session time of the kick, s
     * @return 1 = as in the model
     */
    double sliding(double kickTime);

    @Override
    default boolean mayAct(boolean chip, double kickTime) {
      return rolling(kickTime) != 1 || sliding(kickTime) != 1;
    }
  }

  /** A straight line on the carpet that changes a ball's velocity when it crosses it. The integrator stops there. */
  interface Line extends MotionEffect {
    /**
     * Unit vector across the line.
     *
     * @return along x
     */
    double normalX();

    /**
     * Unit vector across the line.
     *
     * @return along y
     */
    double normalY();

    /**
     * Where it is.
     *
     * @return distance from the field's centre along the normal, m
     */
    double distance();

    /**
     * Changes the velocity of a ball that crosses it. The velocity across the line must not change its sign, or the ball would be on the wrong side.
     *
     * @param velocity vx and vy before, m/s; changed in place
     */
    void cross(double[] velocity);
  }

  /** What makes rolling differ from a constant deceleration: a = −(−accRoll + Σ addends)·∏ factors along the velocity. */
  interface RollingResistance extends MotionEffect {
    /**
     * Factor on the deceleration, with what other effects add to it.
     *
     * @param motion how the ball moves
     * @return 1 = as in the model
     */
    default double factor(BallMotion motion) {
      return 1;
    }

    /**
     * What is added to the deceleration of the model.
     *
     * @param motion how the ball moves
     * @return m/s², positive brakes, 0 = as in the model
     */
    default double addend(BallMotion motion) {
      return 0;
    }
  }

  /** What may vary so fast on the carpet that an integrator must take shorter steps than it would without it. */
  interface Varying extends MotionEffect {
    /**
     * The longest step of an integrator that does not skip over how it varies.
     *
     * @param motion how the ball moves at the beginning of the step
     * @return s, positive; infinite when it does not matter
     */
    double longestStep(BallMotion motion);
  }

  /** An acceleration relative to the path that a ball on the carpet has, sliding or rolling, whatever force it comes from. */
  interface PathAcceleration extends Varying {
    /**
     * Acceleration along the velocity.
     *
     * @param motion how the ball moves
     * @return m/s², positive makes it faster
     */
    default double along(BallMotion motion) {
      return 0;
    }

    /**
     * Acceleration across the velocity.
     *
     * @param motion how the ball moves
     * @return m/s², positive turns it to its left
     */
    default double across(BallMotion motion) {
      return 0;
    }
  }

  /** A convex part of the carpet with another friction, sliding and rolling. The integrator stops at its edges. */
  interface FrictionZone extends MotionEffect {
    /**
     * Factor on all friction within.
     *
     * @return 1 = as outside
     */
    double frictionFactor();

    /**
     * Whether a place is within.
     *
     * @param x x in the field frame, m
     * @param y y in the field frame, m
     * @return true within
     */
    boolean contains(double x, double y);

    /**
     * Whether a straight piece of path changes sides.
     *
     * @param inside whether it begins within
     * @param x0 begin, m
     * @param y0 begin, m
     * @param x1 end, m
     * @param y1 end, m
     * @return a fraction of the way, above 0 and at most 1, at which it is on the other side, with exactly one edge in between; NaN when it stays on its side
     */
    double otherSide(boolean inside, double x0, double y0, double x1, double y1);
  }

  /** A law of the impulse along the ground that replaces the fixed losses of the models at impacts. Of several the last one holds. */
  interface ImpactLaw extends MotionEffect {
    /**
     * The velocity and the spin after an impact.
     *
     * @param arrival how the ball arrives
     * @param dampingZ the vertical restitution of this impact (–)
     * @param inertiaFactor β of the ball (–)
     * @param after vx, vy and the spin as velocities (see {@link BallMotion#spinX}), m/s; before the impact when called, changed in place
     */
    void impact(BallMotion arrival, double dampingZ, double inertiaFactor, double[] after);

    /**
     * The height of the lowest hop; a ball that would hop lower stays down.
     *
     * @return m, {@link ChipModel#MIN_HOP_HEIGHT} unless a law says otherwise
     */
    default double lowestHop() {
      return ChipModel.MIN_HOP_HEIGHT;
    }

    @Override
    default boolean mayAct(boolean chip, double kickTime) {
      return chip;
    }
  }

  /** What makes a bounce differ from fixed losses. */
  interface Bounce extends MotionEffect {
    /**
     * The vertical restitution of this impact.
     *
     * @param motion how the ball arrives
     * @param dampingZ what it would be otherwise (–)
     * @return the changed one (–)
     */
    default double dampingZ(BallMotion motion, double dampingZ) {
      return dampingZ;
    }

    /**
     * The horizontal restitution of this impact.
     *
     * @param motion how the ball arrives
     * @param dampingXy what it would be otherwise (–)
     * @return the changed one (–)
     */
    default double dampingXy(BallMotion motion, double dampingXy) {
      return dampingXy;
    }

    /**
     * How the impact turns the path.
     *
     * @param motion how the ball arrives
     * @return rad, positive to the ball's left
     */
    default double turn(BallMotion motion) {
      return 0;
    }

    @Override
    default boolean mayAct(boolean chip, double kickTime) {
      return chip;
    }
  }
}
