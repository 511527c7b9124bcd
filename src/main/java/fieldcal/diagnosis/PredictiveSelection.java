package fieldcal.diagnosis;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.search.SearchStep.Action;
import fieldcal.diagnosis.search.Shortlist;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Forward selection by cross-validation (Stone 1974): effects that all kicks share are added one by one, each time the one with which held-out kicks are followed most closely. Where nothing in the dictionary is right, a search by likelihood would take
 * a dozen effects that together follow these kicks and predict no others. Not thread-safe.
 */
final class PredictiveSelection {
  /** Components that a model may gain. */
  private static final int MOST_ADDED = 6;

  /** How many proposals of the score test are fitted in a round, for each of two weighings; chosen: three maps are among them, and with four in all a push that was right was not tried. */
  private static final int TRIED = 6;

  private final ModelFitter fitter;
  private final Dictionary dictionary;
  private final SharedSolver solver;
  private final long seed;

  /**
   * @param fitter of the kicks
   * @param dictionary what may be added
   * @param solver of the fits
   * @param seed of the parts of the kicks that are held out
   */
  PredictiveSelection(ModelFitter fitter, Dictionary dictionary, SharedSolver solver, long seed) {
    this.fitter = fitter;
    this.dictionary = dictionary;
    this.solver = solver;
    this.seed = seed;
  }

  /** A model with how it does on kicks that were held out. */
  private record Held(FittedModel model, HoldOut held) {}

  /**
   * Adds to a model what helps.
   *
   * @param start fitted to the kicks
   * @param trace to which each step is added
   * @return the start when nothing helps; otherwise a fit in which kicks that it does not explain weigh less
   */
  FittedModel from(FittedModel start, List<SearchStep> trace) {
    // Fitted with the same weights as all that follow, because these alone may help to follow a
    // usual kick more closely.
    Held best = held(start.resumed(), start);
    int most = start.model().components().size() + MOST_ADDED;
    boolean grown = false;
    while (best.model.model().components().size() < most && !fitter.effort().isSpent()) {
      Held next = next(best, trace);
      if (next == best) {
        break;
      }
      best = next;
      grown = true;
    }
    return grown ? best.model : start;
  }

  private Held held(EffectModel model, FittedModel from) {
    FittedModel fitted = fitter.fit(model, from, Weighing.EXPLAINED_FIRST, solver);
    return new Held(fitted, HoldOut.of(fitted, true, seed));
  }

  private Held next(Held before, List<SearchStep> trace) {
    Held best = before;
    List<Component> chosen = List.of();
    for (List<Component> added : proposals(before.model)) {
      List<Component> all = new ArrayList<>(before.model.started());
      all.removeIf(c -> added.stream().anyMatch(c::isSameCause));
      all.addAll(added);
      Held with = held(before.model.resumedWith(all), before.model);
      boolean sound =
          with.held.followsMostBetterThan(before.held, seed)
              && !with.held.predictsMostWorseThan(before.held, seed);
      if (sound && with.held.usualMm() < best.held.usualMm()) {
        best = with;
        chosen = added;
      }
    }
    if (best != before) {
      double[] weights = before.model.solution().problem().weights();
      double gain =
          before.model.solution().costWith(weights) - best.model.solution().costWith(weights);
      trace.add(new SearchStep(chosen.toString(), Action.ADDED, Double.NaN, gain));
    }
    return best;
  }

  private List<List<Component>> proposals(FittedModel model) {
    List<List<Component>> all = new ArrayList<>();
    Stream.of(Weighing.ALIKE, Weighing.EXPLAINED_FIRST)
        .flatMap(w -> new Shortlist(model, dictionary, w).shared(TRIED).stream())
        .filter(c -> all.stream().noneMatch(known -> isSame(known, c)))
        .forEach(all::add);
    return all;
  }

  /** Whether two proposals need not both be fitted. Of curves and maps only the one that promises most is tried in each round: the others have another chance in the next, and each fit of chips takes a second. */
  private static boolean isSame(List<Component> one, List<Component> other) {
    boolean learned = isLearned(one) && isLearned(other);
    return learned || one.toString().equals(other.toString());
  }

  private static boolean isLearned(List<Component> proposal) {
    return proposal.stream().allMatch(c -> c.template() instanceof LearnedTerm);
  }
}
