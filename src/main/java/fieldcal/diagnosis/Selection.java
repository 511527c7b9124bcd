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
import java.util.function.BiPredicate;
import java.util.stream.Stream;

/** The stage that decides a second time where much is left: with what is selected by prediction alone, beside the simple model or beside what was found. Not thread-safe. */
final class Selection {
  /** Nothing is selected by prediction with fewer kicks: then each is held out alone, and drawing them again says little. */
  private static final int FEWEST_KICKS = 6;

  /** What is left must be as large as the noise, in variances. */
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

  /** Whether what is left is as large as the noise, and there are kicks enough to say so. */
  static boolean leavesMuch(Decided first) {
    Leftover leftover = Leftover.of(first.model());
    return first.screened().problem().maxCauses() > 0
        && first.model().kickCount() >= FEWEST_KICKS
        && leftover.isSignificant()
        && leftover.systematic() > MUCH;
  }

  /** Whether a selection may help, and there is still time for one. */
  static boolean mayHelp(Decided first) {
    return leavesMuch(first) && !first.screened().fitter().effort().isSpent();
  }

  /** What is decided with a model of these kicks that explains a part of them, if that follows a usual kick more closely, or proves more and is no worse; else what was decided first. */
  Decided with(FittedModel model, Decided first) {
    FittedModel deaf = first.screened().fit(model, Weighing.EXPLAINED_ONLY);
    return decided(deaf, first, Selection::provesMore).orElse(first);
  }

  /** What is decided with a selected model, if that follows a usual kick more closely; else what was decided first. */
  Decided beside(Decided first) {
    return closest(first).flatMap(model -> decided(model, first, (n, f) -> false)).orElse(first);
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
   * What is decided with a selected model, if it follows a usual kick more closely than what was decided first: without the kicks that stand out while it explains all others; where it does not, with what it leaves of each kick taken
   * for noise, beside the same simple model.
   *
   * @param enough what is enough where the other follows a usual kick as closely
   */
  private Optional<Decided> decided(
      FittedModel selected, Decided first, BiPredicate<Decided, Decided> enough) {
    List<KickRecord> kept = KickScreen.withoutFew(selected);
    boolean without = kept.size() < selected.kickCount();
    List<KickRecord> heard = without ? kept : KickScreen.withWhatIsLeftAsNoise(selected);
    DiagnosisCase again = first.screened().refitted(heard);
    FittedModel start = again.fit(selected, Weighing.EXPLAINED_FIRST);
    Decided next = decider.decide(again, search.alike(again.fitter(), start));
    if (next.isNothing() || !isBetter(next, first, without) && !enough.test(next, first)) {
      return Optional.empty();
    }
    return Optional.of(without ? next : next.beside(first));
  }

  /** Whether what was decided for other kicks, or for the same with other noise, is better than what was decided first: not by their weights alone, but also where the first model is fitted to them. */
  private static boolean isBetter(Decided next, Decided first, boolean without) {
    long seed = next.screened().seed();
    FittedModel same = next.screened().fit(first.model(), Weighing.ALIKE);
    HoldOut before = HoldOut.of(same, true, seed);
    HoldOut now = next.best().held();
    if (without) {
      return isCloser(now, before, seed);
    }
    return isCloser(now, first.best().held(), seed)
        && !now.predictsMostWorseThan(before, seed)
        && !now.predictsWorseThan(before, seed);
  }

  /** Whether more has a name, and no kick is followed or predicted worse beyond chance. */
  private static boolean provesMore(Decided next, Decided first) {
    long seed = next.screened().seed();
    HoldOut now = next.best().held();
    HoldOut before = first.best().held();
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
