package fieldcal.diagnosis;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.fit.KickFit;
import fieldcal.simulation.ScenarioKind;
import java.util.List;

/** A field with fourteen chips and nothing hidden, fitted once for all tests that look at the parts of a diagnosis. */
final class ChipsField {
  private static final long SEED = 41000019;
  private static final ChipsField ONLY = new ChipsField();

  final HypothesisFitter fitter = anew();
  final FittedHypothesis simple = fitter.fitSimple();

  private ChipsField() {}

  static ChipsField fitted() {
    return ONLY;
  }

  /** The same field once more, for a test that changes what was seen there. */
  static HypothesisFitter anew() {
    return fitter(HiddenRun.problem(HiddenCase.of(SEED, ScenarioKind.CHIP)));
  }

  static List<KickData> kicks(DiagnosisProblem problem) {
    NoiseCalibration noise = NoiseCalibration.of(problem.fits(), problem.cameras());
    return problem.fits().stream()
        .map(fit -> new KickData(fit, noise.cameras(), noise.stampNoise()))
        .toList();
  }

  static HypothesisFitter fitter(DiagnosisProblem problem) {
    List<KickFit> fits = problem.fits();
    return new HypothesisFitter(
        kicks(problem),
        problem.observers(),
        problem.sessionStart(),
        Kinds.flat(fits),
        Kinds.chip(fits, Kinds.flat(fits)));
  }

  /** The fit of the simple model as if its kicks had ended elsewhere. */
  FittedHypothesis spoilt(List<double[]> own, int[] flights) {
    return new FittedHypothesis(
        Hypothesis.SIMPLE,
        simple.shared(),
        own,
        flights,
        new double[0],
        simple.chiSquare(),
        simple.cost(),
        simple.residuals(),
        simple.logEvidence(),
        simple.covariance(),
        false);
  }

  /** One chip taken for a lower one that hops twice more, as a fit of it alone may confuse them. */
  FittedHypothesis withConfused(int kick) {
    List<double[]> own = new java.util.ArrayList<>(simple.own());
    double[] confused = own.get(kick).clone();
    confused[4] *= 0.6;
    own.set(kick, confused);
    int[] flights = simple.flights().clone();
    flights[kick] += 2;
    return spoilt(own, flights);
  }

  KickModel model(FittedHypothesis at, int kick) {
    KickModel model = new KickModel(fitter.kicks.get(kick), 0, fitter.sessionStart);
    model.startFrom(at.own().get(kick), at.flights()[kick], new double[0]);
    return model;
  }

  SharedState state() {
    return SharedState.of(Hypothesis.SIMPLE, simple.shared(), fitter.observers);
  }
}
