package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulatedEffect;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Chooses which effects are hidden together, and what kicks show them. */
final class EffectChoice {
  private static final Set<SimulatedEffect> ON_THE_BALL =
      EnumSet.of(
          SimulatedEffect.AIR_DRAG,
          SimulatedEffect.MAGNUS,
          SimulatedEffect.KICK_SPIN,
          SimulatedEffect.SIDE_SPIN,
          SimulatedEffect.FIELD_SLOPE,
          SimulatedEffect.CARPET_NAP,
          SimulatedEffect.SPEED_DEPENDENT_ROLL,
          SimulatedEffect.WORN_REGION,
          SimulatedEffect.BOUNCE_SPIN_COUPLING,
          SimulatedEffect.DRIFT,
          SimulatedEffect.SLIP_DEPENDENT_FRICTION,
          SimulatedEffect.WIND,
          SimulatedEffect.BALL_CHANGED,
          SimulatedEffect.CARPET_SEAM,
          SimulatedEffect.CONTACT_IMPACTS,
          SimulatedEffect.CARPET_WAVES,
          SimulatedEffect.UNNAMED_ROLL_SQUARE,
          SimulatedEffect.UNNAMED_ROLL_BUMP,
          SimulatedEffect.UNNAMED_FADING_FRICTION,
          SimulatedEffect.UNNAMED_RING,
          SimulatedEffect.UNNAMED_ONCE_PER_TURN,
          SimulatedEffect.UNNAMED_FOUR_WAYS,
          SimulatedEffect.UNNAMED_SIDE_FORCE,
          SimulatedEffect.UNNAMED_PATCHES);

  /** Seen on the carpet only. */
  private static final Set<SimulatedEffect> NEEDS_FLAT =
      EnumSet.of(
          SimulatedEffect.KICK_SPIN,
          SimulatedEffect.SIDE_SPIN,
          SimulatedEffect.FIELD_SLOPE,
          SimulatedEffect.CARPET_NAP,
          SimulatedEffect.SPEED_DEPENDENT_ROLL,
          SimulatedEffect.WORN_REGION,
          SimulatedEffect.DRIFT,
          SimulatedEffect.SLIP_DEPENDENT_FRICTION,
          SimulatedEffect.BALL_CHANGED,
          SimulatedEffect.CARPET_SEAM,
          SimulatedEffect.CARPET_WAVES,
          SimulatedEffect.UNNAMED_ROLL_SQUARE,
          SimulatedEffect.UNNAMED_ROLL_BUMP,
          SimulatedEffect.UNNAMED_FADING_FRICTION,
          SimulatedEffect.UNNAMED_RING,
          SimulatedEffect.UNNAMED_ONCE_PER_TURN,
          SimulatedEffect.UNNAMED_FOUR_WAYS,
          SimulatedEffect.UNNAMED_SIDE_FORCE,
          SimulatedEffect.UNNAMED_PATCHES);

  private static final Set<SimulatedEffect> NEEDS_CHIP =
      EnumSet.of(
          SimulatedEffect.SPEED_DEPENDENT_RESTITUTION,
          SimulatedEffect.BOUNCE_SPIN_COUPLING,
          SimulatedEffect.CONTACT_IMPACTS,
          SimulatedEffect.CAMERA_POSITION_ERROR,
          SimulatedEffect.UNNAMED_RESTITUTION_PLACE,
          SimulatedEffect.UNNAMED_IMPACT_SPEED);

  /** Means nothing with a single camera, or is absorbed by the model. */
  private static final Set<SimulatedEffect> SEVERAL_CAMERAS =
      EnumSet.of(
          SimulatedEffect.CAMERA_OFFSET,
          SimulatedEffect.CAMERA_TIME_OFFSET,
          SimulatedEffect.CAMERA_POSE_ERROR,
          SimulatedEffect.LENS_DISTORTION_ERROR,
          SimulatedEffect.BALL_HEIGHT_ERROR,
          SimulatedEffect.CLOCK_SKEW,
          SimulatedEffect.CAMERA_MOVED,
          SimulatedEffect.UNNAMED_LENS_SHEAR);

  private static final List<SimulatedEffect> CATALOGUED =
      List.of(SimulatedEffect.values()).stream()
          .filter(SimulatedEffect::catalogued)
          .filter(e -> e != SimulatedEffect.TORQUE_LIMITED && e != SimulatedEffect.DIRECTIONAL)
          .toList();

  private static final List<SimulatedEffect> UNNAMED =
      List.of(SimulatedEffect.values()).stream().filter(e -> !e.catalogued()).toList();

  /** Of which the design says that one explains most of the other: no fair pairs. */
  private static final List<Set<SimulatedEffect>> ALIKE =
      List.of(
          EnumSet.of(
              SimulatedEffect.AIR_DRAG,
              SimulatedEffect.MAGNUS,
              SimulatedEffect.SPEED_DEPENDENT_ROLL),
          EnumSet.of(
              SimulatedEffect.FIELD_SLOPE,
              SimulatedEffect.CARPET_NAP,
              SimulatedEffect.WORN_REGION,
              SimulatedEffect.DRIFT,
              SimulatedEffect.BALL_CHANGED),
          EnumSet.of(SimulatedEffect.WIND, SimulatedEffect.FIELD_SLOPE),
          EnumSet.of(SimulatedEffect.CONTACT_IMPACTS, SimulatedEffect.BOUNCE_SPIN_COUPLING),
          EnumSet.of(
              SimulatedEffect.CAMERA_TIME_OFFSET,
              SimulatedEffect.CLOCK_SKEW,
              SimulatedEffect.ROLLING_SHUTTER),
          EnumSet.of(
              SimulatedEffect.CAMERA_OFFSET,
              SimulatedEffect.CAMERA_POSE_ERROR,
              SimulatedEffect.LENS_DISTORTION_ERROR,
              SimulatedEffect.BALL_HEIGHT_ERROR));

  private EffectChoice() {}

  static boolean actsOnTheBall(SimulatedEffect effect) {
    return ON_THE_BALL.contains(effect);
  }

  static boolean needsSeveralCameras(SimulatedEffect effect) {
    return SEVERAL_CAMERAS.contains(effect);
  }

  static List<SimulatedEffect> pick(Category category, RandomStream random) {
    return switch (category) {
      case NULL -> List.of();
      case SINGLE -> named(1, random);
      case PAIR -> named(2, random);
      case MIXTURE -> named(random.happens(0.5) ? 3 : 4, random);
      case UNNAMED -> {
        List<SimulatedEffect> effects =
            new ArrayList<>(List.of(UNNAMED.get(random.below(UNNAMED.size()))));
        // As on real fields: what has no name comes beside what has one.
        if (random.happens(0.35)) {
          effects.addAll(named(1, random));
        }
        yield effects;
      }
    };
  }

  /** Some effects of the catalogue, of which none explains most of another. */
  private static List<SimulatedEffect> named(int count, RandomStream random) {
    List<SimulatedEffect> effects = new ArrayList<>();
    while (effects.size() < count) {
      SimulatedEffect next = CATALOGUED.get(random.below(CATALOGUED.size()));
      if (effects.stream().noneMatch(e -> e == next || alike(e, next))) {
        effects.add(next);
      }
    }
    return effects;
  }

  /** With what they are nothing without: wind needs drag; the lift of a ball that is kicked without spin is small. */
  static List<SimulatedEffect> withCompanions(
      List<SimulatedEffect> effects, ScenarioKind scenario, RandomStream random) {
    List<SimulatedEffect> all = new ArrayList<>();
    for (SimulatedEffect effect : effects) {
      Optional<SimulatedEffect> needed = companion(effect);
      boolean always = effect == SimulatedEffect.WIND;
      boolean spins = scenario != ScenarioKind.FLAT && random.happens(0.6);
      if (needed.isPresent() && !effects.contains(needed.get()) && (always || spins)) {
        all.add(needed.get());
      }
      all.add(effect);
    }
    return all;
  }

  /** The effect without which another is little or nothing. */
  static Optional<SimulatedEffect> companion(SimulatedEffect effect) {
    return switch (effect) {
      case WIND -> Optional.of(SimulatedEffect.AIR_DRAG);
      case MAGNUS -> Optional.of(SimulatedEffect.KICK_SPIN);
      default -> Optional.empty();
    };
  }

  private static boolean alike(SimulatedEffect a, SimulatedEffect b) {
    return ALIKE.stream().anyMatch(set -> set.contains(a) && set.contains(b));
  }

  /** One in which all can be seen. */
  static ScenarioKind scenario(List<SimulatedEffect> effects, RandomStream random) {
    boolean flat = effects.stream().anyMatch(NEEDS_FLAT::contains);
    boolean chip = effects.stream().anyMatch(NEEDS_CHIP::contains);
    boolean mixed = random.happens(0.35);
    if (mixed || (flat && chip)) {
      return ScenarioKind.MIXED;
    }
    boolean flies = chip || (!flat && random.happens(0.4));
    return flies ? ScenarioKind.CHIP : ScenarioKind.FLAT;
  }
}
