package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** Moves places and instants of a model's components, and fits everything else again at each step. A {@link PlaceSearch} keeps the rest of the model fixed, so what it finds is only where a component was needed then. Not thread-safe. */
final class PlaceMoves {
  /** Steps of a place that is moved while all else is fitted again. */
  static final int MOST_STEPS = 6;

  /** Most exchanges of a place in a row. */
  private static final int MOST_JUMPS = 3;

  /** Most gaps between kicks over which an instant is moved at once. If the true instant is farther off, the score test shows it. */
  private static final int FARTHEST_GAP = 4;

  /** What a move must gain at least, in units of chi-square: less may be due to where the fits stop. */
  private static final double LEAST_MOVE = 1;

  private final Refits refits;
  private final Price price;
  private final Dictionary dictionary;
  private final double[] kickTimes;

  /**
   * @param refits with the weights of a pursuit
   * @param dictionary of the places
   */
  PlaceMoves(Refits refits, Dictionary dictionary) {
    this.refits = refits;
    this.dictionary = dictionary;
    kickTimes = dictionary.kickTimes();
    price = new Price(refits.weighing());
  }

  /** The model with one place moved step by step, everything else fitted again at each step. A joint fit of all places would stop wherever an edge does not matter to first order. */
  FittedModel relocated(FittedModel from, int index) {
    return relocated(from, index, MOST_STEPS);
  }

  private FittedModel relocated(FittedModel from, int index, int steps) {
    FittedModel at = elsewhere(from, index);
    double share = PlaceSearch.FIRST_STEP;
    for (int round = 0; round < steps; round++) {
      Component now = at.model().components().get(index).startingAt(at.effects().get(index));
      List<Component> tried = PlaceSearch.neighbours(now, share);
      if (tried.isEmpty()) {
        // All such steps leave the range.
        share *= PlaceSearch.SHRINK;
        continue;
      }
      Scorer scorer = new Scorer(at, tried, refits.weighing());
      Sweep sweep = scorer.without(List.of(index));
      Component top =
          tried.stream()
              .max(Comparator.comparingDouble(c -> scorer.gain(Proposal.of(c), sweep)))
              .orElseThrow();
      List<Component> moved = new ArrayList<>(at.model().components());
      moved.set(index, scorer.estimated(top, sweep));
      FittedModel next = refits.fitPlaces(refits.fit(at, moved));
      if (price.gain(at, next) > 0) {
        at = next;
      } else {
        share *= PlaceSearch.SHRINK;
      }
    }
    return at;
  }

  /** The model with one place exchanged for that of all which explains most, if this is better. A bound that no ball crosses has no neighbour that explains more. */
  FittedModel elsewhere(FittedModel from, int index) {
    FittedModel at = from;
    for (int i = 0; i < MOST_JUMPS; i++) {
      FittedModel next = jumped(at, index);
      if (!(price.gain(at, next) > LEAST_MOVE)) {
        break;
      }
      at = next;
    }
    return at;
  }

  private FittedModel jumped(FittedModel at, int index) {
    Component now = at.model().components().get(index).startingAt(at.effects().get(index));
    List<Place> places = dictionary.placesOf(now);
    if (places.isEmpty()) {
      return at;
    }
    Scorer tiles = new Scorer(at, Place.tiles(places), refits.weighing());
    Place top = Place.best(places, 1, tiles, tiles.without(List.of(index))).get(0);
    Component there = now.startingAt(top.component().template());
    if (there.toString().equals(now.toString())) {
      return at;
    }
    Scorer scorer = new Scorer(at, List.of(there), refits.weighing());
    List<Component> moved = new ArrayList<>(at.model().components());
    moved.set(index, scorer.estimated(there, scorer.without(List.of(index))));
    return refits.fitPlaces(refits.fit(at, moved));
  }

  /** With everything that has a place moved, one after another. */
  FittedModel allRelocated(FittedModel from, int steps) {
    FittedModel at = from;
    for (int i = 0; i < from.model().components().size(); i++) {
      at = from.model().components().get(i).hasPlace() ? relocated(at, i, steps) : at;
    }
    return at;
  }

  /**
   * The model with an instant moved from gap to gap between the kicks, everything else fitted again at each. Kicks on the wrong side of the instant bend the model, so that the score test at the bent model would keep the instant where it is; and there is
   * no derivative with respect to an instant across a kick.
   */
  FittedModel atBestInstant(FittedModel from, int index) {
    if (!from.model().components().get(index).isInstant()) {
      return from;
    }
    FittedModel at = from;
    int reach = 1;
    while (reach <= FARTHEST_GAP) {
      FittedModel top = at;
      for (int gaps : new int[] {-reach, reach}) {
        FittedModel tried = shifted(at, index, gaps);
        // If the weights changed with each step, the steps could go round in a circle.
        top = price.gain(from, top, tried) > LEAST_MOVE ? tried : top;
      }
      reach = top == at ? 2 * reach : 1;
      at = top;
    }
    return at;
  }

  /** The same model with an instant so many gaps later; the model itself where there is none. */
  private FittedModel shifted(FittedModel at, int index, int gaps) {
    Component now = at.model().components().get(index).startingAt(at.effects().get(index));
    String name = now.template().places().get(0);
    double instant = now.template().value(name);
    int before = (int) Arrays.stream(kickTimes).filter(t -> t < instant).count() + gaps;
    if (before < 1 || before >= kickTimes.length) {
      return at;
    }
    double there = 0.5 * (kickTimes[before - 1] + kickTimes[before]);
    List<Component> moved = new ArrayList<>(at.model().components());
    moved.set(index, now.startingAt(now.template().with(name, there)));
    return refits.fit(at, moved);
  }
}
