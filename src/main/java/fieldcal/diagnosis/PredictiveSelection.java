package fieldcal.diagnosis;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.search.Shortlist;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Forward selection by cross-validation (Stone 1974): what all kicks share is added one by one, each time what follows kicks best that were held out. A search by likelihood leads astray where nothing that it knows is right: it then takes
 * a dozen effects that together follow these kicks and predict no others. Not thread-safe.
 */
final class PredictiveSelection {
  /** Terms that a model may gain. */
  private static final int MOST_ADDED = 6;

  /** Of what the score test proposes, so many are fitted in a round, for each of two weighings. */
  private static final int TRIED = 4;

  private final ModelFitter fitter;
  private final Dictionary dictionary;
  private final SharedSolver solver;
  private final long seed;
  private final List<SearchStep> trace;

  /**
   * @param fitter of the kicks
   * @param dictionary what may be added
   * @param solver of the fits
   * @param seed of the parts of the kicks that are held out
   * @param trace to which each step is added
   */
  PredictiveSelection(
      ModelFitter fitter,
      Dictionary dictionary,
      SharedSolver solver,
      long seed,
      List<SearchStep> trace) {
    this.fitter = fitter;
    this.dictionary = dictionary;
    this.solver = solver;
    this.seed = seed;
    this.trace = trace;
  }

  /** A model with how it does on kicks that were held out. */
  private record Held(FittedModel model, HoldOut held) {}

  /**
   * Adds to a model what helps.
   *
   * @param start fitted to the kicks
   * @return the same when nothing helps; else a fit in which kicks weigh less that it does not explain
   */
  FittedModel from(FittedModel start) {
    Held best = new Held(start, HoldOut.of(start, true, seed));
    for (int i = 0; i < MOST_ADDED; i++) {
      Held next = next(best);
      if (next == best) {
        break;
      }
      best = next;
    }
    return best.model;
  }

  private Held next(Held before) {
    Held best = before;
    for (List<Component> added : proposals(before.model)) {
      List<Component> all = new ArrayList<>(before.model.started());
      all.removeIf(c -> added.stream().anyMatch(c::isSameCause));
      all.addAll(added);
      FittedModel tried =
          fitter.fit(before.model.resumedWith(all), before.model, Weighing.EXPLAINED_FIRST, solver);
      Held with = new Held(tried, HoldOut.of(tried, true, seed));
      boolean sound =
          with.held.followsMostBetterThan(before.held, seed)
              && !with.held.predictsMostWorseThan(before.held, seed);
      if (sound && with.held.usualMm() < best.held.usualMm()) {
        best = with;
      }
    }
    if (best != before) {
      double gain = before.model.evenCost() - best.model.evenCost();
      List<Component> now = best.model.model().components();
      trace.add(
          new SearchStep(
              now.get(now.size() - 1).toString(), SearchStep.Action.ADDED, Double.NaN, gain));
    }
    return best;
  }

  private List<List<Component>> proposals(FittedModel model) {
    List<List<Component>> all = new ArrayList<>();
    Stream.of(Weighing.ALIKE, Weighing.EXPLAINED_FIRST)
        .flatMap(w -> new Shortlist(model, dictionary, w).shared(TRIED).stream())
        .filter(c -> all.stream().noneMatch(known -> known.toString().equals(c.toString())))
        .forEach(all::add);
    return all;
  }
}
