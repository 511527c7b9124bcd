package fieldcal.diagnosis;

import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedLibrary;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The stage that decides a second time where much is left, with components that are selected by prediction alone and added to the simple model or to what was found. Not thread-safe. */
final class Selection {
  /** Nothing is selected by prediction with fewer kicks: each would be held out alone, and a bootstrap over them would show little. */
  private static final int FEWEST_KICKS = 6;

  /** What is left must be larger than this, in variances of the noise. */
  private static final double MUCH = 1;

  private final SampledSearch search;
  private final Decider decider;
  private final List<SearchStep> trace;

  /**
   * @param search that selects
   * @param decider of what stays beside what was selected
   * @param trace to which what was selected is added
   */
  Selection(SampledSearch search, Decider decider, List<SearchStep> trace) {
    this.search = search;
    this.decider = decider;
    this.trace = trace;
  }

  /** Whether more than the noise is left, there are enough kicks to show it, and causes may be named at all. */
  static boolean leavesMuch(Decided first) {
    Leftover leftover = Leftover.of(first.model());
    return first.screened().problem().maxCauses() > 0
        && first.model().kickCount() >= FEWEST_KICKS
        && leftover.isSignificant()
        && leftover.systematic() > MUCH;
  }

  /** Whether a selection may help, and the limit of work allows one. */
  static boolean mayHelp(Decided first) {
    return leavesMuch(first) && !first.screened().fitter().effort().isSpent();
  }

  /** What is decided with a model that explains a part of these kicks, if it follows a usual kick more closely, or proves more and is no worse; otherwise what was decided first. */
  Decided with(FittedModel model, Decided first) {
    FittedModel deaf = first.screened().fit(model, Weighing.EXPLAINED_ONLY);
    return decided(deaf, first, true).orElse(first);
  }

  /** What is decided with a selected model, if that follows a usual kick more closely; else what was decided first. */
  Decided beside(Decided first) {
    return closest(first).flatMap(model -> decided(model, first, false)).orElse(first);
  }

  /** Of the models that are selected beside the simple model and beside what was found, the one that follows a usual kick most closely; empty where nothing helps. */
  private Optional<FittedModel> closest(Decided first) {
    DiagnosisCase at = first.screened();
    Dictionary dictionary = dictionary(first);
    return Stream.of(at.base(), first.model())
        .distinct()
        .map(start -> search.selected(at.fitter(), start, dictionary, at.seed(), trace))
        .filter(model -> model != at.base() && model != first.model())
        .min(Comparator.comparingDouble(m -> HoldOut.of(m, false, at.seed()).usualMm()));
  }

  private static Dictionary dictionary(Decided beside) {
    DiagnosisCase at = beside.screened();
    List<Effect> effects = new ArrayList<>(at.catalogue());
    effects.addAll(CurveSearch.learned(at.arena(), beside.best().judged()));
    effects.addAll(LearnedLibrary.maps(at.arena()));
    return new Dictionary(effects, at.arena());
  }

  /**
   * What is decided with a selected model, if it follows a usual kick more closely than what was decided first. If the model nearly explains all kicks but a few, these are left out. Otherwise what it leaves of each kick is taken
   * for that kick's noise, and the result is compared with the first simple model.
   *
   * @param names whether more names suffice if the new model does not follow a usual kick more closely
   */
  private Optional<Decided> decided(FittedModel selected, Decided first, boolean names) {
    List<KickRecord> kept = KickScreen.withoutFew(selected);
    boolean without = kept.size() < selected.kickCount();
    List<KickRecord> heard = without ? kept : KickScreen.withWhatIsLeftAsNoise(selected);
    DiagnosisCase again = first.screened().refitted(heard);
    FittedModel start = again.fit(selected, Weighing.EXPLAINED_FIRST);
    Decided next = decider.decide(again, search.alike(again.fitter(), start));
    if (next.isNothing()) {
      return Optional.empty();
    }
    HoldOut same = heldOnSameKicks(next, first);
    HoldOut before = without ? same : first.best().held();
    return isBetter(next, before, same) || names && provesMore(next, first, before)
        ? Optional.of(without ? next : next.beside(first))
        : Optional.empty();
  }

  /** The first model, fitted to the kicks of the next one with the noise that they have there. */
  private static HoldOut heldOnSameKicks(Decided next, Decided first) {
    FittedModel same = next.screened().fit(first.model(), Weighing.ALIKE);
    return HoldOut.of(same, true, next.screened().seed());
  }

  /**
   * Whether what was decided with fewer kicks, or with other noise, is better than what was decided first.
   *
   * @param before the first model on the kicks of the next one
   * @param same the same with their noise: the weights of the kicks alone do not make the difference
   */
  private static boolean isBetter(Decided next, HoldOut before, HoldOut same) {
    long seed = next.screened().seed();
    HoldOut now = next.best().held();
    return isCloser(now, before, seed)
        && !now.predictsMostWorseThan(same, seed)
        && !now.predictsWorseThan(same, seed);
  }

  /** Whether more has a name, and no kick is followed or predicted worse beyond chance. */
  private static boolean provesMore(Decided next, Decided first, HoldOut before) {
    long seed = next.screened().seed();
    HoldOut now = next.best().held();
    return next.best().names() > first.best().names()
        && !before.followsMostBetterThan(now, seed)
        && !now.predictsMostWorseThan(before, seed)
        && !now.predictsWorseThan(before, seed);
  }

  /** Whether one model follows a usual kick more closely than another one of the same kicks, and predicts none worse. */
  private static boolean isCloser(HoldOut one, HoldOut other, long seed) {
    return one.followsMostBetterThan(other, seed)
        && !one.predictsMostWorseThan(other, seed)
        && !one.predictsWorseThan(other, seed);
  }
}
