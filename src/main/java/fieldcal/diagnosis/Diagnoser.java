package fieldcal.diagnosis;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.FitSettings;
import fieldcal.fit.FitStatistics;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Says what the simple model gets wrong, why, and what a better one gains.
 *
 * <p>All kicks are fitted together with the simple model under the published geometry. Score tests of every known effect on its residuals choose what is worth a refit; the best explanations are
 * refitted, extended while that pays, and compared by their evidence. What survives must be worth its evidence against what remains unexplained, pay on kicks that were held out, and, where something
 * remains, be equally strong in all kicks. Otherwise nothing is named: a wrong name is worse than none. Immutable and thread-safe; the same input gives the same answer.
 */
public final class Diagnoser {
  /** Rounds of leaving out what is no free ball. */
  private static final int CLEANINGS = 4;

  /** Steps in which the ends of kicks are cut before the causes are looked for anew. */
  private static final int CUTS = 4;

  /** Where that share of what the simple model gets wrong remains, nothing may be named. */
  private static final double TOO_MUCH = 0.1;

  /** Evidence that a cause needs where something remains: what remains might be its doing. */
  private static final double BEYOND_DOUBT = 100;

  /** What varies from kick to kick by itself, or has a shape that was chosen to fit, must leave less than that share. */
  private static final double ALMOST_NOTHING = 0.03;

  /** Largest scatter of a cause's strength from kick to kick, as a share of it, where something remains. */
  private static final double STEADY = 0.15;

  /** A kick that no choice of the model's parameters fits better than that had another ball in it, or one that hit something, mm. */
  private static final double WRONG_BALL_MM = 40;

  private static final double HALF = 0.5;

  /** A kick that its own parameters fit that many times worse than the median kick is a stray. */
  private static final double STRAY = 3;

  /** Share of the kicks that may be strays. */
  private static final double FEW = 0.08;

  /** A diagnoser. */
  public Diagnoser() {}

  /**
   * Diagnoses.
   *
   * @param problem kicks and cameras
   * @param progress told in words what is being done, from the calling thread
   * @return the diagnosis
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public Diagnosis diagnose(DiagnosisProblem problem, Consumer<String> progress) {
    if (problem.fits().isEmpty()) {
      throw new IllegalArgumentException("a diagnosis needs at least one fitted kick");
    }
    return new Run(problem, progress).diagnose();
  }

  /** One diagnosis; used once. */
  private static final class Run {
    private final DiagnosisProblem problem;
    private final Consumer<String> progress;
    private final List<KickFit> fits;
    private final NoiseCalibration noise;
    private final OtherKind otherKind;
    private HypothesisFitter fitter;
    private FittedHypothesis simple;
    private CauseSearch search;
    private Decision decision;

    Run(DiagnosisProblem problem, Consumer<String> progress) {
      this.problem = problem;
      this.progress = progress;
      progress.accept("comparing kicks with each other");
      fits =
          Kinds.beside(
              problem.fits(), problem.cameras(), FitSettings.defaults().withSeed(problem.seed()));
      noise = NoiseCalibration.of(fits, problem.cameras());
      otherKind = new OtherKind(problem.cameras(), noise, flatStart(), chipStart());
    }

    Diagnosis diagnose() {
      List<KickData> kicks = new ArrayList<>();
      for (KickFit fit : withoutStrays(fits)) {
        KickData data = new KickData(fit, noise.cameras(), noise.stampNoise());
        if (data.usedCount > 2 * data.start.length && isOneBall(fit)) {
          kicks.add(data);
        }
      }
      if (kicks.isEmpty()) {
        throw new IllegalArgumentException("no kick has enough detections for a diagnosis");
      }
      look(kicks);
      Map<Chart, Gain> gains = decision.gains(progress);
      List<KickData> cut = cutEnds(decision.best());
      if (cut != fitter.kicks) {
        // A cause that was dropped had explained what a touched ball did.
        weighAnew(cut);
        gains = decision.gains(progress);
      }
      blameOnlyTheGuilty();
      gains.keySet().retainAll(decision.best().hypothesis().charts());
      return result(gains);
    }

    /** Whatever a model lacks, its own fit of one kick lacks less than that. */
    private static boolean isOneBall(KickFit fit) {
      FitStatistics s = fit.statistics();
      return s.rmsMm() < WRONG_BALL_MM && s.used() > HALF * s.observations();
    }

    /** Without the one kick or two that not even parameters of their own explain, while they do the others; if they are more, that is what is to be explained. */
    private static List<KickFit> withoutStrays(List<KickFit> fits) {
      double[] sorted = fits.stream().mapToDouble(KickFit::rmsMm).sorted().toArray();
      double limit = STRAY * sorted[sorted.length / 2];
      List<KickFit> good = fits.stream().filter(f -> f.rmsMm() < limit).toList();
      return fits.size() - good.size() <= Math.max(1, FEW * fits.size()) ? good : fits;
    }

    private void look(List<KickData> kicks) {
      List<KickData> clean = kicks;
      FittedHypothesis best = null;
      for (int round = 0; round < CLEANINGS; round++) {
        List<KickData> before = clean;
        fitter =
            new HypothesisFitter(
                before, problem.observers(), problem.sessionStart(), flatStart(), chipStart());
        progress.accept("fitting all kicks together");
        simple = fitter.fitSimple();
        boolean first = round == 0;
        boolean last = round == CLEANINGS - 1;
        // Later a better explanation has said of what kind a kick is.
        List<KickData> settled = first ? otherKind.settle(fitter, simple) : fitter.kicks;
        if (settled != fitter.kicks) {
          fitter = fitter.of(settled);
          simple = fitter.fitSimple();
        }
        progress.accept("testing every known effect");
        CauseSearch earlier = search;
        search = new CauseSearch(fitter, progress);
        Predicate<FittedHypothesis> dirty = f -> first && settledOrCut(f) != fitter.kicks;
        best =
            first
                ? search.search(simple, problem.maxCauses(), dirty)
                : search.searchAgain(simple, earlier, problem.maxCauses(), dirty);
        clean = last ? fitter.kicks : cleaned(best, first);
        if (clean == fitter.kicks) {
          break;
        }
        progress.accept("looking again at kicks that stand out");
      }
      best = search.polishRegion(best);
      progress.accept("weighing the explanations");
      decision = new Decision(search, best, problem.seed());
      decision.settle();
      simple = search.simple();
    }

    /** Weighs what was decided on kicks whose ends were cut, without another search. */
    private void weighAnew(List<KickData> cut) {
      FittedHypothesis decided = decision.best();
      fitter = fitter.of(cut);
      search = new CauseSearch(fitter, progress);
      search.know(fitter.fitSimple());
      FittedHypothesis best = fitter.fit(decided.hypothesis(), decided.shared(), decided, true);
      search.know(best);
      decision = new Decision(search, best, problem.seed());
      decision.settle();
      simple = search.simple();
    }

    /**
     * The kicks as they look in the light of an explanation; the same list when nothing is to be changed.
     *
     * @param first whether this is the first look: then the ends of a kick are suspected before the kick is, later the other way round
     */
    private List<KickData> cleaned(FittedHypothesis best, boolean first) {
      List<KickData> ends = first ? settledOrCut(best) : otherKind.settle(fitter, best);
      if (ends != fitter.kicks) {
        return ends;
      }
      List<KickData> good = Cleaning.kicks(fitter, best);
      return good == fitter.kicks ? cutEnds(best) : good;
    }

    /** The kicks as the kinds that an explanation makes of them, or else with their ends cut; the same list when nothing is to be changed. Of the simple model the kinds were asked before. */
    private List<KickData> settledOrCut(FittedHypothesis best) {
      List<KickData> settled =
          best.hypothesis().isSimple() ? fitter.kicks : otherKind.settle(fitter, best);
      return settled == fitter.kicks ? cutEnds(best) : settled;
    }

    /** Cuts the ends until nothing changes: a touch that lasts is seen through step by step. */
    private List<KickData> cutEnds(FittedHypothesis best) {
      HypothesisFitter at = fitter;
      FittedHypothesis f = best;
      for (int i = 0; i < CUTS; i++) {
        List<KickData> ends = Cleaning.ends(at, f);
        if (ends == at.kicks) {
          break;
        }
        at = at.of(ends);
        f = at.fit(f.hypothesis(), f.shared(), f, false);
      }
      return Cleaning.sameDetections(at.kicks, fitter.kicks) ? fitter.kicks : at.kicks;
    }

    /** Where structure remains, a cause stays only if it is the same in all kicks. */
    private void blameOnlyTheGuilty() {
      List<Chart> laws =
          decision.best().hypothesis().random().stream()
              .filter(c -> Independence.isLaw(fitter, decision.best(), c))
              .toList();
      laws.forEach(
          c ->
              progress.accept(
                  "not named: " + c + " follows from the kick's speed, direction or time"));
      decision.acquit(laws);
      Structure after = decision.structure();
      if (!after.isSignificant() || decision.best().hypothesis().isSimple()) {
        return;
      }
      double share = after.systematic() / Structure.of(fitter, simple).systematic();
      ScoreFrame frame = new ScoreFrame(fitter, decision.best());
      List<Chart> unsteady = new ArrayList<>();
      for (Chart chart : decision.best().hypothesis().charts()) {
        if (share > TOO_MUCH
            || decision.evidence(chart) < BEYOND_DOUBT
            || !isSteady(frame, chart, share)) {
          unsteady.add(chart);
        }
      }
      unsteady.forEach(
          c ->
              progress.accept(
                  String.format(
                      Locale.ROOT,
                      "not named: %s leaves %.0f %% unexplained, or is not as strong in all kicks",
                      c,
                      100 * share)));
      decision.acquit(unsteady);
    }

    private boolean isSteady(ScoreFrame frame, Chart chart, double share) {
      boolean varies = decision.best().hypothesis().isRandom(chart);
      boolean region = chart.id().equals("worn_region");
      return varies || region
          ? share < ALMOST_NOTHING
          : Consistency.scatter(frame, decision.best(), chart) < STEADY;
    }

    private FlatModel flatStart() {
      return Kinds.flat(fits);
    }

    private ChipModel chipStart() {
      return Kinds.chip(fits, flatStart());
    }

    private Diagnosis result(Map<Chart, Gain> gains) {
      FittedHypothesis best = decision.best();
      Structure after = decision.structure();
      HoldOut heldBefore = HoldOut.of(fitter, simple, problem.seed());
      HoldOut heldAfter =
          best.hypothesis().isSimple() ? heldBefore : HoldOut.of(fitter, best, problem.seed());
      List<Cause> kickers =
          new KickerBias(fitter, best, problem.commands(), problem.seed()).causes();
      List<Cause> causes = causes(best, gains, kickers);
      List<StructureProfile> before = Profiles.of(fitter, simple);
      List<StructureProfile> left = Profiles.of(fitter, best);
      Quality base = quality(simple, heldBefore);
      Quality extended = quality(best, heldAfter);
      Unexplained unexplained =
          new Unexplained(
              after.isSignificant(),
              base.noiseMm() * Math.sqrt(Math.max(0, after.systematic())),
              after.deviation(),
              after.isSignificant() ? Profiles.named(left) : List.of());
      Verdict verdict =
          causes.isEmpty()
              ? after.isSignificant() ? Verdict.UNEXPLAINED_STRUCTURE : Verdict.MODEL_ADEQUATE
              : Verdict.EXPLAINED;
      return new Diagnosis(
          verdict,
          base,
          extended,
          causes,
          tried(best),
          unexplained,
          before,
          left,
          residuals(best, heldBefore, heldAfter),
          model(simple, List.of()),
          model(best, kickers),
          problem.seed());
    }

    private List<Cause> causes(FittedHypothesis best, Map<Chart, Gain> gains, List<Cause> kickers) {
      List<Cause> causes = new ArrayList<>();
      for (Chart chart : best.hypothesis().charts()) {
        Map<String, Double> errors =
            chart.errors(best.shared(), best.covariance(), best.offset(chart));
        if (chart.id().equals("worn_region")) {
          double ofEdges = search.edgeError(best);
          errors.replaceAll((name, error) -> Math.hypot(error, ofEdges));
        }
        causes.add(
            new Cause(
                best.effect(chart),
                errors,
                best.scatter(chart),
                decision.evidence(chart),
                gains.get(chart),
                decision.ties(chart),
                NextKicks.toTellApart(chart.id(), decision.ties(chart))));
      }
      causes.addAll(kickers);
      causes.sort((a, b) -> Double.compare(b.evidence(), a.evidence()));
      return causes;
    }

    private List<Candidate> tried(FittedHypothesis best) {
      Map<String, Candidate> all = new java.util.LinkedHashMap<>();
      List<Score> added = search.scores(best);
      double temper = Decision.temper(fitter, best);
      for (Score score : search.scores(simple)) {
        Hypothesis alone = Hypothesis.SIMPLE.with(score.chart(), score.perKick());
        double evidence = Double.NaN;
        Effect effect = score.chart().effect(score.coordinates(), 0);
        for (FittedHypothesis f : search.fitted()) {
          if (f.hypothesis().sameCauses(alone)) {
            evidence = Decision.evidence(f, simple, temper);
            effect = f.effect(f.hypothesis().charts().get(0));
          }
        }
        double more = Double.NaN;
        for (Score s : added) {
          if (s.chart().sameCause(score.chart()) && s.chart().size() == score.chart().size()) {
            more = s.evidence() - 0.5 * s.gain() * (1 - 1 / temper);
          }
        }
        all.putIfAbsent(
            score.chart().toString(),
            new Candidate(
                effect, score.gain(), evidence, more, best.hypothesis().hasCause(score.chart())));
      }
      return List.copyOf(all.values());
    }

    private Quality quality(FittedHypothesis f, HoldOut held) {
      SharedState state = SharedState.of(f.hypothesis(), f.shared(), fitter.observers);
      double squares = 0;
      double variance = 0;
      int n = 0;
      for (int k = 0; k < fitter.kicks.size(); k++) {
        KickModel model = model(f, k);
        KickData d = model.data;
        double[] rx = new double[d.size];
        double[] ry = new double[d.size];
        model.plainResiduals(state, rx, ry);
        for (int i = 0; i < d.size; i++) {
          if (d.used[i]) {
            squares += rx[i] * rx[i] + ry[i] * ry[i];
            // Half the trace of the covariance, whose Cholesky factor's inverse is w.
            double l11 = 1 / d.w11[i];
            double l22 = 1 / d.w22[i];
            double l21 = -d.w21[i] * l11 * l22;
            variance += l11 * l11 + l21 * l21 + l22 * l22;
            n += 2;
          }
        }
      }
      return new Quality(
          1000 * Math.sqrt(squares / n),
          1000 * Math.sqrt(variance / n),
          held.rmsMm(),
          held.predictionMm());
    }

    private KickModel model(FittedHypothesis f, int k) {
      KickModel model =
          new KickModel(
              fitter.kicks.get(k), f.hypothesis().random().size(), problem.sessionStart());
      model.startFrom(f.own().get(k), f.flights()[k], new double[0]);
      return model;
    }

    private List<KickResiduals> residuals(
        FittedHypothesis best, HoldOut heldBefore, HoldOut heldAfter) {
      SharedState simpleState =
          SharedState.of(simple.hypothesis(), simple.shared(), fitter.observers);
      SharedState bestState = SharedState.of(best.hypothesis(), best.shared(), fitter.observers);
      List<KickResiduals> all = new ArrayList<>();
      for (int k = 0; k < fitter.kicks.size(); k++) {
        KickModel before = model(simple, k);
        KickModel after = model(best, k);
        KickData d = before.data;
        double[][] r = new double[4][d.size];
        before.plainResiduals(simpleState, r[0], r[1]);
        after.plainResiduals(bestState, r[2], r[3]);
        BallTrajectory pathBefore = before.path(simpleState, before.own);
        BallTrajectory pathAfter = after.path(bestState, after.own);
        all.add(
            new KickResiduals(
                d.kick,
                d.kind,
                pathBefore,
                pathAfter,
                r[0],
                r[1],
                r[2],
                r[3],
                d.used,
                heldBefore.rmsMm(k),
                heldAfter.rmsMm(k)));
      }
      return all;
    }

    private ExtendedModel model(FittedHypothesis f, List<Cause> kickers) {
      boolean flats = fitter.kicks.stream().anyMatch(k -> k.kind == KickKind.FLAT);
      boolean chips = fitter.kicks.stream().anyMatch(k -> k.kind == KickKind.CHIP);
      List<Effect> effects = new ArrayList<>();
      f.hypothesis().charts().forEach(c -> effects.add(f.effect(c)));
      kickers.forEach(c -> effects.add(c.effect()));
      return new ExtendedModel(
          flats ? Optional.of(SharedUnknowns.flat(f.shared())) : Optional.empty(),
          chips ? Optional.of(SharedUnknowns.chip(f.shared())) : Optional.empty(),
          effects,
          problem.sessionStart());
    }
  }
}
