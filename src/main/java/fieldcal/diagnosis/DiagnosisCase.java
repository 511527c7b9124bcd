package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.TypicalBall;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Kicks that are examined together, and what may explain them. Immutable: a stage that examines other kicks makes another case.
 *
 * @param problem as it was given
 * @param catalogue effects that may be named
 * @param settings every number that decides
 * @param solver of the fits
 * @param screen screens kicks that stand out again
 * @param fitter of the kicks
 * @param arena what was recorded of them
 * @param base the simple model, fitted to them
 */
record DiagnosisCase(
    DiagnosisProblem problem,
    List<? extends Effect> catalogue,
    DecisionSettings settings,
    SharedSolver solver,
    KickScreen screen,
    ModelFitter fitter,
    Arena arena,
    FittedModel base) {

  /** Fewest detections with which a camera is judged. */
  private static final int FEWEST_SEEN = 60;

  /** The simple model for some kicks, before any fit. */
  static EffectModel simple(DiagnosisProblem problem, List<KickRecord> kicks) {
    return EffectModel.simple(
        TypicalBall.flat(problem.fits()),
        TypicalBall.chip(problem.fits()),
        has(kicks, KickKind.FLAT),
        has(kicks, KickKind.CHIP),
        problem.observers());
  }

  /** What was recorded of some kicks. */
  static Arena arena(DiagnosisProblem problem, List<KickRecord> kicks) {
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

  private static boolean has(List<KickRecord> kicks, KickKind kind) {
    return kicks.stream().anyMatch(k -> k.kind() == kind);
  }

  /** The same with other records of the kicks, or fewer of them; the simple model is fitted to these. */
  DiagnosisCase refitted(List<KickRecord> kicks) {
    ModelFitter others = fitter.among(kicks);
    FittedModel simple = others.fit(simple(problem, kicks), solver);
    return new DiagnosisCase(
        problem, catalogue, settings, solver, screen, others, arena(problem, kicks), simple);
  }

  /**
   * A model that was fitted to other records of these kicks, or to more kicks, fitted to these.
   *
   * @param found the model
   * @param weighing how much kicks count that it does not explain
   */
  FittedModel fit(FittedModel found, Weighing weighing) {
    int kicks = fitter.kicks().size();
    FittedModel from = found.kickCount() == kicks ? found : found.restrictedTo(fitter.kicks());
    return fitter.fit(found.resumed().in(arena), from, weighing, solver);
  }

  long seed() {
    return problem.seed();
  }

  FreshFit fresh() {
    return new FreshFit(fitter, base, solver);
  }

  Dictionary dictionary() {
    return new Dictionary(catalogue, arena);
  }

  Alternatives alternatives() {
    return new Alternatives(fitter, dictionary());
  }

  Decision decision() {
    return new Decision(settings, fresh(), alternatives(), seed());
  }

  LawForValues laws() {
    return new LawForValues(fitter, decision(), arena, catalogue, solver, seed());
  }
}
