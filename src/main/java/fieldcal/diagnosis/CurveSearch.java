package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.Price;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.learned.LearnedLibrary;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Searches for terms without a name that describe what a model leaves: smooth curves over everything that is recorded, values that differ from kick to kick by chance, periodic terms, and maps of the carpet. Not thread-safe. */
final class CurveSearch {
  /** Most learned terms that are added to a model; chosen: a third already describes what the first two leave. */
  static final int MOST_LEARNED = 3;

  /** A residual of held-out kicks up to so many times the noise is about as good as the noise allows; chosen: where all causes were found in recordings of another generator, the median was 1.08. */
  private static final double FORETOLD = 1.1;

  private final SampledSearch search;
  private final FailedStages failed;
  private final ModelFitter fitter;
  private final Arena arena;
  private final List<? extends Effect> catalogue;
  private final DecisionSettings settings;
  private final double sessionStart;
  private final long seed;

  /** Fits what a search found once more, all kicks alike. */
  private final UnaryOperator<FittedModel> refit;

  /**
   * @param problem the screened kicks and what may explain them
   * @param search for components
   * @param failed told of searches that fail
   */
  CurveSearch(DiagnosisCase problem, SampledSearch search, FailedStages failed) {
    this(problem, search, failed, m -> search.alike(problem.fitter(), m));
  }

  private CurveSearch(
      DiagnosisCase problem,
      SampledSearch search,
      FailedStages failed,
      UnaryOperator<FittedModel> refit) {
    this.search = search;
    this.failed = failed;
    this.refit = refit;
    fitter = problem.fitter();
    arena = problem.arena();
    catalogue = problem.catalogue();
    settings = problem.settings();
    sessionStart = problem.problem().sessionStart();
    seed = problem.seed();
  }

  /** A search whose models are fitted coarsely, for a first comparison: the values that each kick has of its own take long to settle beside a map. */
  static CurveSearch coarse(DiagnosisCase problem, SampledSearch search, FailedStages failed) {
    return new CurveSearch(problem, search, failed, m -> search.nearlyAlike(problem.fitter(), m));
  }

  /** The same model fitted precisely, all kicks alike; as it is where that fails. */
  FittedModel settled(FittedModel found) {
    return failed.guarded("the fit of curves", found, () -> search.alike(fitter, found));
  }

  /**
   * Curves or laws, and maps for what these leave.
   *
   * @param start the model to add to
   * @param judged what was decided about its components
   * @param chance whether kicks may differ by chance
   * @return the same when nothing helps
   */
  FittedModel beside(FittedModel start, List<Judgement> judged, boolean chance) {
    List<Effect> sure = learned(arena, judged);
    // Once the model has what hid a law before, the law may be right after all.
    catalogue.stream().filter(e -> !e.starts().isEmpty()).forEach(sure::add);
    List<Effect> all = new ArrayList<>(sure);
    if (chance) {
      all.addAll(EffectCatalogue.unnamed());
    }
    FittedModel any = with(all, start);
    FittedModel first = withoutIdleChance(any, start, sure);
    all = first == any ? all : sure;
    FittedModel curved = withMaps(first, mostBeside(start));
    if (fitter.effort().isSpent()) {
      return curved;
    }
    HoldOut held = held(curved);
    boolean foretells = held.rmsMm() <= FORETOLD * Quality.of(curved, held).noiseMm();
    if (foretells && !isLeft(curved)) {
      return curved;
    }
    FittedModel mapped = withMaps(start, start.model().components().size());
    if (mapped == start) {
      return curved;
    }
    FittedModel both = with(all, mapped);
    if (foretells) {
      return cheaper(curved, both);
    }
    // Curves that follow all kicks and hardly the next one cost more than their price says.
    return held(both).rmsMm() < held.rmsMm() ? both : curved;
  }

  /**
   * The model with terms alone, where what was found has values that differ from kick to kick by chance and do not help to predict, and it predicts better. Such values also absorb what depends on where each kick went, and then leave too little of it to a curve or a map, which would predict the next kick.
   */
  private FittedModel withoutIdleChance(FittedModel found, FittedModel start, List<Effect> sure) {
    if (!hasChance(found) || fitter.effort().isSpent()) {
      return found;
    }
    HoldOut byChance = predicted(found);
    if (predicted(start).predictsMostWorseThan(byChance, seed)) {
      return found;
    }
    FittedModel without = with(sure, start);
    return predicted(without).errorFactor(byChance) < 1 ? without : found;
  }

  private static boolean hasChance(FittedModel model) {
    return model.model().components().stream().anyMatch(Component::isChance);
  }

  private HoldOut predicted(FittedModel model) {
    return HoldOut.of(model, true, seed);
  }

  private HoldOut held(FittedModel model) {
    return HoldOut.of(model, false, seed);
  }

  /** Curves over the place absorb a part of what a map alone describes, and then a map explains too little of the rest; so the map may also come first. */
  private static FittedModel cheaper(FittedModel curved, FittedModel mapped) {
    return Price.total(mapped) < Price.total(curved) ? mapped : curved;
  }

  /** Curves and chance, but no laws or maps. */
  FittedModel nameless(FittedModel start, List<Judgement> judged) {
    List<Effect> all = learned(arena, judged);
    all.addAll(EffectCatalogue.unnamed());
    return with(all, start);
  }

  private FittedModel with(List<Effect> effects, FittedModel start) {
    return failed.guarded(
        "the search for learned terms",
        start,
        () -> {
          List<Effect> all = new ArrayList<>(effects);
          all.addAll(PeriodicTerms.of(start, arena, sessionStart));
          FittedModel curved = search(start, all, mostBeside(start));
          boolean grown = curved.model().components().size() > start.model().components().size();
          return grown && isLeft(curved)
              ? search(curved, PeriodicTerms.of(curved, arena, sessionStart), mostBeside(start) + 1)
              : curved;
        });
  }

  /** Maps for what curves leave. */
  FittedModel withMaps(FittedModel curved, int most) {
    return failed.guarded(
        "the search for maps of the carpet",
        curved,
        () -> {
          if (!isLeft(curved)) {
            return curved;
          }
          FittedModel mapped = search(curved, LearnedLibrary.maps(arena), most + 1);
          return showInMostKicks(mapped, curved) ? mapped : curved;
        });
  }

  /** Whether the gain does not come from a few kicks. A map has so many numbers that it also leads the path of a ball that was touched. */
  private boolean showInMostKicks(FittedModel mapped, FittedModel without) {
    return mapped.shareOfMost(without, Decision.TOO_FEW_KICKS) > settings.fewKicks();
  }

  /** How many components a model may have that is grown from another one. */
  static int mostBeside(FittedModel start) {
    return start.model().components().size() + MOST_LEARNED;
  }

  private boolean isLeft(FittedModel model) {
    return !fitter.effort().isSpent() && Leftover.of(model).isSignificant();
  }

  /**
   * Learned terms that may be added to what was judged. Beside a named cause that changes the ground with time, no curve over time is offered: such a curve can imitate the cause, and would take its place for the little that the cause does not explain.
   */
  static List<Effect> learned(Arena arena, List<Judgement> judged) {
    boolean timed = judged.stream().anyMatch(CurveSearch::isTimed);
    List<Effect> all = new ArrayList<>(LearnedLibrary.of(arena));
    all.removeIf(e -> timed && LawForValues.changesGroundWithTime(e));
    return all;
  }

  private static boolean isTimed(Judgement j) {
    return j.isName() && LawForValues.changesGroundWithTime(j.effect());
  }

  private FittedModel search(FittedModel start, List<? extends Effect> effects, int most) {
    if (effects.isEmpty()) {
      return start;
    }
    FittedModel found = search.search(fitter, start, new Dictionary(effects, arena), most, false);
    return refit.apply(found);
  }
}
