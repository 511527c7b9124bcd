package fieldcal.diagnosis;

import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.Screening;
import fieldcal.fit.TypicalBall;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Says what the simple model gets wrong, why, and what a better one gains. Stages: screening and base fit, search among the named effects, learned terms for what is left, decision about names, validation, verdict; {@code docs/diagnosis.md} derives
 * them. Immutable and thread-safe; the same input gives the same answer.
 */
public final class Diagnoser {
  /** Kicks whose kind is put right before the search: each round may show others. */
  private static final int BASE_ROUNDS = 4;

  /** How often the kicks are screened again with the model that was found. */
  private static final int SCREENINGS = 3;

  /** With fewer flat kicks the search does not begin with these alone. */
  private static final int FEWEST_FLATS = 6;

  /** Nothing is selected by prediction with fewer kicks: then each is held out alone, and drawing them again says little. */
  private static final int FEWEST_PREDICTED = 6;

  /** What is left must be as large as the noise, in variances, before everything is decided a second time. */
  private static final double MUCH = 1;

  /** Flat kicks whose reduced chi-square stays above that are not explained by themselves. */
  private static final double EXPLAINED = 1.5;

  /** Components of a model beside those that may be named: forms of others, and components that are removed later. */
  private static final int SPARE = 5;

  /** A camera must have made that many detections to be judged. */
  private static final int FEWEST_SEEN = 60;

  private static final int FIT_ITERATIONS = 25;
  private final List<? extends Effect> catalogue;
  private final DecisionSettings settings;

  /** A diagnoser of all effects of the catalogue. */
  public Diagnoser() {
    this(EffectCatalogue.all());
  }

  /**
   * A diagnoser of other effects.
   *
   * @param catalogue absent effects that may be named
   */
  public Diagnoser(List<? extends Effect> catalogue) {
    this.catalogue = List.copyOf(catalogue);
    settings = DecisionSettings.defaults();
  }

  /**
   * Diagnoses. Takes seconds to minutes.
   *
   * @param problem kicks with their fits, cameras, the begin of the session, commands
   * @param progress told in words what is being done, from the calling thread
   * @return the diagnosis; what broke on the way is in {@link Diagnosis#problems}
   * @throws IllegalArgumentException when no kick has enough detections
   */
  public Diagnosis diagnose(DiagnosisProblem problem, Consumer<String> progress) {
    if (problem.fits().isEmpty()) {
      throw new IllegalArgumentException("a diagnosis needs at least one fitted kick");
    }
    return new Run(problem, progress).diagnose();
  }

  /** One diagnosis; used once. */
  private final class Run {
    private final DiagnosisProblem problem;
    private final DiagnosisProgress progress;
    private final SharedSolver solver =
        SharedSolver.withDefaults().withMaxIterations(FIT_ITERATIONS).settlingVariants();

    private final List<SearchStep> trace = new ArrayList<>();
    private final FailedStages failed = new FailedStages();
    private final SampledSearch search;
    private KickScreen screen;
    private ModelFitter fitter;
    private Arena arena;
    private FittedModel base;

    Run(DiagnosisProblem problem, Consumer<String> progress) {
      this.problem = problem;
      this.progress = new DiagnosisProgress(progress);
      search = new SampledSearch(problem.sessionStart(), solver, trace, this.progress);
    }

    Diagnosis diagnose() {
      progress.stage("fitting all kicks together");
      List<KickRecord> kicks = screenAndFit();
      FittedModel found = base;
      if (problem.maxCauses() > 0) {
        found = failed.guarded("the search for causes", base, () -> searchNamed(kicks));
      }
      progress.stage("weighing the explanations");
      return answer(selected(decide(found))).diagnosis(trace, failed.problems());
    }

    private List<KickRecord> screenAndFit() {
      List<KickFit> fits = problem.fits();
      List<boolean[]> kept = fits.stream().map(f -> Screening.kept(f, problem.cameras())).toList();
      MovingNoise noise = MovingNoise.of(fits, kept, problem.cameras());
      List<KickRecord> kicks = new ArrayList<>();
      for (KickFit fit : fits) {
        KickRecord record = KickScreen.record(fit, noise);
        if (record.usedCount() > 2 * record.start().length) {
          kicks.add(record);
        }
      }
      if (kicks.isEmpty()) {
        throw new IllegalArgumentException("no kick has enough detections for a diagnosis");
      }
      EffectModel simple = simple(fits, kicks);
      screen = new KickScreen(noise, simple, problem.sessionStart(), fitSettings());
      for (int round = 0; round < BASE_ROUNDS; round++) {
        fitter = new ModelFitter(kicks, problem.sessionStart(), progress::fitted);
        base = fitter.fit(simple(fits, kicks), solver);
        List<KickRecord> revised = screen.revise(base, false);
        if (revised.equals(kicks)) {
          break;
        }
        kicks = revised;
      }
      if (!fitter.kicks().equals(kicks)) {
        fitter = new ModelFitter(kicks, problem.sessionStart(), progress::fitted);
        base = fitter.fit(simple(fits, kicks), solver);
      }
      arena = arena(kicks);
      return kicks;
    }

    private FitSettings fitSettings() {
      return FitSettings.defaults().withSeed(problem.seed());
    }

    private EffectModel simple(List<KickFit> fits, List<KickRecord> kicks) {
      return EffectModel.simple(
          TypicalBall.flat(fits),
          TypicalBall.chip(fits),
          has(kicks, KickKind.FLAT),
          has(kicks, KickKind.CHIP),
          problem.observers());
    }

    private static boolean has(List<KickRecord> kicks, KickKind kind) {
      return kicks.stream().anyMatch(k -> k.kind() == kind);
    }

    private Arena arena(List<KickRecord> kicks) {
      double x0 = Double.POSITIVE_INFINITY;
      double x1 = Double.NEGATIVE_INFINITY;
      double y0 = Double.POSITIVE_INFINITY;
      double y1 = Double.NEGATIVE_INFINITY;
      Map<Integer, Integer> seen = new HashMap<>();
      for (KickRecord k : kicks) {
        boolean[] used = k.used();
        for (int i = 0; i < used.length; i++) {
          if (used[i]) {
            x0 = Math.min(x0, k.x(i));
            x1 = Math.max(x1, k.x(i));
            y0 = Math.min(y0, k.y(i));
            y1 = Math.max(y1, k.y(i));
            seen.merge(k.camera(i), 1, Integer::sum);
          }
        }
      }
      List<ObservedCamera> cameras =
          problem.observers().stream()
              .filter(c -> seen.getOrDefault(c.id(), 0) >= FEWEST_SEEN)
              .toList();
      return new Arena(
          x0,
          x1,
          y0,
          y1,
          kicks.stream().mapToDouble(k -> k.kick().time() - problem.sessionStart()).toArray(),
          has(kicks, KickKind.FLAT),
          has(kicks, KickKind.CHIP),
          cameras,
          KickerBias.robots(problem.commands()));
    }

    /** Searches among the named effects; kicks that stand out are then screened again with what was found. */
    private FittedModel searchNamed(List<KickRecord> kicks) {
      FittedModel start = easierFirst(kicks);
      for (int round = 0; round < SCREENINGS; round++) {
        progress.stage(round == 0 ? "searching for causes" : "searching for causes again");
        FittedModel found = named(start);
        FittedModel best = fitter.withLowHops(search.alike(fitter, found), solver);
        FittedModel seen = explaining(best, found);
        List<KickRecord> before = fitter.kicks();
        List<KickRecord> revised = screen.revise(seen, true);
        if (revised.equals(before)) {
          revised = screen.withoutStrays(seen);
        }
        if (revised.size() == before.size() && revised.equals(before)) {
          return best;
        }
        progress.stage("looking again at kicks that stand out");
        start = refit(seen, revised);
      }
      return search.alike(fitter, start);
    }

    /** The fit that says which kicks stand out. One that is no free ball leads a fit in which all weigh alike away from the others. */
    private FittedModel explaining(FittedModel alike, FittedModel found) {
      if (!KickScreen.hasStandingOut(alike)) {
        return alike;
      }
      FittedModel deaf = fitter.fit(found.resumed(), found, Weighing.EXPLAINED_ONLY, solver);
      return screen.explainsMost(deaf) ? deaf : alike;
    }

    private FittedModel named(FittedModel start) {
      Dictionary dictionary = new Dictionary(catalogue, arena);
      return search.search(fitter, start, dictionary, problem.maxCauses() + SPARE, true);
    }

    private FittedModel refit(FittedModel best, List<KickRecord> kicks) {
      ModelFitter others = new ModelFitter(kicks, problem.sessionStart(), progress::fitted);
      Arena reach = arena(kicks);
      EffectModel start = best.resumed().in(reach);
      FittedModel again =
          others.fit(start, matching(best, kicks), Weighing.EXPLAINED_FIRST, solver);
      base = others.fit(simple(problem.fits(), kicks), solver);
      fitter = others;
      arena = reach;
      return again;
    }

    /** A fit's kicks as far as they are still there. */
    private FittedModel matching(FittedModel best, List<KickRecord> kicks) {
      return best.kickCount() == kicks.size() ? best : best.restrictedTo(kicks);
    }

    /**
     * Where a search among all kicks begins: at what was found among those that are easier. Chips mask much while their bounces are not understood, and a kick that was touched may leave more than all others; both are looked at again with what the
     * others showed.
     */
    private FittedModel easierFirst(List<KickRecord> kicks) {
      List<KickRecord> quiet = KickScreen.withoutDominant(base);
      List<KickRecord> flats = quiet.stream().filter(k -> k.kind() == KickKind.FLAT).toList();
      FittedModel start = base;
      if (arena.chips() && flats.size() >= FEWEST_FLATS) {
        progress.stage("searching for causes in the flat kicks");
        start = foundAmong(flats, start);
      }
      if (quiet.size() < kicks.size()) {
        progress.stage("searching for causes without the kicks that stand out most");
        start = foundAmong(quiet, start);
      }
      return start;
    }

    /** What is found among some kicks, fitted to all; as it was where that does not explain them. */
    private FittedModel foundAmong(List<KickRecord> some, FittedModel start) {
      ModelFitter all = fitter;
      Arena whole = arena;
      fitter = new ModelFitter(some, problem.sessionStart(), progress::fitted);
      arena = arena(some);
      FittedModel found;
      try {
        EffectModel model = start.model().in(arena);
        found =
            named(
                start == base
                    ? fitter.fit(model, solver)
                    : fitter.fit(
                        model, start.restrictedTo(some), Weighing.EXPLAINED_FIRST, solver));
      } finally {
        fitter = all;
        arena = whole;
      }
      if (found.solution().reducedChiSquare() > EXPLAINED && !screen.explainsMost(found)) {
        return start;
      }
      return fitter.fit(found.resumed().in(arena), base, Weighing.EXPLAINED_FIRST, solver);
    }

    /**
     * What was decided for some kicks.
     *
     * @param screened these kicks and what may explain them
     * @param base the simple model that it is compared with
     * @param heldBase how that one does on kicks that were held out
     * @param best the model that was chosen
     */
    private record Decided(
        DiagnosisCase screened, FittedModel base, HoldOut heldBase, Weighed best) {

      boolean isNothing() {
        return best.model().model().components().isEmpty();
      }

      /** Whether one model follows a usual kick more closely than another one of the same kicks, and predicts none worse. */
      static boolean isCloser(HoldOut one, HoldOut other, long seed) {
        return one.followsMostBetterThan(other, seed)
            && !one.predictsMostWorseThan(other, seed)
            && !one.predictsWorseThan(other, seed);
      }
    }

    private Decided decide(FittedModel found) {
      DiagnosisCase screened =
          new DiagnosisCase(problem, catalogue, settings, fitter, arena, base, solver);
      HoldOut heldBase = HoldOut.of(base, true, problem.seed());
      ModelChoice choice = new ModelChoice(screened, heldBase, trace, progress::part);
      Weighed named = new Weighed(base, List.of(), heldBase);
      if (!found.model().components().isEmpty()) {
        named = choice.of(found);
      }
      Weighed best =
          new UnnamedTerms(screened, choice, heldBase, search, failed, progress).beside(named);
      boolean nothing = best.model().model().components().isEmpty();
      if (nothing || !(best.held().rmsMm() <= heldBase.rmsMm())) {
        best = new Weighed(base, List.of(), heldBase);
      }
      return new Decided(screened, base, heldBase, best);
    }

    /** Where something is left, with what is selected by prediction alone, beside the simple model or what was found. */
    private Decided selected(Decided first) {
      boolean few = fitter.kicks().size() < FEWEST_PREDICTED;
      Leftover leftover = Leftover.of(first.best.model());
      boolean left = leftover.isSignificant() && leftover.systematic() > MUCH;
      if (problem.maxCauses() == 0 || few || !left) {
        return first;
      }
      progress.stage("selecting by prediction");
      return failed.guarded(
          "the selection by prediction",
          first,
          () -> closest(first).flatMap(model -> decided(model, first)).orElse(first));
    }

    /** Of the models that are selected beside the simple model and beside what was found, the one that follows a usual kick most closely; empty where nothing helps. */
    private Optional<FittedModel> closest(Decided first) {
      Dictionary dictionary = dictionary(first);
      return Stream.of(base, first.best.model())
          .distinct()
          .map(start -> search.selected(fitter, start, dictionary, problem.seed(), trace))
          .filter(model -> model != base && model != first.best.model())
          .min(Comparator.comparingDouble(m -> HoldOut.of(m, false, problem.seed()).usualMm()));
    }

    private Dictionary dictionary(Decided beside) {
      List<Effect> effects = new ArrayList<>(catalogue);
      effects.addAll(UnnamedTerms.learned(arena, beside.best.judged()));
      effects.addAll(LearnedLibrary.maps(arena));
      return new Dictionary(effects, arena);
    }

    /**
     * What is decided with a selected model, if it follows a usual kick more closely than what was decided first: without the kicks that stand out while it explains all others; where it does not, with what it leaves of each kick taken
     * for noise, beside the same simple model.
     */
    private Optional<Decided> decided(FittedModel selected, Decided first) {
      List<KickRecord> kept = KickScreen.withoutFew(selected);
      boolean without = kept.size() < selected.kickCount();
      List<KickRecord> heard = without ? kept : KickScreen.withWhatIsLeftAsNoise(selected);
      ModelFitter all = fitter;
      Arena whole = arena;
      FittedModel simple = base;
      try {
        FittedModel again = refit(selected, heard);
        Decided next = decide(search.alike(fitter, again));
        boolean closer = !next.isNothing() && isCloser(next, first, heard, without);
        if (!closer) {
          return Optional.empty();
        }
        return Optional.of(
            without ? next : new Decided(next.screened, first.base, first.heldBase, next.best));
      } finally {
        fitter = all;
        arena = whole;
        base = simple;
      }
    }

    /** Whether what was decided for other kicks, or for the same with other noise, is better than what was decided first: not by their weights alone, but also where the first model is fitted to them. */
    private boolean isCloser(Decided next, Decided first, List<KickRecord> heard, boolean without) {
      FittedModel found = first.best.model();
      EffectModel start = found.resumed().in(arena);
      FittedModel same = fitter.fit(start, matching(found, heard), Weighing.ALIKE, solver);
      HoldOut before = HoldOut.of(same, true, problem.seed());
      HoldOut now = next.best.held();
      if (without) {
        return Decided.isCloser(now, before, problem.seed());
      }
      return Decided.isCloser(now, first.best.held(), problem.seed())
          && !now.predictsMostWorseThan(before, problem.seed())
          && !now.predictsWorseThan(before, problem.seed());
    }

    private Answer answer(Decided decided) {
      Weighed best = decided.best;
      FittedModel extended = best.model();
      List<Cause> kickers =
          extended.reducedAsSeen() < EXPLAINED
              ? new KickerBias(extended, problem.commands(), problem.seed())
                  .causes(catalogue, decided.screened.arena())
              : List.of();
      return new Answer(
          decided.screened,
          decided.base,
          extended,
          best.judged(),
          kickers,
          best.held(),
          decided.heldBase);
    }
  }
}
