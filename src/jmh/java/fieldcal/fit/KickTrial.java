package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * One simulated kick, fitted from a published model that is 15 % off, and judged by its truth.
 *
 * <p>The bound is the inverse of the Fisher information of the observations that are no outliers, at the truth, with the true
 * noise (Cramér and Rao); no unbiased estimator can be better.
 *
 * @param fit the fit
 * @param errors estimate minus truth, in units of the bound; NaN for what is fixed or has no information
 * @param pulls the same in units of the reported standard error; NaN also where the fit reports none
 */
record KickTrial(KickFit fit, double[] errors, double[] pulls) {
  /** A fit whose residuals are so much above the noise explains something else. */
  private static final double WORST_RESIDUAL = 1.2;

  /** A parameter that many bounds off has been found in another local minimum. */
  private static final double MOST_BOUNDS = 6;

  /** Draws, fits and judges; the same kicks for the same seed, however many threads there are. */
  static List<KickTrial> run(
      KickKind kind, IdealKicks.Conditions conditions, int kicks, SplittableRandom random) {
    IdealKicks source = new IdealKicks(conditions.noise());
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    List<SplittableRandom> each = IntStream.range(0, kicks).mapToObj(k -> random.split()).toList();
    return IntStream.range(0, kicks)
        .parallel()
        .mapToObj(k -> one(source, fitter, kind, k + 1, conditions, each.get(k)))
        .toList();
  }

  private static KickTrial one(
      IdealKicks source,
      KickFitter fitter,
      KickKind kind,
      int id,
      IdealKicks.Conditions conditions,
      SplittableRandom random) {
    IdealKicks.Sample sample = source.draw(kind, id, conditions, random);
    FitProblem problem = problem(sample, source.views(), random);
    KickFit fit = fitter.fit(problem, kind);
    double[] truth = sample.truth();
    double[] errors = new double[truth.length];
    double[] pulls = new double[truth.length];
    if (fit.failure().isEmpty()) {
      double[] bound = bound(sample, source.views(), problem);
      for (int k = 0; k < truth.length; k++) {
        Estimate e = fit.estimates().get(k);
        double error = e.value() - truth[k];
        errors[k] = error / bound[k];
        pulls[k] =
            e.undetermined().isPresent() || e.atBound() ? Double.NaN : error / e.standardError();
      }
    }
    return new KickTrial(fit, errors, pulls);
  }

  static FitProblem problem(IdealKicks.Sample s, CameraViews views, SplittableRandom random) {
    if (s.kind() == KickKind.FLAT) {
      return FitProblem.of(
          s.kick(), views, IdealKicks.publishedFlat(s.truth(), random), ChipModel.typical());
    }
    return FitProblem.of(
            s.kick(), views, FlatModel.typical(), IdealKicks.publishedChip(s.truth(), random))
        .withChipRollFixed(s.truth()[9]);
  }

  private static double[] bound(IdealKicks.Sample s, CameraViews views, FitProblem problem) {
    FlightData data = FlightData.of(s.kick().observations(), views);
    FlightCurve curve =
        s.kind() == KickKind.FLAT ? new FlightCurve.Flat() : new FlightCurve.Chip(s.flights());
    int size = s.truth().length;
    FlightProblem flight = new FlightProblem(data, curve, size);
    for (int i = 0; i < data.size; i++) {
      flight.used()[i] = !s.outlier()[i];
    }
    NormalEquations equations = new NormalEquations(size);
    flight.linearize(s.truth(), equations);
    List<Parameter> model = s.kind() == KickKind.FLAT ? problem.flat() : problem.chip();
    List<Parameter> all = FlightLayout.parameters(s.kind(), s.truth(), model);
    boolean[] free = new boolean[size];
    for (int k = 0; k < size; k++) {
      free[k] = all.get(k).estimated() && equations.a[k][k] > 0;
    }
    double[][] inverse =
        equations.inverse(all.stream().mapToDouble(Parameter::scale).toArray(), free);
    double[] bound = new double[size];
    for (int k = 0; k < size; k++) {
      bound[k] = free[k] && inverse != null ? Math.sqrt(inverse[k][k]) : Double.NaN;
    }
    return bound;
  }

  boolean failed() {
    return fit.failure().isPresent();
  }

  /** Whether the parameter can be averaged over kicks: it has a bound, and the fit answers for it. */
  boolean counts(int parameter) {
    return !failed() && !Double.isNaN(errors[parameter]) && !Double.isNaN(pulls[parameter]);
  }

  /** Residuals too large for the noise, or a parameter far off. */
  boolean wrong() {
    if (failed()) {
      return true;
    }
    boolean off =
        fit.statistics().robustScale() > WORST_RESIDUAL
            || Math.sqrt(fit.statistics().reducedChiSquare()) > WORST_RESIDUAL;
    for (double error : errors) {
      off |= Math.abs(error) > MOST_BOUNDS;
    }
    return off;
  }
}
