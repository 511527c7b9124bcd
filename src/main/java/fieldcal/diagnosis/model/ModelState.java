package fieldcal.diagnosis.model;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Area;
import fieldcal.effect.Effect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.ObservedCamera;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Ball models and effects at one setting of the global parameters, with which kicks are predicted. Immutable. */
public final class ModelState {
  private final FlatModel flat;
  private final ChipModel chip;
  private final MotionEffects motion;
  private final MeasurementEffects measurement;
  private final List<OwnEffect> random;

  /** Those that are the same for all kicks, in the order of the model's components; not what was added for a derivative. */
  private final List<Effect> fixed;

  /** Where a ball must have been for this to differ from the state that it is compared with; null = anywhere. */
  private final Area reach;

  private ModelState(
      FlatModel flat,
      ChipModel chip,
      MotionEffects motion,
      MeasurementEffects measurement,
      List<OwnEffect> random,
      List<Effect> fixed,
      Area reach) {
    this.flat = flat;
    this.chip = chip;
    this.motion = motion;
    this.measurement = measurement;
    this.random = random;
    this.fixed = fixed;
    this.reach = reach;
  }

  static ModelState of(
      FlatModel flat,
      ChipModel chip,
      List<Effect> effects,
      List<OwnEffect> random,
      List<ObservedCamera> observers) {
    return new ModelState(
        flat,
        chip,
        MotionEffects.of(pick(effects, MotionEffect.class)),
        MeasurementEffects.of(observers, pick(effects, MeasurementEffect.class)),
        random,
        effects,
        null);
  }

  private static <E> List<E> pick(List<Effect> effects, Class<E> type) {
    return effects.stream().filter(type::isInstance).map(type::cast).toList();
  }

  /**
   * The same with more effects, for the derivative by them.
   *
   * @param more effects that may be of both families
   * @return the changed copy
   */
  public ModelState plus(List<? extends Effect> more) {
    List<MotionEffect> moving = new ArrayList<>();
    List<MeasurementEffect> measuring = new ArrayList<>(measurement.effects());
    for (Effect e : more) {
      if (e instanceof MotionEffect m) {
        moving.add(m);
      } else if (e instanceof MeasurementEffect m) {
        measuring.add(m);
      }
    }
    boolean measures = measuring.size() > measurement.effects().size();
    return new ModelState(
        flat,
        chip,
        moving.isEmpty() ? motion : motion.plus(moving),
        measures ? measurement.under(measuring) : measurement,
        random,
        fixed,
        more.size() == 1 ? more.get(0).reach().orElse(null) : null);
  }

  /** The same with other ball models and other effects, which are those of the same components in their order; shares what stays as it is, so that it need not be computed or compared again. */
  ModelState changed(FlatModel flat, ChipModel chip, List<Effect> fixed, List<OwnEffect> random) {
    List<MotionEffect> moving = pick(fixed, MotionEffect.class);
    return new ModelState(
        flat,
        chip,
        moving.equals(motion.effects()) ? motion : MotionEffects.of(moving),
        measurement.under(pick(fixed, MeasurementEffect.class)),
        random,
        fixed,
        null);
  }

  /** Effects that are the same for all kicks, in the order of the model's components. */
  List<Effect> fixed() {
    return fixed;
  }

  /** The same, known to differ from the state that it is compared with for balls that came there. */
  ModelState differingIn(Area area) {
    return new ModelState(flat, chip, motion, measurement, random, fixed, area);
  }

  /** Where a ball must have been for this to differ from the state that it is compared with; empty = anywhere. */
  Optional<Area> reach() {
    return Optional.ofNullable(reach);
  }

  /**
   * The model of flat kicks.
   *
   * @return how the ball slides and rolls
   */
  public FlatModel flat() {
    return flat;
  }

  /**
   * The model of chips.
   *
   * @return how the ball bounces and rolls
   */
  public ChipModel chip() {
    return chip;
  }

  MeasurementEffects measurement() {
    return measurement;
  }

  /**
   * Whether a kick has the same path under both, whatever the cameras report of it.
   *
   * @param chip false for a flat kick
   * @param kickTime session time of the kick, s
   */
  boolean hasMotionOf(ModelState other, boolean chip, double kickTime) {
    // A chip slides only where a law of impacts leaves slip; a flat kick never bounces.
    boolean slides = !chip || motion.haveImpactLaw() || other.motion.haveImpactLaw();
    return (!slides || flat.equals(other.flat))
        && (!chip || this.chip.equals(other.chip))
        && OwnEffect.actAlike(random, other.random)
        && motion.actAlike(other.motion, chip, kickTime);
  }

  /** Effects on the motion of one kick, whose own values of the random effects are the last of its parameters. */
  MotionEffects motionOf(double[] own) {
    if (random.isEmpty()) {
      return motion;
    }
    List<MotionEffect> ofKick = new ArrayList<>(random.size());
    int from = own.length - random.size();
    for (int r = 0; r < random.size(); r++) {
      ofKick.add(random.get(r).of(own[from + r]));
    }
    return motion.plus(ofKick);
  }
}
