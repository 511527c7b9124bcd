package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedSolver;
import java.util.List;

/**
 * What the stages after the search for names work with: the screened kicks and what may explain them.
 *
 * @param problem as it was given
 * @param catalogue effects that may be named
 * @param settings every number that decides
 * @param fitter of the screened kicks
 * @param arena what was recorded
 * @param base the simple model, fitted to all kicks
 * @param solver of the fits
 */
record DiagnosisCase(
    DiagnosisProblem problem,
    List<? extends Effect> catalogue,
    DecisionSettings settings,
    ModelFitter fitter,
    Arena arena,
    FittedModel base,
    SharedSolver solver) {

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
