package fieldcal.effect;

import fieldcal.effect.MotionEffect.Bounce;
import fieldcal.effect.MotionEffect.ExternalForce;
import fieldcal.effect.MotionEffect.FrictionZone;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.effect.MotionEffect.SpinAtKick;
import java.util.List;

/** The effects that act on a ball, sorted by what they change, and the ball's body. Immutable; make it once for many kicks. */
public final class MotionEffects {
  /** A golf ball on which nothing acts but what the models say. */
  public static final MotionEffects NONE = of(List.of());

  final BallBody ball;
  final SpinAtKick[] spins;
  final ExternalForce[] forces;
  final RollingResistance[] resistances;
  final FrictionZone[] zones;
  final Bounce[] bounces;
  private final List<MotionEffect> effects;

  private MotionEffects(BallBody ball, List<? extends MotionEffect> effects) {
    this.ball = ball;
    this.effects = List.copyOf(effects);
    // An absent effect is left out, so that it changes nothing, not even a rounding error.
    List<MotionEffect> acting = this.effects.stream().filter(e -> !e.isAbsent()).toList();
    spins = acting.stream().filter(SpinAtKick.class::isInstance).toArray(SpinAtKick[]::new);
    forces = acting.stream().filter(ExternalForce.class::isInstance).toArray(ExternalForce[]::new);
    resistances =
        acting.stream()
            .filter(RollingResistance.class::isInstance)
            .toArray(RollingResistance[]::new);
    zones = acting.stream().filter(FrictionZone.class::isInstance).toArray(FrictionZone[]::new);
    bounces = acting.stream().filter(Bounce.class::isInstance).toArray(Bounce[]::new);
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
    return new MotionEffects(ball, effects);
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
   * The ball's body.
   *
   * @return the body
   */
  public BallBody ball() {
    return ball;
  }
}
