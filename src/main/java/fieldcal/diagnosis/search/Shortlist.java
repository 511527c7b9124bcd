package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** What a dictionary proposes beside a fitted model, by the score test. Immutable. */
public final class Shortlist {
  /** How many places of each family take part. */
  private static final int PLACES_KEPT = 2;

  private final FittedModel model;
  private final Dictionary dictionary;
  private final Weighing weighing;

  /**
   * A shortlist.
   *
   * @param model fitted to the kicks
   * @param dictionary what may be proposed
   * @param weighing how much kicks count that the model does not explain
   */
  public Shortlist(FittedModel model, Dictionary dictionary, Weighing weighing) {
    this.model = model;
    this.dictionary = dictionary;
    this.weighing = weighing;
  }

  /**
   * What all kicks share and gains most, and what only does something together.
   *
   * @param most how many of the former
   * @return components that may be added at once, places moved to where they explain most
   */
  public List<List<Component>> shared(int most) {
    List<Proposal> proposals = new ArrayList<>(all(p -> !p.components().get(0).isPerKick()));
    List<List<Component>> best = new ArrayList<>();
    if (!proposals.isEmpty()) {
      Scorer scorer = new Scorer(model, components(proposals), weighing);
      Sweep sweep = scorer.sweep();
      proposals.stream()
          .map(p -> p.group() ? members(p, scorer, sweep) : p.components())
          .filter(c -> net(c, scorer, sweep) > 0)
          .sorted(Comparator.comparingDouble((List<Component> c) -> -net(c, scorer, sweep)))
          .limit(most)
          .map(c -> placed(model, c, weighing))
          .forEach(best::add);
    }
    dictionary.together(model.model()).forEach(p -> best.add(p.components()));
    return best;
  }

  private static double net(List<Component> c, Scorer scorer, Sweep sweep) {
    return scorer.gain(new Proposal(c, false), sweep) - Price.of(c);
  }

  /** Proposals that pass, those with a place at the best few places of each family, and what the model has in finer detail. */
  List<Proposal> all(Predicate<Proposal> allowed) {
    List<Proposal> proposals = new ArrayList<>(dictionary.everywhere(model.model()));
    model.started().stream()
        .flatMap(c -> c.finer().stream())
        .map(Proposal::of)
        .forEach(proposals::add);
    proposals.addAll(bestPlaces());
    proposals.removeIf(allowed.negate());
    return proposals;
  }

  /** Of each family that has a place the best few places, which are not nearly the same. */
  private List<Proposal> bestPlaces() {
    List<List<Place>> families = dictionary.placed(model.model());
    if (families.isEmpty()) {
      return List.of();
    }
    List<Place> all = families.stream().flatMap(List::stream).toList();
    Scorer scorer = new Scorer(model, Place.tiles(all), weighing);
    Sweep sweep = scorer.sweep();
    List<Proposal> kept = new ArrayList<>();
    for (List<Place> family : families) {
      Place.best(family, PLACES_KEPT, scorer, sweep).forEach(p -> kept.add(p.proposal()));
    }
    return kept;
  }

  /** The components of a group that are needed, best first, until the others would gain less than their price. */
  static List<Component> members(Proposal group, Scorer scorer, Sweep at) {
    Sweep sweep = at.copy();
    List<Component> members = new ArrayList<>();
    List<Component> left = new ArrayList<>(group.components());
    while (!left.isEmpty()) {
      Component top = null;
      double most = 0;
      for (Component c : left) {
        double gain = sweep.gain(scorer.columns(c));
        if (gain > most) {
          most = gain;
          top = c;
        }
      }
      if (top == null || !members.isEmpty() && most < Price.of(List.of(top))) {
        break;
      }
      members.add(top);
      left.remove(top);
      for (int column : scorer.columns(top)) {
        sweep.toggle(column);
      }
    }
    return members;
  }

  static Set<Component> components(List<Proposal> proposals) {
    Set<Component> all = new LinkedHashSet<>();
    proposals.forEach(p -> all.addAll(p.components()));
    return all;
  }

  /** Components that are not in the model yet, moved to where they explain most. */
  static List<Component> placed(FittedModel model, List<Component> chosen, Weighing weighing) {
    List<Component> better = new ArrayList<>();
    for (Component c : chosen) {
      boolean known = model.model().components().stream().anyMatch(c::isSameCause);
      boolean moves = c.hasPlace() && !known;
      better.add(moves ? new PlaceSearch(model, weighing).improve(c) : c);
    }
    return better;
  }
}
