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
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

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
      Decided first = decide(found);
      Decided last = failed.guarded("the selection by prediction", first, () -> selected(first));
      return answer(last).diagnosis(trace, failed.problems());
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
      fitter = new ModelFitter(kicks, problem.sessionStart(), progress::fitted);
      arena = arena(kicks);
      EffectModel start = best.resumed().in(arena);
      FittedModel again =
          fitter.fit(start, matching(best, kicks), Weighing.EXPLAINED_FIRST, solver);
      base = fitter.fit(simple(problem.fits(), kicks), solver);
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
      List<KickRecord> quiet = KickScreen.withoutLoud(base);
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
     * @param heldBase how the simple model does on kicks that were held out
     * @param best the model that was chosen
     */
    private record Decided(DiagnosisCase screened, HoldOut heldBase, Weighed best) {
      /** Whether this follows a usual kick more closely than another decision, and predicts none worse, of the kicks that both know. */
      boolean isCloserThan(Decided other) {
        List<Kick> mine = kicks();
        List<Kick> theirs = other.kicks();
        List<Kick> both = mine.stream().filter(theirs::contains).toList();
        HoldOut now = best.held().restrictedTo(both.stream().mapToInt(mine::indexOf).toArray());
        HoldOut before =
            other.best.held().restrictedTo(both.stream().mapToInt(theirs::indexOf).toArray());
        long seed = screened.seed();
        return now.followsMostBetterThan(before, seed)
            && !now.predictsMostWorseThan(before, seed)
            && !now.predictsWorseThan(before, seed);
      }

      private List<Kick> kicks() {
        return best.model().records().stream().map(KickRecord::kick).toList();
      }
    }

    private DiagnosisCase screened() {
      return new DiagnosisCase(problem, catalogue, settings, fitter, arena, base, solver);
    }

    private Decided decide(FittedModel found) {
      DiagnosisCase screened = screened();
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
      return new Decided(screened, heldBase, best);
    }

    /** Where something is left, with what is selected by prediction alone, if it follows a usual kick more closely and predicts no worse. */
    private Decided selected(Decided first) {
      if (problem.maxCauses() == 0 || !Leftover.of(first.best.model()).isSignificant()) {
        return first;
      }
      progress.stage("selecting by prediction");
      List<Effect> effects = new ArrayList<>(catalogue);
      effects.addAll(LearnedLibrary.of(arena));
      effects.addAll(LearnedLibrary.maps(arena));
      PredictiveSelection selection =
          new PredictiveSelection(
              fitter, new Dictionary(effects, arena), solver, problem.seed(), trace);
      Decided best = first;
      for (FittedModel start : new LinkedHashSet<>(List.of(base, first.best.model()))) {
        FittedModel with = selection.from(start);
        if (with != start) {
          Decided next = decided(with, first);
          best = next.isCloserThan(best) ? next : best;
        }
      }
      return best;
    }

    /** What is decided with a selected model: without the kicks that stand out while it explains all others; where these are many, with what it leaves of each kick taken for noise, beside the same simple model. */
    private Decided decided(FittedModel selected, Decided first) {
      List<KickRecord> kept = screen.withoutStrays(selected);
      if (kept.size() < selected.kickCount()) {
        return decidedFor(kept, selected);
      }
      Decided loud = decidedFor(KickScreen.louder(selected), selected);
      DiagnosisCase screened = loud.screened.comparedWith(first.screened.base());
      return new Decided(screened, first.heldBase, loud.best);
    }

    private Decided decidedFor(List<KickRecord> kicks, FittedModel found) {
      ModelFitter all = fitter;
      Arena whole = arena;
      FittedModel simple = base;
      try {
        FittedModel again = refit(found, kicks);
        return decide(search.alike(fitter, again));
      } finally {
        fitter = all;
        arena = whole;
        base = simple;
      }
    }

    private Answer answer(Decided decided) {
      Weighed best = decided.best;
      FittedModel extended = best.model();
      List<Cause> kickers =
          extended.solution().reducedChiSquare() < EXPLAINED
              ? new KickerBias(extended, problem.commands(), problem.seed())
                  .causes(catalogue, decided.screened.arena())
              : List.of();
      return new Answer(
          decided.screened, extended, best.judged(), kickers, best.held(), decided.heldBase);
    }
  }
}
