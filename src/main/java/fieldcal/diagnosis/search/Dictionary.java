package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.Mosaic;
import fieldcal.effect.MotionEffect;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a search may propose: every effect of a list wherever the recording could show it. Immutable. */
public final class Dictionary {
  private final List<Proposal> everywhere = new ArrayList<>();
  private final Map<String, List<Place>> placed = new LinkedHashMap<>();
  private final List<Effect> laws = new ArrayList<>();
  private final List<Proposal> together = new ArrayList<>();
  private final List<Component> chance;
  private final List<Effect> effects;
  private final List<Effect> byChance;
  private final List<Effect> forms;
  private final Arena arena;

  /**
   * A dictionary.
   *
   * @param effects absent ones
   * @param arena what was recorded
   */
  public Dictionary(List<? extends Effect> effects, Arena arena) {
    this(effects, List.of(), List.of(), arena);
  }

  /**
   * A dictionary for a search that also compares its findings with chance, and with another form of what every ball does.
   *
   * @param effects absent ones
   * @param byChance absent ones that differ from kick to kick and have no mean of their own
   * @param forms absent ones that are proposed only where all others explain too little
   * @param arena what was recorded
   */
  public Dictionary(
      List<? extends Effect> effects,
      List<? extends Effect> byChance,
      List<? extends Effect> forms,
      Arena arena) {
    this.arena = arena;
    this.effects = List.copyOf(effects);
    this.byChance = List.copyOf(byChance);
    this.forms = List.copyOf(forms);
    chance = byChance.stream().filter(e -> e.canShowIn(arena)).map(Component::perKick).toList();
    for (Effect effect : effects) {
      if (effect instanceof KickerEffect || !effect.canShowIn(arena)) {
        // Commands are compared with the fitted velocities of the kicks, outside this search.
        continue;
      }
      if (!effect.starts().isEmpty()) {
        laws.add(effect);
        continue;
      }
      add(effect);
      if (!effect.companions().isEmpty()) {
        List<Component> all = new ArrayList<>();
        effect.companions().forEach(e -> all.add(Component.of(e, e.magnitudes())));
        all.add(Component.of(effect, effect.magnitudes()));
        together.add(new Proposal(all, false));
      }
    }
  }

  /** The same that proposes other forms, too; empty where there are none. */
  Optional<Dictionary> withForms() {
    if (forms.isEmpty()) {
      return Optional.empty();
    }
    List<Effect> all = new ArrayList<>(effects);
    all.addAll(forms);
    return Optional.of(new Dictionary(all, byChance, List.of(), arena));
  }

  private void add(Effect effect) {
    Optional<Mosaic> mosaic = effect.mosaic(arena);
    if (mosaic.isPresent()) {
      placed.put(effect.id(), Place.of(mosaic.get()));
      return;
    }
    List<Component> perCamera = new ArrayList<>();
    for (Effect candidate : effect.candidates(arena)) {
      if (effect.differsFromKickToKick() && candidate instanceof MotionEffect) {
        everywhere.add(Proposal.of(Component.perKick(candidate)));
        if (!effect.hasOwnMean()) {
          continue;
        }
      }
      for (List<String> magnitudes : effect.choices()) {
        Component c = Component.of(candidate, magnitudes);
        if (c.hasPlace()) {
          placed.computeIfAbsent(effect.id() + c.camera(), k -> new ArrayList<>()).add(Place.of(c));
          continue;
        }
        everywhere.add(Proposal.of(c));
        if (c.camera().isPresent() && magnitudes.equals(effect.choices().get(0))) {
          perCamera.add(c);
        }
      }
    }
    if (perCamera.size() > 2) {
      everywhere.add(new Proposal(perCamera, true));
    }
  }

  /** Proposals without a place to be searched, that fit beside what a model has. */
  List<Proposal> everywhere(EffectModel model) {
    return everywhere.stream().filter(p -> isPossible(p, model)).toList();
  }

  /** Of these, the components that differ from kick to kick and have no mean of their own. */
  List<Proposal> random(EffectModel model) {
    return everywhere(model).stream()
        .filter(p -> !p.components().get(0).template().hasOwnMean())
        .toList();
  }

  /** Proposals with a place, one list for each family. Versions with more freedom of a component that the model already has are proposed at its place only: elsewhere they would also have to do what it does where it is. */
  List<List<Place>> placed(EffectModel model) {
    return placed.values().stream()
        .map(list -> list.stream().filter(p -> isPossible(p.proposal(), model)).toList())
        .map(list -> whereTheyAre(list, model))
        .filter(list -> !list.isEmpty())
        .toList();
  }

  private static List<Place> whereTheyAre(List<Place> places, EffectModel model) {
    Map<String, Place> all = new LinkedHashMap<>();
    for (Place p : places) {
      Place moved =
          model.components().stream()
              .filter(p.component()::isSameCause)
              .findFirst()
              .map(had -> Place.of(atPlaceOf(p.component(), had)))
              .orElse(p);
      all.putIfAbsent(moved.component().toString(), moved);
    }
    return List.copyOf(all.values());
  }

  private static Component atPlaceOf(Component c, Component had) {
    Effect there = c.template();
    for (String name : there.places()) {
      there = there.with(name, had.template().value(name));
    }
    return c.startingAt(there);
  }

  /** What may differ from kick to kick by chance, and the model does not have yet. */
  List<Component> chance(EffectModel model) {
    return chance.stream()
        .filter(c -> model.components().stream().noneMatch(c::isSameCause))
        .toList();
  }

  /** When the kicks were, session time, s, ascending. */
  double[] kickTimes() {
    return arena.kickTimes();
  }

  /** All places at which a component could be, and among them its own; empty if its places are not made of tiles. */
  List<Place> placesOf(Component c) {
    return c.template().mosaic(arena).map(Place::of).orElse(List.of());
  }

  /** Effects that do nothing alone, with those that they need at usual values, of which the model has none: a score test at their absence cannot see them. */
  List<Proposal> together(EffectModel model) {
    return together.stream()
        .filter(
            p ->
                p.components().stream()
                    .noneMatch(c -> model.components().stream().anyMatch(c::isSameCause)))
        .toList();
  }

  /** Laws that replace another and are tried from their strong versions. */
  List<Effect> laws(EffectModel model) {
    return laws.stream()
        .filter(e -> model.components().stream().noneMatch(c -> c.template().id().equals(e.id())))
        .toList();
  }

  private static boolean isPossible(Proposal p, EffectModel model) {
    for (Component c : p.components()) {
      // Of a group the members that the model has are left out when it is tried.
      boolean known =
          !p.group()
              && model.components().stream().anyMatch(m -> m.isSameCause(c) && !isMore(c, m));
      boolean alone =
          c.template().companions().stream()
              .anyMatch(
                  e ->
                      model.components().stream().noneMatch(m -> m.template().id().equals(e.id())));
      if (known || alone) {
        return false;
      }
    }
    return true;
  }

  /** Whether a component frees what the one in the model holds: more magnitudes, or a value for each kick. */
  static boolean isMore(Component proposed, Component had) {
    return proposed.isPerKick() && !had.isPerKick()
        || proposed.magnitudeCount() > had.magnitudeCount();
  }
}
