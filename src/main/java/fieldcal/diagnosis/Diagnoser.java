package fieldcal.diagnosis;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.CauseSearch;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.Screening;
import fieldcal.fit.TypicalBall;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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

  /** Learned terms that a model may have; a third already describes what the first two leave. */
  private static final int MOST_LEARNED = 3;

  /** From more kicks on the search looks at that many, spread over the session; fits and decisions use all. */
  private static final int SEARCHED_KICKS = 60;

  /** A camera must have made that many detections to be judged. */
  private static final int FEWEST_SEEN = 60;

  /** A simpler model is taken unless a larger one predicts held-out kicks better by that share: a tenth of the noise's excess that matters. */
  private static final double CLEARLY_BETTER = 0.01;

  /** Change of a cause's size by which a learned term beside it has taken its place, as a share. */
  private static final double SUPPLANTED = 0.5;

  /** Curves alone must leave at most that share of the held-out variance that causes with names leave: by less they are another description of the same. */
  private static final double IMITATED = 0.5;

  private static final int FIT_ITERATIONS = 25;
  private static final int COARSE_ITERATIONS = 15;

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
   * Diagnoses.
   *
   * @param problem kicks and cameras
   * @param progress told in words what is being done, from the calling thread
   * @return the diagnosis
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

    /** Of a search only the differences between models count. */
    private final SharedSolver coarse =
        solver.withTolerance(1).withMaxIterations(COARSE_ITERATIONS);

    private final List<SearchStep> trace = new ArrayList<>();
    private final List<String> problems = new ArrayList<>();
    private KickScreen screen;
    private ModelFitter fitter;
    private Arena arena;
    private FittedModel base;

    Run(DiagnosisProblem problem, Consumer<String> progress) {
      this.problem = problem;
      this.progress = new DiagnosisProgress(progress);
    }

    Diagnosis diagnose() {
      progress.stage("fitting all kicks together");
      List<KickRecord> kicks = screenAndFit();
      FittedModel found = base;
      if (problem.maxCauses() > 0) {
        found = guarded("the search for causes", base, () -> searchNamed(kicks));
      }
      progress.stage("weighing the explanations");
      Answer answer = decide(found);
      return result(answer);
    }

    /** A stage that fails costs what it would have found, not the diagnosis. */
    private FittedModel guarded(String what, FittedModel otherwise, Stage stage) {
      try {
        return stage.run();
      } catch (RuntimeException e) {
        problems.add(what + " failed: " + e);
        return otherwise;
      }
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
      FittedModel best = flatsFirst(kicks);
      for (int round = 0; round < SCREENINGS; round++) {
        progress.stage(round == 0 ? "searching for causes" : "searching for causes again");
        best = search(best, catalogue, problem.maxCauses() + SPARE, true);
        List<KickRecord> before = fitter.kicks();
        List<KickRecord> revised = screen.revise(best, true);
        if (revised.equals(before)) {
          revised = screen.withoutStrays(best);
        }
        if (revised.size() == before.size() && revised.equals(before)) {
          break;
        }
        progress.stage("looking again at kicks that stand out");
        best = refit(best, revised);
      }
      return best;
    }

    private FittedModel refit(FittedModel best, List<KickRecord> kicks) {
      fitter = new ModelFitter(kicks, problem.sessionStart(), progress::fitted);
      arena = arena(kicks);
      EffectModel start =
          best.model().startingAt(best.solution().values(), best.solution().scatters()).in(arena);
      FittedModel again = fitter.fit(start, matching(best, kicks), Weighing.ALIKE, solver);
      base = fitter.fit(simple(problem.fits(), kicks), solver);
      return again;
    }

    /** A fit's kicks as far as they are still there. */
    private FittedModel matching(FittedModel best, List<KickRecord> kicks) {
      return best.kickCount() == kicks.size() ? best : best.restrictedTo(kicks);
    }

    /** Chips mask much while their bounces are not understood: where there are enough flat kicks, their causes are searched for first. */
    private FittedModel flatsFirst(List<KickRecord> kicks) {
      List<KickRecord> flats = kicks.stream().filter(k -> k.kind() == KickKind.FLAT).toList();
      if (!arena.chips() || flats.size() < FEWEST_FLATS) {
        return base;
      }
      ModelFitter all = fitter;
      Arena whole = arena;
      fitter = new ModelFitter(flats, problem.sessionStart(), progress::fitted);
      arena = arena(flats);
      FittedModel found;
      try {
        FittedModel alone = fitter.fit(base.model().forKinds(true, false), solver);
        progress.stage("searching for causes in the flat kicks");
        found = search(alone, catalogue, problem.maxCauses() + SPARE, true);
      } finally {
        fitter = all;
        arena = whole;
      }
      if (found.solution().reducedChiSquare() > EXPLAINED) {
        return base;
      }
      EffectModel start =
          found
              .model()
              .startingAt(found.solution().values(), found.solution().scatters())
              .in(arena);
      return fitter.fit(start, base, Weighing.EXPLAINED_FIRST, solver);
    }

    private FittedModel search(
        FittedModel start, List<? extends Effect> effects, int most, boolean revises) {
      int n = start.kickCount();
      if (n <= SEARCHED_KICKS) {
        CauseSearch search =
            new CauseSearch(fitter, new Dictionary(effects, arena), most, coarse, progress::part);
        FittedModel found = search.search(start, revises);
        trace.addAll(search.trace());
        return evenly(found);
      }
      List<KickRecord> some = new ArrayList<>();
      for (int i = 0; i < SEARCHED_KICKS; i++) {
        some.add(fitter.kicks().get((int) ((long) i * n / SEARCHED_KICKS)));
      }
      ModelFitter few = new ModelFitter(some, problem.sessionStart(), progress::fitted);
      FittedModel begin =
          few.fit(
              start.model().startingAt(start.solution().values(), start.solution().scatters()),
              start.restrictedTo(some),
              Weighing.ALIKE,
              solver);
      CauseSearch search =
          new CauseSearch(few, new Dictionary(effects, arena), most, coarse, progress::part);
      FittedModel found = search.search(begin, revises);
      trace.addAll(search.trace());
      EffectModel model =
          found.model().startingAt(found.solution().values(), found.solution().scatters());
      return fitter.fit(model, start, Weighing.ALIKE, solver);
    }

    /** The search gave kicks that it did not explain less weight; decisions give all the same. */
    private FittedModel evenly(FittedModel found) {
      EffectModel model =
          found.model().startingAt(found.solution().values(), found.solution().scatters());
      return fitter.fit(model, found, Weighing.ALIKE, solver);
    }

    /** What was decided: the model to predict with, and the judgements of what is in it. */
    private record Answer(
        FittedModel extended,
        List<Judgement> judged,
        List<Cause> kickers,
        HoldOut held,
        HoldOut heldBase) {}

    private Decision decision() {
      return new Decision(settings, fresh(), alternatives(), problem.seed());
    }

    private FreshFit fresh() {
      return new FreshFit(fitter, base, solver);
    }

    private Alternatives alternatives() {
      return new Alternatives(fitter, dictionary());
    }

    private Dictionary dictionary() {
      return new Dictionary(catalogue, arena);
    }

    private Answer decide(FittedModel found) {
      long seed = problem.seed();
      HoldOut heldBase = HoldOut.of(base, true, seed);
      ModelChoice choice =
          new ModelChoice(
              fresh(), dictionary(), settings, problem, heldBase, solver, trace, progress::part);
      Weighed best = new Weighed(base, List.of(), heldBase);
      if (!found.model().components().isEmpty()) {
        best = choice.of(found);
      }
      if (Leftover.of(best.model()).isSignificant()) {
        progress.stage("describing what has no name");
        best = described(best, choice, heldBase);
      }
      best = lawful(best, choice);
      if (!(best.held().rmsMm() <= heldBase.rmsMm())) {
        best = new Weighed(base, List.of(), heldBase);
      }
      FittedModel extended = best.model();
      List<Cause> kickers =
          extended.solution().reducedChiSquare() < EXPLAINED
              ? new KickerBias(extended, problem.commands(), seed).causes(catalogue, arena)
              : List.of();
      return new Answer(extended, best.judged(), kickers, best.held(), heldBase);
    }

    /** With laws for what kickers do: values that have a mean of their own and follow the kick are no chance, and a law predicts where values do not. */
    private Weighed lawful(Weighed found, ModelChoice choice) {
      Weighed best = found;
      for (Judgement j : found.judged()) {
        // A law that was taken changes all judgements; values that it left are judged there.
        int component = best.judged().indexOf(j);
        if (component < 0 || !j.effect().hasOwnMean()) {
          continue;
        }
        Weighed before = best;
        best =
            j.follows()
                .flatMap(d -> laws().insteadOf(before.model(), component, d))
                .map(m -> choice.withLaw(m, before, j))
                .filter(with -> with.isAsGoodAs(before, settings.formGain()))
                .filter(with -> with.predictsBetterThan(before, problem.seed()))
                .orElse(before);
      }
      return best;
    }

    /** With laws, chance and learned terms for what has no name. */
    private Weighed described(Weighed found, ModelChoice choice, HoldOut heldBase) {
      LawForValues laws = laws();
      // Beside none first: causes may have imitated a law.
      List<FittedModel> starts = new ArrayList<>(List.of(base));
      if (found.model() != base) {
        starts.add(laws.withoutValues(found.model()));
      }
      Weighed lawful = withLaws(found, starts, laws, choice);
      if (lawful != found) {
        return besideLaws(lawful, laws, choice, heldBase);
      }
      Weighed best = withoutLaws(found, choice, heldBase);
      if (best.judged().stream().noneMatch(j -> isChance(j) && j.follows().isPresent())) {
        return best;
      }
      FittedModel start = laws.withoutValues(best.model());
      HoldOut held = HoldOut.of(start, true, problem.seed());
      Weighed plain = new Weighed(start, List.of(), held);
      lawful = withLaws(plain, List.of(start), laws, choice);
      return lawful != plain && !lawful.held().predictsWorseThan(best.held(), problem.seed())
          ? besideLaws(lawful, laws, choice, heldBase)
          : best;
    }

    /** With the laws that values of the kicks follow, one after another, as long as each takes most of what is left; as found where there is none. */
    private Weighed withLaws(
        Weighed found, List<FittedModel> starts, LawForValues laws, ModelChoice choice) {
      Weighed best = found;
      List<FittedModel> from = starts;
      for (int i = 0; i < MOST_LEARNED; i++) {
        Weighed before = best;
        for (FittedModel start : from) {
          for (FittedModel law : laws.beside(start)) {
            Weighed with = lean(found.model(), choice.of(law), choice);
            boolean sound = !with.held().predictsWorseThan(before.held(), problem.seed());
            best = sound && excess(with) < IMITATED * excess(best) ? with : best;
          }
        }
        if (best == before || !Leftover.of(best.model()).isSignificant()) {
          break;
        }
        from = List.of(best.model());
      }
      return best;
    }

    /** Without causes whose place a law took, unless they take most of what it leaves: beside it a cause may get its true size, or describe what the law's form misses. */
    private Weighed lean(FittedModel before, Weighed after, ModelChoice choice) {
      FittedModel fewer = withoutSupplanted(before, after.model());
      if (fewer == after.model()) {
        return after;
      }
      Weighed lean = choice.of(fewer);
      return excess(after) < IMITATED * excess(lean) ? after : lean;
    }

    private LawForValues laws() {
      return new LawForValues(fitter, decision(), arena, catalogue, solver, problem.seed());
    }

    /** With curves for what laws leave, unless that differs from kick to kick by chance. */
    private Weighed besideLaws(
        Weighed lawful, LawForValues laws, ModelChoice choice, HoldOut heldBase) {
      boolean done =
          !Leftover.of(lawful.model()).isSignificant() || laws.leavesChance(lawful.model());
      return done ? lawful : curved(lawful, choice, heldBase, false);
    }

    /** With chance and learned terms. Several effects may have imitated one that has no name: then curves alone leave much less, and nothing is named. */
    private Weighed withoutLaws(Weighed found, ModelChoice choice, HoldOut heldBase) {
      Weighed best = curved(found, choice, heldBase);
      if (best.model().model().components().isEmpty()
          || !Leftover.of(best.model()).isSignificant()) {
        return best;
      }
      Weighed alone = choice.of(withCurves(base, List.of(), true));
      boolean named = best.judged().stream().anyMatch(Run::isName);
      double most = named ? IMITATED : 1;
      boolean imitated =
          Math.pow(alone.held().rmsMm(), 2) < most * Math.pow(best.held().rmsMm(), 2);
      return imitated && !alone.held().predictsWorseThan(best.held(), problem.seed())
          ? alone
          : best;
    }

    /** Variance on held-out kicks beyond the noise, mm². */
    private double excess(Weighed weighed) {
      double noise = quality(weighed.model(), weighed.held()).noiseMm();
      return Math.pow(weighed.held().rmsMm(), 2) - noise * noise;
    }

    private static boolean isName(Judgement j) {
      return j.outcome() == Outcome.NAMED && !LearnedFindings.isLearned(j.effect());
    }

    /** With curves and chance beside the causes, if that predicts better. A value for each kick can be any cause that differs between kicks: it takes the place of one that was named only where it explains much more. */
    private Weighed curved(Weighed named, ModelChoice choice, HoldOut heldBase) {
      Weighed best = curved(named, choice, heldBase, true);
      boolean much =
          Math.pow(best.held().rmsMm(), 2) < IMITATED * Math.pow(named.held().rmsMm(), 2);
      return !much && best.judged().stream().anyMatch(Run::isChance) && losesName(named, best)
          ? curved(named, choice, heldBase, false)
          : best;
    }

    private static boolean isChance(Judgement j) {
      return !j.effect().hasOwnMean();
    }

    private static boolean losesName(Weighed before, Weighed after) {
      return before.judged().stream()
          .filter(Run::isName)
          .anyMatch(
              j ->
                  after.judged().stream()
                      .noneMatch(k -> isName(k) && k.component().isSameCause(j.component())));
    }

    /** With curves beside the causes, if that predicts better. Causes whose place a curve took stay where they are needed all the same: beside a curve a cause may get its true size. */
    private Weighed curved(Weighed named, ModelChoice choice, HoldOut heldBase, boolean chance) {
      FittedModel curved = withCurves(named.model(), named.judged(), chance);
      if (curved == named.model()) {
        return named;
      }
      Weighed best = choice.of(curved);
      FittedModel fewer = withoutSupplanted(named.model(), curved);
      if (fewer != curved) {
        Weighed lean = choice.of(fewer);
        best = lean.isAsGoodAs(best, CLEARLY_BETTER) ? lean : best;
      }
      boolean better =
          best.held().rmsMm() < (1 - CLEARLY_BETTER) * named.held().rmsMm()
              && !best.held().predictsWorseThan(heldBase, problem.seed());
      return better ? best : named;
    }

    private FittedModel withCurves(FittedModel start, List<Judgement> judged, boolean chance) {
      int most = start.model().components().size() + MOST_LEARNED;
      return guarded(
          "the search for learned terms",
          start,
          () -> {
            FittedModel curved = search(start, learnedAndLaws(judged, chance), most, false);
            return Leftover.of(curved).isSignificant()
                ? search(curved, LearnedLibrary.maps(arena), most + 1, false)
                : curved;
          });
    }

    /** Without causes that a curve took the place of: what is another number beside the curve was the curve's shadow. */
    private FittedModel withoutSupplanted(FittedModel before, FittedModel after) {
      double[] then = before.solution().values();
      double[] now = after.solution().values();
      List<Component> kept = new ArrayList<>();
      List<Component> had = before.model().components();
      List<Component> have = after.model().components();
      List<Effect> effects = after.effects();
      for (int i = 0; i < have.size(); i++) {
        Component c = have.get(i);
        boolean stays = c.isPerKick() || c.isLaw();
        boolean known = false;
        for (int j = 0; j < had.size(); j++) {
          if (had.get(j).isSameCause(c) && had.get(j).size() == c.size()) {
            known = true;
            double change = 0;
            double size = 0;
            for (int k = 0; k < c.magnitudeCount(); k++) {
              double was = then[before.model().offset(j) + k];
              double is = now[after.model().offset(i) + k];
              change += (is - was) * (is - was);
              size += was * was;
            }
            stays |= change < SUPPLANTED * SUPPLANTED * size;
          }
        }
        if (stays || !known) {
          kept.add(c.startingAt(effects.get(i)));
        }
      }
      if (kept.size() == have.size()) {
        return after;
      }
      EffectModel model = after.model().startingAt(now, after.solution().scatters()).with(kept);
      return fitter.fit(model, after, Weighing.ALIKE, solver);
    }

    /**
     * The library of smooth terms, chance if wanted, and the laws: with what was hidden before in the model, one may be right after all. Beside a cause that was named and changes the ground with time no curve over time is offered: it can be that cause, and
     * takes its place for the little that it does not explain.
     */
    private List<Effect> learnedAndLaws(List<Judgement> judged, boolean chance) {
      boolean timed = judged.stream().anyMatch(Run::isTimed);
      List<Effect> all = new ArrayList<>(LearnedLibrary.of(arena));
      all.removeIf(e -> timed && LawForValues.changesGroundWithTime(e));
      if (chance) {
        all.addAll(EffectCatalogue.unnamed());
      }
      catalogue.stream().filter(e -> !e.starts().isEmpty()).forEach(all::add);
      return all;
    }

    private static boolean isTimed(Judgement j) {
      return isName(j) && LawForValues.changesGroundWithTime(j.effect());
    }

    private Diagnosis result(Answer a) {
      Leftover after = Leftover.of(a.extended);
      List<Cause> causes = new ArrayList<>();
      List<LearnedFinding> learned = new ArrayList<>();
      for (int i = 0; i < a.judged.size(); i++) {
        Judgement j = a.judged.get(i);
        if (isName(j)) {
          causes.add(cause(j, decision().ties(a.extended, i, j)));
        } else {
          learned.add(LearnedFindings.of(a.extended, i, j, arena));
        }
      }
      causes.addAll(a.kickers);
      causes.sort((x, y) -> Double.compare(y.evidence(), x.evidence()));
      while (causes.size() > problem.maxCauses()) {
        causes.remove(causes.size() - 1);
      }
      List<StructureProfile> before = Profiles.of(base, problem.sessionStart());
      List<StructureProfile> left = Profiles.of(a.extended, problem.sessionStart());
      Quality quality = quality(base, a.heldBase);
      Unexplained unexplained =
          new Unexplained(
              after.isSignificant(),
              quality.noiseMm() * Math.sqrt(Math.max(0, after.systematic())),
              after.deviation(),
              after.isSignificant() ? Profiles.named(left) : List.of());
      return new Diagnosis(
          verdict(causes, learned, unexplained.significant()),
          quality,
          quality(a.extended, a.held),
          causes,
          learned,
          candidates(causes),
          unexplained,
          before,
          left,
          residuals(a),
          model(base, List.of()),
          model(a.extended, a.kickers),
          trace,
          problems,
          ballErrors(a.extended),
          problem.seed());
    }

    private static Map<String, Double> ballErrors(FittedModel f) {
      Map<String, Double> errors = new HashMap<>();
      List<Parameter> ball = f.model().globals().subList(0, EffectModel.BALL);
      f.solution()
          .covariance()
          .ifPresent(
              v -> {
                for (int i = 0; i < ball.size(); i++) {
                  if (ball.get(i).estimated()) {
                    errors.put(ball.get(i).name(), Math.sqrt(v[i][i]));
                  }
                }
              });
      return errors;
    }

    private static Verdict verdict(List<Cause> causes, List<LearnedFinding> learned, boolean left) {
      if (causes.isEmpty() && learned.isEmpty()) {
        return left ? Verdict.UNEXPLAINED_STRUCTURE : Verdict.MODEL_ADEQUATE;
      }
      boolean unnamed = learned.stream().anyMatch(l -> l.kind() != LearnedFinding.Kind.LAW);
      return left || unnamed || causes.isEmpty() ? Verdict.PARTLY_EXPLAINED : Verdict.EXPLAINED;
    }

    private static Cause cause(Judgement j, List<String> ties) {
      return new Cause(j.effect(), j.errors(), j.scatter(), 0.5 * j.evidence(), gain(j), ties);
    }

    static Gain gain(Judgement j) {
      return new Gain(j.gain()[0], j.gain()[1], j.gain()[2], j.gain()[3]);
    }

    private List<Candidate> candidates(List<Cause> causes) {
      List<Candidate> all = new ArrayList<>();
      for (Alternatives.Scored s : alternatives().scores(base)) {
        boolean named =
            causes.stream()
                .anyMatch(
                    c ->
                        c.effect().id().equals(s.effect().id())
                            && c.effect().subject().equals(s.effect().subject()));
        all.add(new Candidate(s.effect(), s.gain(), Double.NaN, Double.NaN, named));
      }
      return all;
    }

    private Quality quality(FittedModel f, HoldOut held) {
      ModelState state = f.solution().state();
      double squares = 0;
      double variance = 0;
      int n = 0;
      for (int k = 0; k < f.kickCount(); k++) {
        EffectKick term = f.kick(k);
        KickRecord d = term.record();
        double[] rx = new double[d.size()];
        double[] ry = new double[d.size()];
        term.plainResiduals(f.solution().own(k), state, rx, ry);
        boolean[] used = d.used();
        for (int i = 0; i < rx.length; i++) {
          if (used[i]) {
            squares += rx[i] * rx[i] + ry[i] * ry[i];
            variance += 2 * d.variance(i);
            n += 2;
          }
        }
      }
      return new Quality(
          1000 * Math.sqrt(squares / n),
          1000 * Math.sqrt(variance / n),
          held.rmsMm(),
          held.predictionMm(),
          held.typicalMm());
    }

    private List<KickResiduals> residuals(Answer a) {
      ModelState before = base.solution().state();
      ModelState after = a.extended.solution().state();
      List<KickResiduals> all = new ArrayList<>();
      for (int k = 0; k < a.extended.kickCount(); k++) {
        EffectKick simple = base.kick(k);
        EffectKick extended = a.extended.kick(k);
        KickRecord d = extended.record();
        double[][] r = new double[4][d.size()];
        double[] own = base.solution().own(k);
        double[] ownAfter = a.extended.solution().own(k);
        simple.plainResiduals(own, before, r[0], r[1]);
        extended.plainResiduals(ownAfter, after, r[2], r[3]);
        BallTrajectory pathBefore = simple.path(own, before);
        BallTrajectory pathAfter = extended.path(ownAfter, after);
        all.add(
            new KickResiduals(
                d.kick(),
                d.kind(),
                pathBefore,
                pathAfter,
                r[0],
                r[1],
                r[2],
                r[3],
                d.used(),
                a.heldBase.rmsMm(k),
                a.held.rmsMm(k)));
      }
      return all;
    }

    private ExtendedModel model(FittedModel f, List<Cause> kickers) {
      ModelState state = f.solution().state();
      List<Effect> effects = new ArrayList<>(f.effects());
      effects.removeIf(e -> !e.hasOwnMean());
      kickers.forEach(c -> effects.add(c.effect()));
      return new ExtendedModel(
          arena.flats() ? Optional.of(state.flat()) : Optional.empty(),
          arena.chips() ? Optional.of(state.chip()) : Optional.empty(),
          effects,
          problem.sessionStart());
    }
  }

  /** Part of a run that may fail. */
  @FunctionalInterface
  private interface Stage {
    FittedModel run();
  }
}
