package fieldcal.diagnosis;

import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.ObservedCamera;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * One fit of a hypothesis to all kicks; used once. Levenberg–Marquardt on all unknowns at once, each kick's own ones eliminated; a chip's number of flights is tried one up and down; the scatter of random effects is
 * found by expectation and maximisation (Dempster, Laird and Rubin 1977). Kicks are worked on in parallel, with the same result as one by one.
 */
final class JointFit {
  private static final int MAX_ITERATIONS = 60;

  /** A step that promises less decrease of chi-square is the last: an evidence is then right to that, far below what decides. */
  private static final double ENOUGH = 0.02;

  /** The same as a share of chi-square: where much is unexplained, less precision will do. */
  private static final double ENOUGH_OF_ALL = 1e-6;

  /** A step that raises chi-square by less than that share of it is a step on the spot. */
  private static final double UNEVEN = 1e-5;

  /** A kick whose cost a step raises by that factor went astray. */
  private static final double ASTRAY = 1.5;

  private static final double MOST_DAMPING = 1e10;

  /** With less damping than that a step goes nearly where the derivatives point. */
  private static final double UNDAMPED = 1e-2;

  /** How far the cost may end below what its derivatives promise at the start: a share of the decrease, and something. */
  private static final double MORE_THAN_PROMISED = 0.5;

  private static final double SOMEWHAT = 2;

  /** Rounds of trying other numbers of flights. */
  private static final int FLIGHT_ROUNDS = 4;

  /** Rounds of finding the scatter. */
  private static final int SCATTER_ROUNDS = 12;

  /** A chip that is explained that many times worse than the median kick, and that much worse than noise, may be in a wrong valley. */
  private static final double OUTLYING = 3;

  private static final double LEAST_OUTLYING = 2;

  /** Smallest scatter, in the effect's scales. */
  private static final double LEAST_SCATTER = 0.02;

  private final Hypothesis hypothesis;
  private final List<ObservedCamera> observers;
  private final SharedUnknowns unknowns;
  final List<KickModel> models = new ArrayList<>();
  private final double[] shared;
  private final double[] scatter;
  private final int size;
  private SharedState state;
  private List<KickNormal> normals;
  private double cost;
  private boolean converged;

  /** A fit that will not end below that cost is of no interest. */
  private double limit = Double.POSITIVE_INFINITY;

  JointFit(HypothesisFitter fitter, Hypothesis hypothesis, double[] start, double[] scatter) {
    this.hypothesis = hypothesis;
    observers = fitter.observers;
    this.scatter = scatter;
    unknowns = fitter.unknowns(hypothesis);
    size = unknowns.size;
    shared = start.clone();
    for (int k = 0; k < size; k++) {
      boolean held = !unknowns.free[k] && k < SharedUnknowns.MODEL;
      shared[k] = held ? unknowns.expectedValue[k] : unknowns.clamp(k, shared[k]);
    }
    for (KickData kick : fitter.kicks) {
      models.add(new KickModel(kick, hypothesis.random().size(), fitter.sessionStart));
    }
  }

  /** Every kick's own unknowns under the shared ones as they are. */
  void settleKicks() {
    SharedState at = SharedState.of(hypothesis, shared, observers);
    models.parallelStream().forEach(m -> new OwnFit(m, at, scatter).minimize());
  }

  /** Fits everything but some shared unknowns, which are held for that, and the numbers of flights. */
  void settleOthers(int held, int count) {
    boolean[] free = unknowns.free.clone();
    Arrays.fill(unknowns.free, held, held + count, false);
    minimize();
    settleFlights();
    System.arraycopy(free, 0, unknowns.free, 0, free.length);
  }

  /** The cost where the fit starts. */
  double costAtStart() {
    List<double[]> owns = models.stream().map(m -> m.own).toList();
    return costOf(SharedState.of(hypothesis, shared, observers), shared, owns);
  }

  FittedHypothesis fit(boolean flights) {
    minimize();
    if (flights) {
      settleFlights();
      followTheRule();
    }
    for (int round = 0; round < SCATTER_ROUNDS && scatter.length > 0; round++) {
      if (!updateScatter()) {
        break;
      }
      minimize();
    }
    return result();
  }

  /** The fit with the numbers of flights as they are; null when its cost would not be lower than a limit. */
  FittedHypothesis fitBelow(double mostCost) {
    limit = mostCost;
    minimize();
    return cost < limit ? result() : null;
  }

  private void minimize() {
    state = SharedState.of(hypothesis, shared, observers);
    linearize();
    double lambda = 1e-4;
    converged = false;
    for (int i = 0; i < MAX_ITERATIONS && !converged; i++) {
      double[][] a = new double[size][size];
      double[] b = new double[size];
      reduce(lambda, a, b);
      double[] step = new SharedNormal(unknowns, a).solve(b, lambda);
      if (step == null || !OwnFit.isFinite(step)) {
        lambda = Math.max(1e-6, lambda * 10);
        if (lambda > MOST_DAMPING) {
          return;
        }
        continue;
      }
      // A step that is damped promises less than there is.
      if (lambda < UNDAMPED
          && cost - (1 + MORE_THAN_PROMISED) * promised(b, step) > limit + SOMEWHAT) {
        return;
      }
      double[] next = shared.clone();
      for (int k = 0; k < size; k++) {
        next[k] = unknowns.clamp(k, shared[k] + step[k]);
        step[k] = next[k] - shared[k];
      }
      List<double[]> owns = new ArrayList<>();
      for (int k = 0; k < models.size(); k++) {
        owns.add(models.get(k).moved(normals.get(k).ownStep(step)));
      }
      SharedState tried = SharedState.of(hypothesis, next, observers);
      double nextCost = settledCost(tried, next, owns);
      if (nextCost <= cost) {
        double gained = cost - nextCost;
        System.arraycopy(next, 0, shared, 0, size);
        for (int k = 0; k < models.size(); k++) {
          models.get(k).own = owns.get(k);
        }
        state = tried;
        lambda = Math.max(1e-7, lambda / 8);
        converged = gained < Math.max(ENOUGH, ENOUGH_OF_ALL * cost) && lambda < UNDAMPED;
        linearize();
      } else {
        // Detections that pass from one hop to the next make the cost uneven.
        converged = nextCost - cost < UNEVEN * cost;
        lambda = Math.max(1e-5, lambda * 6);
        if (lambda > MOST_DAMPING || Double.isNaN(nextCost) && lambda > 1e6) {
          return;
        }
      }
    }
  }

  /** By how much a step lowers the cost, as far as the problem is linear. */
  private double promised(double[] b, double[] step) {
    double sum = 0;
    for (int k = 0; k < size; k++) {
      sum += b[k] * step[k];
    }
    for (KickNormal n : normals) {
      sum += n.ownDecrease();
    }
    return sum;
  }

  private double costOf(SharedState at, double[] values, List<double[]> owns) {
    return sumOverKicks(k -> costOfKick(at, k, owns.get(k))) + sharedPrior(values);
  }

  /**
   * The cost at a trial point. A kick for which the common step went wrong finds its own unknowns anew: one kick, thrown into another valley, must not hold up all others.
   *
   * @param owns the kicks' own unknowns after the common step; replaced where they went wrong
   */
  private double settledCost(SharedState at, double[] values, List<double[]> owns) {
    return sumOverKicks(k -> settledCostOfKick(at, k, owns)) + sharedPrior(values);
  }

  private double settledCostOfKick(SharedState at, int kick, List<double[]> owns) {
    KickModel model = models.get(kick);
    double[] own = owns.get(kick);
    double stepped = OwnFit.isFinite(own) ? costOfKick(at, kick, own) : Double.POSITIVE_INFINITY;
    if (stepped <= ASTRAY * normals.get(kick).cost + 2 * model.data.size) {
      return stepped;
    }
    double[] before = model.own;
    double settled = new OwnFit(model, at, scatter).minimize();
    double[] found = model.own;
    model.own = before;
    if (stepped <= settled) {
      return stepped;
    }
    owns.set(kick, found);
    return settled;
  }

  private double costOfKick(SharedState at, int kick, double[] own) {
    KickModel model = models.get(kick);
    return model.cost(at, own, scatter, new double[2 * model.data.size]);
  }

  /** In parallel, but added in the kicks' order: the same result as one by one. */
  private double sumOverKicks(IntToDoubleFunction term) {
    double[] terms = new double[models.size()];
    IntStream.range(0, terms.length).parallel().forEach(k -> terms[k] = term.applyAsDouble(k));
    return Arrays.stream(terms).sum();
  }

  private double sharedPrior(double[] values) {
    double sum = 0;
    for (int k = 0; k < size; k++) {
      if (unknowns.free[k]) {
        double d = (values[k] - unknowns.expectedValue[k]) / unknowns.expectedError[k];
        sum += d * d;
      }
    }
    return sum;
  }

  private void linearize() {
    SharedState[] plus = new SharedState[size];
    Perturbation.fill(hypothesis, unknowns, state, observers, plus);
    KickNormal[] found = new KickNormal[models.size()];
    IntStream.range(0, found.length)
        .parallel()
        .forEach(k -> found[k] = normal(models.get(k), plus));
    normals = List.of(found);
    cost = sharedPrior(shared);
    for (KickNormal n : normals) {
      cost += n.cost;
    }
  }

  private KickNormal normal(KickModel model, SharedState[] plus) {
    int n = 2 * model.data.size;
    double[] residual = new double[n];
    ExtendedTrajectory path = model.path(state, model.own);
    double sum = model.residuals(state, path, residual);
    double[][] own = new double[model.ownSize][n];
    model.ownColumns(state, residual, own);
    double[][] columns = new double[size][];
    for (int k = 0; k < size; k++) {
      if (plus[k] != null && Perturbation.concerns(k, model.data.kind)) {
        columns[k] = new double[n];
        model.column(state, path, residual, plus[k], unknowns.step[k], columns[k]);
      }
    }
    double total = sum + model.priorCost(state, model.own, scatter);
    double[] ownScale = new double[model.ownSize];
    Arrays.setAll(ownScale, model::ownStep);
    KickNormal normal = new KickNormal(own, columns, residual, total, ownScale);
    model.tie(normal, state, scatter, true);
    return normal;
  }

  private void reduce(double lambda, double[][] a, double[] b) {
    for (KickNormal n : normals) {
      n.reduce(lambda, a, b);
    }
    for (int k = 0; k < size; k++) {
      if (unknowns.free[k]) {
        double weight = 1 / (unknowns.expectedError[k] * unknowns.expectedError[k]);
        a[k][k] += weight;
        b[k] += weight * (unknowns.expectedValue[k] - shared[k]);
      }
    }
  }

  private void settleFlights() {
    for (int round = 0; round < FLIGHT_ROUNDS && tryFlights(); round++) {
      minimize();
    }
  }

  /**
   * Where chips hop more or less often than the 10 mm rule says of them, starts once more with the rule's numbers. Wrong numbers of many kicks hold each other up: the shared unknowns make up for them, so that no
   * single kick gains by the right one.
   */
  private void followTheRule() {
    int[] rule = new int[models.size()];
    IntStream.range(0, rule.length)
        .parallel()
        .filter(k -> models.get(k).data.kind == KickKind.CHIP)
        .forEach(k -> rule[k] = models.get(k).flightsByRule(state, models.get(k).own));
    Point before = here();
    boolean differs = false;
    for (int k = 0; k < rule.length; k++) {
      KickModel model = models.get(k);
      int flights = rule[k] > 0 ? rule[k] : model.flights;
      differs |= flights != model.flights;
      model.flights = flights;
    }
    if (!differs) {
      return;
    }
    minimize();
    settleFlights();
    if (cost > before.cost) {
      backTo(before);
    }
  }

  /** Where a fit is, to come back to. */
  private record Point(
      double[] shared,
      List<double[]> owns,
      int[] flights,
      SharedState state,
      List<KickNormal> normals,
      double cost,
      boolean converged) {}

  private Point here() {
    return new Point(
        shared.clone(),
        models.stream().map(m -> m.own).toList(),
        models.stream().mapToInt(m -> m.flights).toArray(),
        state,
        normals,
        cost,
        converged);
  }

  private void backTo(Point point) {
    System.arraycopy(point.shared, 0, shared, 0, size);
    for (int k = 0; k < models.size(); k++) {
      models.get(k).own = point.owns.get(k);
      models.get(k).flights = point.flights[k];
    }
    state = point.state;
    normals = point.normals;
    cost = point.cost;
    converged = point.converged;
  }

  /** Tries one flight more and one less of each chip, and other rises of those that stand out, with the shared unknowns held; tells whether any changed. */
  private boolean tryFlights() {
    double[] misfits = new double[models.size()];
    Arrays.setAll(misfits, this::misfit);
    double[] sorted = misfits.clone();
    Arrays.sort(sorted);
    double outlying = Math.max(LEAST_OUTLYING, OUTLYING * sorted[sorted.length / 2]);
    boolean[] changed = new boolean[models.size()];
    IntStream.range(0, changed.length)
        .parallel()
        .forEach(
            k -> {
              KickModel model = models.get(k);
              if (model.data.kind == KickKind.CHIP) {
                OwnFit fit = new OwnFit(model, state, scatter);
                changed[k] = fit.chooseFlights() | (misfits[k] > outlying && fit.restart());
              }
            });
    boolean any = false;
    for (boolean c : changed) {
      any |= c;
    }
    return any;
  }

  private double misfit(int kick) {
    return normals.get(kick).cost / Math.max(1, 2 * models.get(kick).data.usedCount);
  }

  /** Expectation and maximisation; tells whether a scatter changed by more than a hundredth. */
  private boolean updateScatter() {
    double[][] a = new double[size][size];
    reduce(0, a, new double[size]);
    boolean changed = false;
    for (int j = 0; j < scatter.length; j++) {
      double sum = 0;
      double mean = shared[size - scatter.length + j];
      for (int k = 0; k < models.size(); k++) {
        KickModel model = models.get(k);
        double away = model.own[model.kickSize + j] - mean;
        sum += away * away + normals.get(k).ownVariance(model.kickSize + j);
      }
      double least = LEAST_SCATTER * hypothesis.random().get(j).scale(0);
      double next = Math.max(least, Math.sqrt(sum / models.size()));
      changed |= Math.abs(next - scatter[j]) > 0.01 * scatter[j];
      scatter[j] = next;
    }
    return changed;
  }

  private FittedHypothesis result() {
    double[][] a = new double[size][size];
    double[] b = new double[size];
    reduce(0, a, b);
    SharedNormal normal = new SharedNormal(unknowns, a);
    double evidence = -0.5 * cost - normal.occam();
    evidence -= hypothesis.hasEffect("worn_region") ? RegionSearch.PRICE : 0;
    List<double[]> own = new ArrayList<>();
    int[] flights = new int[models.size()];
    double chiSquare = 0;
    int residuals = 0;
    for (int k = 0; k < models.size(); k++) {
      KickModel model = models.get(k);
      own.add(model.own.clone());
      flights[k] = model.flights;
      chiSquare += normals.get(k).cost - model.priorCost(state, model.own, scatter);
      residuals += 2 * model.data.usedCount;
      evidence += randomEvidence(model, normals.get(k));
    }
    return new FittedHypothesis(
        hypothesis,
        shared.clone(),
        own,
        flights,
        scatter.clone(),
        chiSquare,
        cost,
        residuals,
        evidence,
        normal.covariance(),
        converged);
  }

  /** What the freedom of a kick's own magnitudes costs: −½ ln(1 + scatter²·information). */
  private double randomEvidence(KickModel model, KickNormal normal) {
    if (scatter.length == 0) {
      return 0;
    }
    double evidence =
        -0.5 * (normal.logDeterminant(model.ownSize) - normal.logDeterminant(model.kickSize));
    for (int j = 0; j < scatter.length; j++) {
      evidence -= Math.log(scatter[j] / model.ownStep(model.kickSize + j));
    }
    return evidence;
  }
}
