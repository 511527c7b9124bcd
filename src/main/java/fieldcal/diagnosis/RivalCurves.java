package fieldcal.diagnosis;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.search.Price;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import java.util.List;
import java.util.stream.Stream;

/**
 * The stage that lets curves compete with effects that have a place. A region, a seam or an instant is chosen where it absorbs most of whatever has no name; so it keeps its name, or without a name its place in the model, only if curves, and what differs by chance, explain less in its stead. Not thread-safe.
 */
final class RivalCurves {
  /** A coarse fit of curves that follows held-out kicks less closely by so many times what decides is not fitted precisely; chosen: where a region is right, it follows them a third less closely, or worse. */
  private static final double COARSELY = 2;

  private final ModelFitter fitter;
  private final DecisionSettings settings;
  private final long seed;
  private final ModelChoice choice;
  private final CurveSearch curves;
  private final UnnamedTerms unnamed;
  private final DiagnosisProgress progress;

  /**
   * @param problem the screened kicks and what may explain them
   * @param choice which of the components that are found stay
   * @param curves search for learned terms, which may fit coarsely: what wins is fitted again
   * @param unnamed what describes the rest
   * @param progress told in words what is being done
   */
  RivalCurves(
      DiagnosisCase problem,
      ModelChoice choice,
      CurveSearch curves,
      UnnamedTerms unnamed,
      DiagnosisProgress progress) {
    this.choice = choice;
    this.curves = curves;
    this.unnamed = unnamed;
    this.progress = progress;
    fitter = problem.fitter();
    settings = problem.settings();
    seed = problem.seed();
  }

  /**
   * Lets curves compete with all effects that have a place together, then with each: several of them may have taken the place of one curve.
   *
   * @param found what was decided
   * @return the same where each stands; with curves in the place of those that do not, or the same model without their names where no curve predicts as well
   */
  Weighed against(Weighed found) {
    if (fitter.effort().isSpent()) {
      return Leftover.of(found.model()).isSignificant()
          ? found.nameless(placed(found)::contains)
          : found;
    }
    List<Judgement> placed = placed(found);
    Weighed best = found;
    for (List<Judgement> group :
        Stream.concat(Stream.of(placed), placed.stream().map(List::of)).distinct().toList()) {
      if (!group.isEmpty() && best.judged().containsAll(group)) {
        best = against(best, group);
      }
    }
    return best;
  }

  private static List<Judgement> placed(Weighed of) {
    return of.judged().stream().filter(j -> j.component().hasPlace()).toList();
  }

  private Weighed against(Weighed named, List<Judgement> group) {
    FittedModel coarse = curved(named, group);
    if (!follows(coarse).isAsGoodAs(named, COARSELY * settings.formGain())) {
      return named;
    }
    FittedModel curved = curves.settled(coarse);
    if (explainsLess(curved, named, group)) {
      return named;
    }
    Weighed rival = unnamed.beside(choice.of(curved));
    return rival.mayReplace(named, settings.formGain(), seed)
        ? rival
        : named.nameless(group::contains);
  }

  /** The model with curves in place of some components. Maps of the carpet are searched only where curves explain more than half of what these components explain. */
  private FittedModel curved(Weighed named, List<Judgement> group) {
    progress.part("curves instead of causes");
    List<Judgement> rest = named.judged().stream().filter(j -> !group.contains(j)).toList();
    FittedModel without = choice.without(named.model(), named.judged(), group);
    FittedModel curved = curves.nameless(without, rest);
    boolean near = missed(curved, named) < UnnamedTerms.IMITATED * missed(without, named);
    return near ? curves.withMaps(curved, CurveSearch.mostBeside(without)) : curved;
  }

  /**
   * Whether curves follow held-out kicks less closely: by 3 %, which is more than their many numbers cost there; or by less, where they also follow the kicks that they were fitted to less closely. Values that differ by chance from kick to kick follow each held-out kick from its own beginning, so where they
   * are needed they must follow these kicks better beyond chance. Where both follow held-out kicks as closely, curves also explain less if they need so many numbers that they cost more.
   */
  private boolean explainsLess(FittedModel curved, Weighed named, List<Judgement> group) {
    int numbers = group.stream().mapToInt(j -> j.component().size()).sum();
    Weighed held = follows(curved);
    return !held.isAsGoodAs(named, settings.formGain())
        || missed(curved, named) > settings.beyondNoise(numbers) && !isCloser(held, named)
        || named.isAsGoodAs(held, settings.formGain()) && costsMore(curved, named, group);
  }

  private Weighed follows(FittedModel curved) {
    return new Weighed(curved, List.of(), HoldOut.of(curved, true, seed));
  }

  /** Whether curves cost more than effects and their places, by Schwarz's criterion. */
  private static boolean costsMore(FittedModel curved, Weighed named, List<Judgement> group) {
    int places = group.stream().mapToInt(j -> j.effect().places().size()).sum();
    return Price.total(curved) > Price.total(named.model()) + places * Price.PENALTY_PER_COORDINATE;
  }

  private boolean isCloser(Weighed curved, Weighed named) {
    return hasChance(curved) && !hasChance(named)
        ? curved.held().gainOn(named.held(), seed)[HoldOut.LOWER] > 0
        : curved.isAsGoodAs(named, 0);
  }

  private static boolean hasChance(Weighed weighed) {
    return weighed.model().model().components().stream().anyMatch(Component::isChance);
  }

  /** How much less a model explains than another one, in units of what the other leaves. Each additional number counts as one, since it explains as much of the noise. */
  private static double missed(FittedModel model, Weighed other) {
    double noise = Math.max(1, other.model().solution().reducedChiSquare());
    return (model.evenCost() - other.model().evenCost()) / noise
        + numbers(model)
        - numbers(other.model());
  }

  private static int numbers(FittedModel model) {
    return (int) model.model().globals().stream().filter(Parameter::estimated).count();
  }
}
