package fieldcal.effect;

import fieldcal.effect.MotionEffect.AirFlow;
import fieldcal.effect.MotionEffect.Bounce;
import fieldcal.effect.MotionEffect.ExternalForce;
import fieldcal.effect.MotionEffect.FrictionOfKick;
import fieldcal.effect.MotionEffect.FrictionZone;
import fieldcal.effect.MotionEffect.ImpactLaw;
import fieldcal.effect.MotionEffect.Line;
import fieldcal.effect.MotionEffect.PathAcceleration;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.SlidingResistance;
import fieldcal.effect.MotionEffect.SpinAtKick;
import fieldcal.effect.MotionEffect.Varying;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** The effects that act on a ball, sorted by what they change, and the ball's body. Immutable; make it once for many kicks. */
public final class MotionEffects {
  private static final SpinAtKick[] NO_SPINS = {};
  private static final ExternalForce.Field[] NO_FORCES = {};
  private static final RollingResistance[] NO_RESISTANCES = {};
  private static final SlidingResistance[] NO_SLIDINGS = {};
  private static final FrictionOfKick[] NO_FRICTIONS = {};
  private static final Line[] NO_LINES = {};
  private static final PathAcceleration[] NO_ACCELERATIONS = {};
  private static final Varying[] NONE_VARYING = {};
  private static final FrictionZone[] NO_ZONES = {};
  private static final Bounce[] NO_BOUNCES = {};
  private static final AirFlow.Flow[] NO_FLOWS = {};

  /** A golf ball on which nothing acts but what the models say. */
  public static final MotionEffects NONE = of(List.of());

  final BallBody ball;
  final SpinAtKick[] spins;
  final ExternalForce.Field[] forces;
  final RollingResistance[] resistances;
  final SlidingResistance[] slidings;
  final FrictionOfKick[] frictions;
  final Line[] lines;

  /** Normals (x, y) and distances of the lines, m, one after another. */
  private final double[] linePlaces;

  final PathAcceleration[] accelerations;
  final Varying[] varying;
  final FrictionZone[] zones;
  final Bounce[] bounces;

  /** Null where the models' fixed losses hold. */
  final ImpactLaw impacts;

  final AirFlow.Flow[] flows;
  private final List<MotionEffect> effects;

  /** Nothing acts on the ball. */
  private MotionEffects(BallBody ball) {
    this.ball = ball;
    effects = List.of();
    spins = NO_SPINS;
    forces = NO_FORCES;
    resistances = NO_RESISTANCES;
    slidings = NO_SLIDINGS;
    frictions = NO_FRICTIONS;
    lines = NO_LINES;
    linePlaces = new double[0];
    accelerations = NO_ACCELERATIONS;
    varying = NONE_VARYING;
    zones = NO_ZONES;
    bounces = NO_BOUNCES;
    impacts = null;
    flows = NO_FLOWS;
  }

  /** Some effects and more of them. */
  private MotionEffects(MotionEffects some, List<? extends MotionEffect> more) {
    ball = some.ball;
    List<MotionEffect> all = new ArrayList<>(some.effects.size() + more.size());
    all.addAll(some.effects);
    all.addAll(more);
    effects = Collections.unmodifiableList(all);
    SpinAtKick[] spinning = some.spins;
    ExternalForce.Field[] pulling = some.forces;
    RollingResistance[] resisting = some.resistances;
    SlidingResistance[] rubbing = some.slidings;
    FrictionOfKick[] ofKick = some.frictions;
    Line[] crossed = some.lines;
    PathAcceleration[] accelerating = some.accelerations;
    Varying[] changing = some.varying;
    FrictionZone[] worn = some.zones;
    Bounce[] bouncing = some.bounces;
    ImpactLaw law = some.impacts;
    AirFlow.Flow[] flowing = some.flows;
    for (MotionEffect effect : more) {
      if (effect.isAbsent()) {
        // It is left out, so that it changes nothing, not even a rounding error.
        continue;
      }
      if (effect instanceof SpinAtKick e) {
        spinning = and(spinning, e);
      }
      if (effect instanceof ExternalForce e) {
        pulling = and(pulling, e.field());
      }
      if (effect instanceof RollingResistance e) {
        resisting = and(resisting, e);
      }
      if (effect instanceof SlidingResistance e) {
        rubbing = and(rubbing, e);
      }
      if (effect instanceof FrictionOfKick e) {
        ofKick = and(ofKick, e);
      }
      if (effect instanceof Line e) {
        crossed = and(crossed, e);
      }
      if (effect instanceof ImpactLaw e) {
        law = e;
      }
      if (effect instanceof AirFlow e) {
        flowing = and(flowing, e.flow());
      }
      if (effect instanceof PathAcceleration e) {
        accelerating = and(accelerating, e);
      }
      if (effect instanceof Varying e) {
        changing = and(changing, e);
      }
      if (effect instanceof FrictionZone e) {
        worn = and(worn, e);
      }
      if (effect instanceof Bounce e) {
        bouncing = and(bouncing, e);
      }
    }
    spins = spinning;
    forces = pulling;
    resistances = resisting;
    slidings = rubbing;
    frictions = ofKick;
    lines = crossed;
    linePlaces = Arrays.copyOf(some.linePlaces, 3 * lines.length);
    for (int i = some.lines.length; i < lines.length; i++) {
      linePlaces[3 * i] = lines[i].normalX();
      linePlaces[3 * i + 1] = lines[i].normalY();
      linePlaces[3 * i + 2] = lines[i].distance();
    }
    accelerations = accelerating;
    varying = changing;
    zones = worn;
    bounces = bouncing;
    impacts = law;
    flows = flowing;
  }

  /** Whether a place is beyond a line, on the side to which its normal points. */
  boolean isBeyond(int line, double x, double y) {
    int i = 3 * line;
    return linePlaces[i] * x + linePlaces[i + 1] * y > linePlaces[i + 2];
  }

  private static <T> T[] and(T[] some, T another) {
    T[] more = Arrays.copyOf(some, some.length + 1);
    more[some.length] = another;
    return more;
  }

  /**
   * Effects on a golf ball.
   *
   * @param effects in any order; several of one id add up
   * @return the bundle
   */
  public static MotionEffects of(List<? extends MotionEffect> effects) {
    return of(BallBody.GOLF_BALL, effects);
  }

  /**
   * Effects on another ball. The air forces stay those of a golf ball, whose coefficients they are defined by.
   *
   * @param ball the body
   * @param effects in any order
   * @return the bundle
   */
  public static MotionEffects of(BallBody ball, List<? extends MotionEffect> effects) {
    return new MotionEffects(new MotionEffects(ball), effects);
  }

  /**
   * The same with more effects.
   *
   * @param more added after those that act already
   * @return the larger bundle
   */
  public MotionEffects plus(List<? extends MotionEffect> more) {
    return new MotionEffects(this, more);
  }

  /**
   * What acts.
   *
   * @return as given, absent ones included
   */
  public List<MotionEffect> effects() {
    return effects;
  }

  /**
   * Whether a kick has the same path under both.
   *
   * @param other effects on the same ball
   * @param chip false for a flat kick
   * @param kickTime session time of the kick, s
   * @return false where they differ in an effect that may act on it
   */
  public boolean actAlike(MotionEffects other, boolean chip, double kickTime) {
    return this == other
        || effects.equals(other.effects)
        || acting(chip, kickTime).equals(other.acting(chip, kickTime));
  }

  private List<MotionEffect> acting(boolean chip, double kickTime) {
    return effects.stream().filter(e -> !e.isAbsent() && e.mayAct(chip, kickTime)).toList();
  }

  /**
   * Whether impacts follow a law of their own.
   *
   * @return false where the fixed losses of the models hold
   */
  public boolean haveImpactLaw() {
    return impacts != null;
  }

  /**
   * The ball's body.
   *
   * @return the body
   */
  public BallBody ball() {
    return ball;
  }
}
