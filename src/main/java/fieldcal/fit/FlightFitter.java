package fieldcal.fit;

import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One fit of one kick by one model, from the start to the result; used once. */
final class FlightFitter {
  /** A parameter is undetermined when its error exceeds this share of its scale. */
  private static final double DETERMINED = 0.5;

  /** An estimate that is nearer to a bound than this share of its error is at it; chosen far below 1, so that no estimate that merely lies beside a bound is meant. */
  private static final double AT_BOUND = 1e-3;

  /** Initial spread of the search in scales: 0.7 m/s² of accSlide, 70 mm/s …; chosen to cover published models that are 15 % off. */
  private static final double SPREAD = 0.7;

  /**
   * When the errors of all parameters are below this share of their values, the kick shows all that the model describes, and a search finds no other minimum: of 876 drawn flat kicks with errors below 0.2, a search moved none by more than 0.006 standard errors; of 322 others it moved ten. Half of 0.2, to be safe. Of 1800 drawn chips with errors below 0.1 it moved none by more than 0.014.
   */
  private static final double WELL_DETERMINED = 0.1;

  /** Outliers settle within two or three screenings; further ones would only repeat these. */
  private static final int MOST_SCREENINGS = 6;

  private final FitProblem problem;
  private final KickKind kind;
  private final FlightData data;
  private final List<Parameter> parameters;
  private final FitSettings settings;
  private final long seed;
  private final int size;
  private final MinimumFinder finder;
  private int evaluations;

  FlightFitter(
      FitProblem problem,
      KickKind kind,
      FlightData data,
      List<Parameter> parameters,
      FitSettings settings,
      long seed) {
    this.problem = problem;
    this.kind = kind;
    this.data = data;
    this.parameters = parameters;
    this.settings = settings;
    this.seed = seed;
    size = parameters.size();
    finder = new MinimumFinder(problem, kind, data, parameters, settings);
  }

  /** Fits with a search from the best of the starts, each of which is position, velocity and time of the kick. A kick that a descent from there explains, and that determines all parameters, needs no search. */
  KickFit fit(List<double[]> starts) {
    FlightProblem coarse = coarse();
    double[] start = bestStart(coarse, starts);
    MinimumFinder.Descent descent = descent(start);
    if (!explains(descent.minimum()) || !determinesAll(descent.minimum())) {
      double[] found =
          new CmaesSearch(coarse, parameters, start, SPREAD)
              .search(settings.searchEvaluations(), seed);
      descent = finder.further(descent, List.of(found));
    }
    evaluations += coarse.evaluations();
    return finish(descent.minimum());
  }

  /** Fits with no more than a descent from the best of the starts. */
  KickFit descend(List<double[]> starts) {
    FlightProblem coarse = coarse();
    Minimum minimum = descent(bestStart(coarse, starts)).minimum();
    evaluations += coarse.evaluations();
    return finish(minimum);
  }

  /** The objective on the few observations that a search looks at. */
  private FlightProblem coarse() {
    int[] subset = SearchSubset.pick(data, problem.kick().time(), settings.searchObservations());
    return finder.widely(data.pick(subset), 0);
  }

  private MinimumFinder.Descent descent(double[] start) {
    return finder.descend(
        kind == KickKind.FLAT ? List.of(start) : List.of(start, withModelOf(start)));
  }

  /** Whether a minimum explains the kick as {@link FitStatistics#explained} says of a fit. */
  private boolean explains(Minimum minimum) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    minimum.flight().residuals(minimum.theta(), rx, ry);
    Screening screening = Screening.of(data, rx, ry, settings.outlierDistance());
    double sum = 0;
    int used = 0;
    int off = 0;
    for (int i = 0; i < data.size; i++) {
      used += screening.kept(i) ? 1 : 0;
      sum += screening.kept(i) ? data.squared(i, rx[i], ry[i]) : 0;
      off += screening.verdict(i) == Screening.Verdict.FITS ? 0 : 1;
    }
    double reduced = sum / degrees(used);
    return FitStatistics.explained(screening.robustScale(), reduced, off, data.size);
  }

  /** Whether each parameter of the model is known at a minimum so well that no second minimum can be as good. */
  private boolean determinesAll(Minimum minimum) {
    boolean[] free = new boolean[size];
    double[] scales = new double[size];
    for (int k = 0; k < size; k++) {
      free[k] = parameters.get(k).estimated();
      scales[k] = parameters.get(k).scale();
    }
    double[][] inverse = minimum.equations().inverse(scales, free);
    boolean all = inverse != null;
    for (int k = FlightLayout.kickSize(kind); all && k < size; k++) {
      double known = WELL_DETERMINED * minimum.theta()[k];
      all = !free[k] || inverse[k][k] > 0 && inverse[k][k] < known * known;
    }
    return all;
  }

  /** Degrees of freedom that the used observations leave. */
  private int degrees(int used) {
    return Math.max(1, 2 * used - (int) parameters.stream().filter(Parameter::estimated).count());
  }

  /** A start whose dampings are replaced by those of the problem's model: what other kicks showed is right more often than what a part of the observations prefers. */
  private double[] withModelOf(double[] start) {
    double[] theta = start.clone();
    for (int k = FlightLayout.timeIndex(kind) + 1; k < size; k++) {
      theta[k] = parameters.get(k).value();
    }
    return theta;
  }

  private double[] bestStart(FlightProblem coarse, List<double[]> starts) {
    double[] best = null;
    double lowest = Double.POSITIVE_INFINITY;
    for (double[] kick : starts) {
      double[] theta = new double[size];
      for (int k = 0; k < size; k++) {
        Parameter p = parameters.get(k);
        theta[k] = k < kick.length ? p.clamp(kick[k]) : p.value();
      }
      double cost =
          kind == KickKind.CHIP
              ? ChipStart.dampings(coarse, parameters, theta)
              : coarse.cost(theta);
      if (best == null || cost < lowest) {
        lowest = cost;
        best = theta;
      }
    }
    return best;
  }

  /** Fits without a search, from where an earlier fit ended; parameters that are held get the problem's values. */
  KickFit refit(KickFit before) {
    double[] start = before.values();
    for (int k = 0; k < size; k++) {
      Parameter p = parameters.get(k);
      start[k] = p.estimated() ? p.clamp(start[k]) : p.value();
    }
    return finish(finder.follow(start, before.statistics().flights()));
  }

  private KickFit finish(Minimum best) {
    FlightProblem flight = best.flight();
    double[] theta = best.theta();
    LevenbergMarquardt solver = new LevenbergMarquardt(parameters);
    leaveOutliersOut(flight, theta, solver);
    String[] reasons = tieUndetermined(flight, theta, solver);
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    flight.residuals(theta, rx, ry);
    evaluations += finder.evaluations();
    return result(best, solver, reasons, rx, ry);
  }

  /** Plain least squares on what is not an outlier, repeated until the outliers are the same. */
  private void leaveOutliersOut(FlightProblem flight, double[] theta, LevenbergMarquardt solver) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    boolean[] used = flight.used();
    for (int round = 0; round < MOST_SCREENINGS; round++) {
      flight.residuals(theta, rx, ry);
      Screening screening = Screening.of(data, rx, ry, settings.outlierDistance());
      boolean changed = round == 0;
      for (int i = 0; i < used.length; i++) {
        changed |= screening.kept(i) != used[i];
        used[i] = screening.kept(i);
      }
      if (!changed) {
        break;
      }
      flight.lossScale(Double.POSITIVE_INFINITY);
      solver.minimize(flight, theta);
    }
  }

  /**
   * Parameters that the kick hardly determines are tied to their start, the least known first: free, they would drag the others
   * along; held, they would make them look better known than they are.
   */
  private String[] tieUndetermined(
      FlightProblem flight, double[] theta, LevenbergMarquardt solver) {
    String[] reasons = new String[size];
    for (int round = 0; round < 4; round++) {
      double[][] inverse = inverse(solver);
      double noise = Math.sqrt(varianceFactor(flight.used(), solver));
      double[] scales = scales(theta);
      int worst = -1;
      double most = DETERMINED;
      for (int k = FlightLayout.kickSize(kind); k < size; k++) {
        if (!parameters.get(k).estimated() || reasons[k] != null) {
          continue;
        }
        double relative =
            inverse == null || inverse[k][k] <= 0
                ? Double.MAX_VALUE
                : noise * Math.sqrt(inverse[k][k]) / scales[k];
        if (solver.equations().a[k][k] <= 0) {
          relative = Double.POSITIVE_INFINITY;
        }
        if (relative > most) {
          most = relative;
          worst = k;
        }
      }
      if (worst < 0) {
        break;
      }
      reasons[worst] = FlightLayout.whyUndetermined(parameters.get(worst), most * scales[worst]);
      flight.prior(worst, parameters.get(worst).value(), parameters.get(worst).scale());
      solver.minimize(flight, theta);
    }
    return reasons;
  }

  /** The scales at the fitted values, by which an error is judged: a published model that is far off does not make a kick determine less or more. */
  private double[] scales(double[] theta) {
    double[] scales = parameters.stream().mapToDouble(Parameter::scale).toArray();
    if (kind == KickKind.FLAT) {
      List<Parameter> fitted = FlightLayout.flatModel(theta).parameters();
      for (int k = 0; k < fitted.size(); k++) {
        scales[FlightLayout.kickSize(kind) + k] = fitted.get(k).scale();
      }
    }
    return scales;
  }

  /** By how much the residuals exceed the cameras' noise, as variances: chi-square per degree of freedom, no less than the floor of that noise. */
  private double varianceFactor(boolean[] used, LevenbergMarquardt solver) {
    int count = 0;
    for (boolean u : used) {
      count += u ? 1 : 0;
    }
    return Math.max(solver.equations().cost / degrees(count), floor(used));
  }

  private double[][] inverse(LevenbergMarquardt solver) {
    boolean[] free = new boolean[size];
    for (int k = 0; k < size; k++) {
      free[k] = parameters.get(k).estimated() && solver.equations().a[k][k] > 0;
    }
    return solver.equations().inverse(solver.scale(), free);
  }

  /** The least chi-square per degree of freedom, from the floor of the cameras' noise: cleaner data do not make the closed forms more exact. */
  private double floor(boolean[] used) {
    double sum = 0;
    int n = 0;
    for (int i = 0; i < used.length; i++) {
      sum += used[i] ? data.floor[i] : 0;
      n += used[i] ? 1 : 0;
    }
    return sum / Math.max(1, n);
  }

  private KickFit result(
      Minimum best, LevenbergMarquardt solver, String[] reasons, double[] rx, double[] ry) {
    boolean[] used = best.flight().used();
    int count = 0;
    double sum = 0;
    for (int i = 0; i < used.length; i++) {
      if (used[i]) {
        count++;
        sum += rx[i] * rx[i] + ry[i] * ry[i];
      }
    }
    Screening screening = Screening.of(data, rx, ry, settings.outlierDistance());
    int lackOfFit = 0;
    for (int i = 0; i < used.length; i++) {
      lackOfFit += used[i] && screening.verdict(i) != Screening.Verdict.FITS ? 1 : 0;
    }
    int degrees = degrees(count);
    double chiSquare = solver.equations().cost;
    double[][] covariance = inverse(solver);
    double factor = varianceFactor(used, solver);
    List<Estimate> estimates = new ArrayList<>();
    for (int k = 0; k < size; k++) {
      Parameter p = parameters.get(k);
      double value = best.theta()[k];
      double variance = covariance == null ? Double.NaN : covariance[k][k] * factor;
      double error = p.estimated() && variance > 0 ? Math.sqrt(variance) : Double.NaN;
      // A search stops just short of a bound: nearer than a thousandth of the error is at it.
      double near = error > 0 ? AT_BOUND * error : 0;
      boolean bound = p.estimated() && (value <= p.min() + near || value >= p.max() - near);
      estimates.add(
          new Estimate(p.withValue(value), error, Optional.ofNullable(reasons[k]), bound));
    }
    double[][] scaled = covariance == null ? new double[size][size] : covariance;
    for (double[] row : scaled) {
      for (int k = 0; k < size; k++) {
        row[k] *= factor;
      }
    }
    FitStatistics statistics =
        new FitStatistics(
            data.size,
            count,
            lackOfFit,
            1000 * Math.sqrt(sum / (2.0 * Math.max(1, count))),
            chiSquare,
            degrees,
            factor,
            screening.robustScale(),
            best.flights(),
            evaluations,
            solver.iterations(),
            solver.stop().name().toLowerCase(java.util.Locale.ROOT).replace('_', ' '),
            seed);
    return new KickFit(
        problem.kick(),
        kind,
        estimates,
        scaled,
        FlightLayout.trajectory(kind, best.theta(), best.flights()),
        rx,
        ry,
        used,
        statistics);
  }
}
