package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.MotionEffect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * A search for the components that explain the kicks. The components that are found first decide where the equations are linearized next, so one pursuit may end in a local minimum. While something is left, further pursuits begin again in another
 * manner (a multi-start), and the best result is revised. Gains are not divided by what is still unexplained: otherwise the second of two strong causes would never seem worth adding. Not thread-safe; used once.
 */
public final class CauseSearch {
  /** A reduced chi-square below this needs no further search: the residuals are then less than a tenth above the noise. */
  private static final double EXPLAINED = 1.2;

  /** Share of the kicks that must be explained. */
  private static final double MOST_KICKS = 0.85;

  /** A further pursuit is preferred only if it leaves less than this share of what the best one so far leaves. Where no component is right, each pursuit leaves a different amount by chance. */
  private static final double ANEW = 0.5;

  /**
   * How a pursuit goes about it.
   *
   * @param weighing how much kicks count that are not explained yet
   * @param order what comes first
   */
  private record Manner(Weighing weighing, Pursuit.Order order) {}

  /** In the order in which they are tried. Those that explained most recordings come first. */
  private static final List<Manner> MANNERS =
      List.of(
          new Manner(Weighing.EXPLAINED_FIRST, Pursuit.Order.BEST),
          new Manner(Weighing.BETWEEN, Pursuit.Order.BEST),
          new Manner(Weighing.EXPLAINED_FIRST, Pursuit.Order.SHARED),
          new Manner(Weighing.ALIKE, Pursuit.Order.BEST),
          new Manner(Weighing.BETWEEN, Pursuit.Order.SHARED),
          new Manner(Weighing.ALIKE, Pursuit.Order.SHARED));

  /** Pursuits in a row without success, after which no further one starts: where no cause is right, none succeeds, and the last ones take longest. In 21 recordings of other generators, the first or the second pursuit explained every recording that any of the six explained. */
  private static final int MOST_IN_VAIN = 3;

  /** Chance must matter in more than this many kicks: the kicks other than the ones that gain most need the following share of the gain. The numbers are those of the decision. */
  private static final int FEW_KICKS = 2;

  private static final double LEAST_SHARE = 0.15;

  /** Among models that explain the kicks, prefers the one in which fewer things differ from kick to kick, since each of these absorbs a part of anything; then the one with the lower price. */
  private static final Comparator<FittedModel> FEWEST_VALUES =
      Comparator.<FittedModel>comparingLong(
              m -> m.model().components().stream().filter(Component::isPerKick).count())
          .thenComparingDouble(Price::total);

  /** The manners of a search that only adds to a model. What differs from kick to kick may be all there is, and curves would absorb much of it. */
  private static final List<Manner> SHORT =
      List.of(
          new Manner(Weighing.EXPLAINED_FIRST, Pursuit.Order.BEST),
          new Manner(Weighing.EXPLAINED_FIRST, Pursuit.Order.RANDOM));

  private final ModelFitter fitter;
  private final int maxComponents;
  private final SharedSolver solver;
  private final Consumer<String> progress;
  private final List<SearchStep> trace = new ArrayList<>();

  /** Replaced by one with other forms of what every ball does where these explain much more: what is wrong in every kick hides all causes, and several imitate it. Where causes alone explain the kicks, curves would only absorb a part of them. */
  private Dictionary dictionary;

  /**
   * A search.
   *
   * @param fitter of the kicks
   * @param dictionary what may be proposed
   * @param maxComponents how many components a model may have
   * @param solver of the refits
   * @param progress told in words which part of the search begins
   */
  public CauseSearch(
      ModelFitter fitter,
      Dictionary dictionary,
      int maxComponents,
      SharedSolver solver,
      Consumer<String> progress) {
    this.fitter = fitter;
    this.dictionary = dictionary;
    this.maxComponents = maxComponents;
    this.solver = solver;
    this.progress = progress;
  }

  /**
   * What was tried.
   *
   * @return in order
   */
  public List<SearchStep> trace() {
    return List.copyOf(trace);
  }

  /**
   * Searches.
   *
   * @param start the model to begin with, fitted to the same kicks
   * @param revises whether early choices are reconsidered when something is left, and simpler models are sought; otherwise what the model already has stays, except where a law that is added explains it as well
   * @return the best model found
   */
  public FittedModel search(FittedModel start, boolean revises) {
    FittedModel best = start;
    Refits refits = refits(Weighing.EXPLAINED_FIRST);
    boolean free = revises && start.model().components().isEmpty();
    boolean random = !dictionary.random(start.model()).isEmpty();
    List<Manner> manners = free ? MANNERS : SHORT.subList(0, random ? 2 : 1);
    int inVain = 0;
    for (Manner manner : manners) {
      progress.accept("attempt " + (manners.indexOf(manner) + 1) + " of at most " + manners.size());
      Refits own = refits(manner.weighing);
      FittedModel grown = pursuit(own).grown(start, manner.order, revises);
      if (Price.total(grown) < (best == start ? 1 : ANEW) * Price.total(best)) {
        best = grown;
        refits = own;
        inVain = 0;
      } else {
        inVain++;
      }
      if (isExplained(best) || inVain == MOST_IN_VAIN || fitter.effort().isSpent()) {
        break;
      }
    }
    Optional<Dictionary> wider = dictionary.withForms();
    if (revises && wider.isPresent() && !isExplained(best) && !fitter.effort().isSpent()) {
      progress.accept("an attempt with curves for what every ball does");
      Refits own = refits(Weighing.EXPLAINED_FIRST);
      Pursuit pursuit = new Pursuit(own, wider.get(), maxComponents, trace);
      FittedModel grown = pursuit.grown(start, Pursuit.Order.BEST, true);
      if (Price.total(grown) < ANEW * Price.total(best)) {
        best = grown;
        refits = own;
        dictionary = wider.get();
      }
    }
    if (fitter.effort().isSpent()) {
      return best;
    }
    Simplification simplification = new Simplification(refits, dictionary, trace);
    if (!revises) {
      return simplification.withLawForOther(best, start.model().components()).orElse(best);
    }
    if (free || best != start) {
      // What an earlier search has exchanged and moved cannot be improved now.
      if (!isExplained(best)) {
        progress.accept("exchanging early choices");
        best = pursuit(refits).revised(best);
      }
      best = pursuit(refits).settled(best);
    }
    progress.accept("looking for simpler models");
    FittedModel simplest = simplification.simplified(best, maxComponents);
    return chanceMayBeBehind(simplest) ? besideChance(start, simplest) : simplest;
  }

  /** Whether the model has several effects on the motion, all of which may imitate something that differs from kick to kick by chance. */
  private static boolean chanceMayBeBehind(FittedModel model) {
    return model.model().components().stream()
            .filter(c -> c.template() instanceof MotionEffect && !c.isLaw())
            .count()
        > 1;
  }

  /**
   * A model with something that differs from kick to kick by chance, if it explains the kicks at a lower price; otherwise what was found. Two such models are compared, because each may end in a local minimum. One is what was found, with chance added: it may keep effects that only together imitate chance.
   * The other comes from a search that begins with chance: it does not see a cause beside kicks that are far off for another reason.
   */
  private FittedModel besideChance(FittedModel start, FittedModel found) {
    FittedModel best = found;
    for (Component chance : dictionary.chance(start.model())) {
      Refits refits = refits(Weighing.EXPLAINED_FIRST);
      FittedModel beside = refits.fit(found, with(found, chance));
      if (!mayBeBehind(chance, found, beside, refits)) {
        continue;
      }
      FittedModel begun = refits.fit(start, with(start, chance));
      FittedModel grown = pursuit(refits).grown(begun, Pursuit.Order.BEST, true);
      FittedModel before = best;
      best =
          Stream.of(beside, pursuit(refits).settled(grown))
              .map(model -> new Chance(refits, trace).onlyWhatIsNeeded(model))
              .filter(m -> isExplained(m) && Price.total(m) < Price.total(before))
              .filter(m -> differsInMostKicks(chance, m, refits))
              .min(FEWEST_VALUES)
              .orElse(before);
    }
    return best;
  }

  /** Whether chance is needed beside what was found, or explains as much as the other components with a value for each kick. */
  private static boolean mayBeBehind(
      Component chance, FittedModel found, FittedModel beside, Refits refits) {
    if (!isExplained(beside)) {
      return false;
    }
    if (new Price(refits.weighing()).gain(found, beside) > Price.of(List.of(chance))) {
      return true;
    }
    List<Component> all = beside.model().components();
    List<Component> shared =
        all.stream().filter(c -> c.isSameCause(chance) || !c.isPerKick()).toList();
    return shared.size() < all.size() && isExplained(refits.fit(found, shared));
  }

  /** Whether chance is still needed, and not only by a few kicks: in these the ball may not have been free, or they may hide a cause. */
  private static boolean differsInMostKicks(Component chance, FittedModel needed, Refits refits) {
    List<Component> rest = new ArrayList<>(needed.model().components());
    return rest.removeIf(chance::isSameCause)
        && needed.shareOfMost(refits.fit(needed, rest), FEW_KICKS) > LEAST_SHARE;
  }

  private static List<Component> with(FittedModel model, Component added) {
    List<Component> all = new ArrayList<>(model.model().components());
    all.add(added);
    return all;
  }

  private Refits refits(Weighing weighing) {
    return new Refits(fitter, weighing, solver);
  }

  private Pursuit pursuit(Refits refits) {
    return new Pursuit(refits, dictionary, maxComponents, trace);
  }

  /**
   * Only simplifies: replaces components by simpler ones, or by a law that explains the same.
   *
   * @param model the model to begin with
   * @return the model, or a simpler one that explains as much
   */
  public FittedModel simplified(FittedModel model) {
    Refits refits = refits(Weighing.EXPLAINED_FIRST);
    return new Simplification(refits, dictionary, trace).simplified(model, maxComponents);
  }

  /**
   * Replaces some components by effects that explain as much.
   *
   * @param which may be replaced
   * @param model fitted to the same kicks
   * @return the model, or one with effects in their place
   */
  public FittedModel without(Predicate<Component> which, FittedModel model) {
    return new Simplification(refits(Weighing.EXPLAINED_FIRST), dictionary, trace)
        .without(which, model);
  }

  /** Whether hardly more than noise is left, over all kicks or in most of them. In the others the ball may not have been free. */
  private static boolean isExplained(FittedModel model) {
    int well = 0;
    for (int k = 0; k < model.kickCount(); k++) {
      well += model.reduced(k) < EXPLAINED * EXPLAINED ? 1 : 0;
    }
    return model.solution().reducedChiSquare() < EXPLAINED || well > MOST_KICKS * model.kickCount();
  }
}
