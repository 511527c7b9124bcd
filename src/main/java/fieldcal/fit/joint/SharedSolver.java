package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution.StopReason;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;

/**
 * Levenberg–Marquardt on the normal equations from which each kick's own parameters are eliminated (Schur complement; Triggs et al. 2000, "Bundle adjustment").
 *
 * <p>Derivatives by global parameters are differences of states, which are made once for all kicks. Scatters of random effects are updated between runs (EM); discrete unknowns of the kicks are settled with the shared
 * parameters held. Kicks are worked on in parallel with the same result as one by one. Immutable and thread-safe.
 */
public final class SharedSolver {
  /**
   * A step for a derivative, in scales of the parameter: the second order is then a ten-thousandth of the first for anything that bends within ten scales. Where two parameters do nearly the same (spin and kSwitch of flat kicks), a derivative
   * that is wrong by a quarter of a per cent would tell them apart and make their errors twenty times too small.
   */
  static final double DERIVATIVE_STEP = 0.001;

  /** Added to the curvature by scaled parameters, so that one that nothing determines stays where it is. */
  static final double UNDETERMINED = 1e-9;

  /** A corrected step counts when it takes that share of what it should off the cost (Nocedal and Wright, "Numerical optimization", chapter 4). */
  private static final double GOOD_STEP = 0.25;

  /** With more damping than that no step changes anything. */
  private static final double LARGEST_DAMPING = 1e10;

  private static final double SMALLEST_DAMPING = 1e-9;
  private static final double FIRST_DAMPING = 1e-5;

  /** Rounds in which scatters are updated and everything else follows, for a tolerance of a hundredth; EM shrinks the distance to the best scatter by half or more where the kicks determine their values. */
  private static final int SCATTER_ROUNDS = 12;

  /** Such rounds for a coarse solution. */
  private static final int FEW_SCATTER_ROUNDS = 3;

  /** From that tolerance on a solution is coarse: half a unit of chi-square moves no estimate by more than its error. */
  private static final double COARSE = 0.5;

  /** A scatter that changes by less than that share is settled: its own error is 1/√(2n), a tenth for fifty kicks. */
  private static final double SCATTER_SETTLED = 0.02;

  private static final int VARIANT_ROUNDS = 3;

  /** A kick that is explained that many times worse than the median kick may be in a local minimum. */
  private static final double STUCK = 4;

  /** Another start that leaves less than that share of chi-square was worth it. */
  private static final double IMPROVED = 0.8;

  private final int maxIterations;
  private final double tolerance;
  private final boolean settlesVariants;
  private final boolean startsByRule;

  private SharedSolver(
      int maxIterations, double tolerance, boolean settlesVariants, boolean startsByRule) {
    this.maxIterations = maxIterations;
    this.tolerance = tolerance;
    this.settlesVariants = settlesVariants;
    this.startsByRule = startsByRule;
  }

  /**
   * Solves until a step gains less than a hundredth of chi-square for each unit of the reduced one: it then moves no estimate by more than a tenth of its error.
   *
   * @return a solver that holds discrete unknowns
   */
  public static SharedSolver withDefaults() {
    return new SharedSolver(40, 0.01, false, false);
  }

  /**
   * The same with another limit.
   *
   * @param iterations most steps, accepted or not
   * @return the changed copy
   */
  public SharedSolver withMaxIterations(int iterations) {
    return new SharedSolver(iterations, tolerance, settlesVariants, startsByRule);
  }

  /**
   * The same with another end.
   *
   * @param gain of chi-square, in units of the reduced one, below which a step is the last
   * @return the changed copy
   */
  public SharedSolver withTolerance(double gain) {
    return new SharedSolver(maxIterations, gain, settlesVariants, startsByRule);
  }

  /**
   * The same, with neighbouring values of the kicks' discrete unknowns tried.
   *
   * @return the changed copy
   */
  public SharedSolver settlingVariants() {
    return new SharedSolver(maxIterations, tolerance, true, startsByRule);
  }

  /**
   * The same, with the kicks' discrete unknowns given the values of their rule before the first step, when the shared parameters still have the values that they start with: right where those are better known than what each kick alone says.
   *
   * @return the changed copy
   */
  public SharedSolver startingByRule() {
    return new SharedSolver(maxIterations, tolerance, true, true);
  }

  /**
   * Whether neighbouring values of the kicks' discrete unknowns are tried.
   *
   * @return false when they are held
   */
  public boolean settlesVariants() {
    return settlesVariants;
  }

  /**
   * Solves.
   *
   * @param problem to be solved
   * @param <S> what its global parameters amount to
   * @return the solution, with the reason why it stopped
   */
  public <S> SharedSolution<S> solve(SharedProblem<S> problem) {
    return new Run<>(problem).solve();
  }

  /**
   * Fits the own parameters of one kick, everything shared held.
   *
   * @param term the kick
   * @param start own parameters; not changed
   * @param state of the shared model
   * @param means of the random effects
   * @param scatters of the random effects
   * @param <S> what the global parameters amount to
   * @return the fit
   */
  public <S> OwnFit<S> fitOwn(
      KickTerm<S> term, double[] start, S state, double[] means, double[] scatters) {
    double[] own = start.clone();
    term.clamp(own);
    double[] residuals = new double[term.rows()];
    term.residuals(own, state, residuals);
    double cost = KickBlock.dot(residuals, residuals) + ownCost(term, own, means, scatters);
    double lambda = FIRST_DAMPING;
    double growth = 2;
    KickBlock block = null;
    double[] next = new double[term.rows()];
    double noise = Math.max(1, cost / Math.max(1, term.rows()));
    for (int i = 0; i < maxIterations && Double.isFinite(cost); i++) {
      if (block == null) {
        block = block(term, own, state, residuals, 1);
        tie(block, term, own, means, null, scatters);
      }
      block.factor(lambda);
      double[] step = block.ownStep(new double[0]);
      double[] candidate = own.clone();
      for (int k = 0; k < own.length; k++) {
        candidate[k] += step[k];
      }
      term.clamp(candidate);
      term.residuals(candidate, state, next);
      double nextCost = KickBlock.dot(next, next) + ownCost(term, candidate, means, scatters);
      if (nextCost <= cost) {
        boolean done = cost - nextCost < tolerance * noise;
        own = candidate;
        System.arraycopy(next, 0, residuals, 0, next.length);
        cost = nextCost;
        block = null;
        lambda = Math.max(SMALLEST_DAMPING, lambda / 5);
        growth = 2;
        if (done) {
          break;
        }
      } else {
        if (lambda > LARGEST_DAMPING || nextCost - cost < 1e-9 * cost) {
          break;
        }
        lambda *= growth;
        growth *= 2;
      }
    }
    return new OwnFit<>(term, own, cost, KickBlock.dot(residuals, residuals));
  }

  /**
   * One kick with everything shared held.
   *
   * @param term the kick, with the value of its discrete unknown
   * @param own parameters
   * @param cost chi-square and what the own parameters' priors add
   * @param chiSquare sum of squared residuals
   * @param <S> what the global parameters amount to
   */
  public record OwnFit<S>(KickTerm<S> term, double[] own, double cost, double chiSquare) {}

  /**
   * The best of a kick and its neighbours in the discrete unknown.
   *
   * @param stuck whether it is explained so much worse than its fellows that other starts are tried, too
   */
  <S> OwnFit<S> bestVariant(
      KickTerm<S> term, double[] own, S state, double[] means, double[] scatters, boolean stuck) {
    OwnFit<S> best = fitOwn(term, own, state, means, scatters);
    double bestPriced = best.cost + term.penalty(best.own, state);
    for (KickTerm<S> other : term.neighbours()) {
      OwnFit<S> tried = fitOwn(other, own, state, means, scatters);
      double priced = tried.cost + other.penalty(tried.own, state);
      if (isLess(priced, bestPriced)) {
        best = tried;
        bestPriced = priced;
      }
    }
    for (KickTerm.Restart<S> other :
        stuck ? term.restarts(own, state) : List.<KickTerm.Restart<S>>of()) {
      OwnFit<S> tried = fitOwn(other.term(), other.own(), state, means, scatters);
      double priced = tried.cost + other.term().penalty(tried.own, state);
      if (isLess(priced, bestPriced)) {
        best = tried;
        bestPriced = priced;
      }
    }
    return best;
  }

  /** By more than rounding; anything is less than what is impossible. */
  private static boolean isLess(double a, double b) {
    return a < b && (Double.isInfinite(b) || a < b - 1e-6 * Math.abs(b));
  }

  private static <S> KickBlock block(
      KickTerm<S> term, double[] own, S state, double[] residuals, double weight) {
    double[][] ownColumns = new double[own.length][residuals.length];
    term.ownColumns(own, state, residuals, ownColumns);
    KickBlock block = new KickBlock(own.length, 0);
    block.add(ownColumns, new double[0][], residuals, weight);
    return block;
  }

  /** Adds what is known of the own parameters: priors, and the random effects' ties to their means (free columns, or null when those are held). */
  static <S> void tie(
      KickBlock block,
      KickTerm<S> term,
      double[] own,
      double[] means,
      int[] meanColumns,
      double[] scatters) {
    int first = own.length - scatters.length;
    for (int i = 0; i < first; i++) {
      double precision = term.ownPrecision(i);
      if (precision > 0) {
        block.tieOwn(i, own[i] - term.ownPrior(i), precision);
      }
    }
    for (int r = 0; r < scatters.length; r++) {
      double precision = 1 / (scatters[r] * scatters[r]);
      int column = meanColumns == null ? -1 : meanColumns[r];
      block.tieToShared(first + r, column, own[first + r] - means[r], precision);
    }
  }

  static <S> double ownCost(KickTerm<S> term, double[] own, double[] means, double[] scatters) {
    int first = own.length - scatters.length;
    double cost = 0;
    for (int i = 0; i < first; i++) {
      double precision = term.ownPrecision(i);
      double d = precision > 0 ? own[i] - term.ownPrior(i) : 0;
      cost += precision * d * d;
    }
    for (int r = 0; r < scatters.length; r++) {
      double d = (own[first + r] - means[r]) / scatters[r];
      cost += d * d;
    }
    return cost;
  }

  /** One solution; used once. */
  private final class Run<S> {
    private final SharedProblem<S> problem;
    private final List<KickTerm<S>> kicks;
    private final List<double[]> own;
    private final int[] free;
    private final int[] meanColumns;
    private double[] values;
    private final double[] scatters;
    private KickBlock[] blocks;
    private double cost;
    private double lambda = FIRST_DAMPING;

    /** Whether steps are corrected: along curved floors at the end, since from far away it leads to other minima than the nearest. */
    private boolean corrects;

    private int iterations;
    private StopReason reason = StopReason.TOO_MANY_ITERATIONS;

    Run(SharedProblem<S> problem) {
      this.problem = problem;
      kicks = new ArrayList<>(problem.kicks());
      own = new ArrayList<>();
      for (int k = 0; k < kicks.size(); k++) {
        double[] start = problem.starts().get(k).clone();
        kicks.get(k).clamp(start);
        own.add(start);
      }
      free = problem.free();
      values = problem.values();
      for (int f : free) {
        values[f] = problem.globals().get(f).clamp(values[f]);
      }
      scatters = problem.randoms().stream().mapToDouble(RandomEffect::scatter).toArray();
      meanColumns = problem.meanColumns(free);
    }

    SharedSolution<S> solve() {
      if (startsByRule) {
        setByRule();
      }
      descendWithScatters();
      for (int round = 0; settlesVariants && round < VARIANT_ROUNDS; round++) {
        if (!settle()) {
          break;
        }
        descend();
      }
      if (settlesVariants) {
        obeyRule();
      }
      if (tolerance < COARSE && scatters.length > 0) {
        corrects = true;
        lambda = FIRST_DAMPING;
        descendWithScatters();
      }
      linearize();
      return solution();
    }

    private void descendWithScatters() {
      descend();
      int rounds = tolerance < COARSE ? SCATTER_ROUNDS : FEW_SCATTER_ROUNDS;
      for (int round = 0; round < rounds && scatters.length > 0; round++) {
        if (!updateScatters()) {
          break;
        }
        descend();
      }
    }

    private double[] means(double[] at) {
      return problem.randoms().stream().mapToDouble(r -> at[r.mean()]).toArray();
    }

    /**
     * Gives all discrete unknowns at once the values that their rule says, and keeps that if it explains more. Where the shared model is wrong or was, a bounce too many makes up for it in every kick; then no kick can be brought back alone, since the
     * others hold the shared parameters where theirs need them.
     */
    private void obeyRule() {
      List<KickTerm<S>> before = List.copyOf(kicks);
      List<double[]> ownBefore = List.copyOf(own);
      double[] valuesBefore = values;
      double least = pricedCost(before);
      if (!setByRule()) {
        return;
      }
      StopReason reasonBefore = reason;
      lambda = FIRST_DAMPING;
      descend();
      if (!isLess(pricedCost(kicks), least)) {
        for (int k = 0; k < before.size(); k++) {
          kicks.set(k, before.get(k));
          own.set(k, ownBefore.get(k));
        }
        values = valuesBefore;
        reason = reasonBefore;
        linearize();
      }
    }

    /** The values of the discrete unknowns by their rule, and what the own parameters are then; says whether that changes anything. */
    private boolean setByRule() {
      S state = problem.model().at(values);
      double[] means = means(values);
      List<OwnFit<S>> fits =
          IntStream.range(0, kicks.size())
              .parallel()
              .mapToObj(
                  k -> {
                    KickTerm<S> expected = kicks.get(k).byRule(own.get(k), state);
                    return expected == kicks.get(k)
                        ? null
                        : fitOwn(expected, own.get(k), state, means, scatters);
                  })
              .toList();
      for (int k = 0; k < fits.size(); k++) {
        if (fits.get(k) != null) {
          kicks.set(k, fits.get(k).term());
          own.set(k, fits.get(k).own());
        }
      }
      return fits.stream().anyMatch(Objects::nonNull);
    }

    /** The cost as last linearized, with what the values of the discrete unknowns add. */
    private double pricedCost(List<KickTerm<S>> terms) {
      S state = problem.model().at(values);
      double sum = cost;
      for (int k = 0; k < terms.size(); k++) {
        sum += problem.weights()[k] * terms.get(k).penalty(own.get(k), state);
      }
      return sum;
    }

    private boolean settle() {
      S state = problem.model().at(values);
      double[] means = means(values);
      double[] reduced = new double[kicks.size()];
      for (int k = 0; k < reduced.length; k++) {
        reduced[k] =
            blocks[k].chiSquare / (problem.weights()[k] * Math.max(1, kicks.get(k).rows()));
      }
      double[] sorted = reduced.clone();
      Arrays.sort(sorted);
      double limit = STUCK * Math.max(1, sorted[sorted.length / 2]);
      List<OwnFit<S>> fits =
          IntStream.range(0, kicks.size())
              .parallel()
              .mapToObj(
                  k ->
                      kicks.get(k).neighbours().isEmpty()
                          ? null
                          : bestVariant(
                              kicks.get(k), own.get(k), state, means, scatters, reduced[k] > limit))
              .toList();
      boolean changed = false;
      for (int k = 0; k < fits.size(); k++) {
        OwnFit<S> fit = fits.get(k);
        if (fit != null && (fit.term() != kicks.get(k) || reduced[k] > limit)) {
          changed |=
              fit.term() != kicks.get(k)
                  || fit.chiSquare() < IMPROVED * reduced[k] * fit.term().rows();
          kicks.set(k, fit.term());
          own.set(k, fit.own());
        }
      }
      return changed;
    }

    /** False, and nothing changed, when they are settled. */
    private boolean updateScatters() {
      boolean moved = false;
      double[] means = means(values);
      double[] updated = new double[scatters.length];
      for (KickBlock block : blocks) {
        block.factor(0);
      }
      for (int r = 0; r < scatters.length; r++) {
        double meanVariance = meanVariance(r);
        double sum = 0;
        for (int k = 0; k < kicks.size(); k++) {
          int i = own.get(k).length - scatters.length + r;
          double d = own.get(k)[i] - means[r];
          double left = blocks[k].ownVariance(i);
          // A value that the kick itself determines does not follow the mean when that errs.
          double stays = 1 - left / (scatters[r] * scatters[r]);
          sum += d * d + left + stays * stays * meanVariance;
        }
        RandomEffect random = problem.randoms().get(r);
        double next = Math.sqrt(sum / kicks.size());
        next = Math.max(random.smallest(), Math.min(random.largest(), next));
        moved |= Math.abs(next - scatters[r]) > SCATTER_SETTLED * scatters[r];
        updated[r] = next;
      }
      if (moved) {
        System.arraycopy(updated, 0, scatters, 0, updated.length);
      }
      return moved;
    }

    /** Variance of a random effect's mean; 0 when that is held or not determined. */
    private double meanVariance(int random) {
      int column = meanColumns[random];
      if (column < 0) {
        return 0;
      }
      int n = free.length;
      double[][] h = new double[n][n];
      double[] scale = new double[n];
      for (KickBlock block : blocks) {
        double[][] reduced = block.reducedMatrix();
        for (int i = 0; i < n; i++) {
          for (int j = 0; j < n; j++) {
            h[i][j] += reduced[i][j];
          }
        }
      }
      for (int i = 0; i < n; i++) {
        h[i][i] += problem.priors().get(free[i]).precision();
        scale[i] = problem.globals().get(free[i]).scale();
      }
      return SharedSolution.inverse(h, scale)
          .map(v -> v[column][column])
          .filter(v -> v < scatters[random] * scatters[random])
          .orElse(0.0);
    }

    private void descend() {
      linearize();
      double growth = 2;
      reason = StopReason.TOO_MANY_ITERATIONS;
      int rows = kicks.stream().mapToInt(KickTerm::rows).sum();
      for (int i = 0; i < maxIterations; i++) {
        iterations++;
        double[] step = step();
        if (step == null) {
          reason = StopReason.SINGULAR;
          return;
        }
        double[] next = values.clone();
        double[] made = new double[free.length];
        for (int f = 0; f < free.length; f++) {
          next[free[f]] = problem.globals().get(free[f]).clamp(values[free[f]] + step[f]);
          made[f] = next[free[f]] - values[free[f]];
        }
        List<double[]> nextOwn = ownAfter(made);
        double nextCost = cost(next, nextOwn);
        if (corrects && nextCost > cost) {
          List<double[]> corrected = corrected(next, nextOwn);
          double correctedCost = cost(next, corrected);
          if (cost - correctedCost > GOOD_STEP * expectedGain(made, nextOwn)) {
            nextOwn = corrected;
            nextCost = correctedCost;
          }
        }
        if (nextCost <= cost) {
          double gain = cost - nextCost;
          values = next;
          for (int k = 0; k < nextOwn.size(); k++) {
            own.set(k, nextOwn.get(k));
          }
          lambda = Math.max(SMALLEST_DAMPING, lambda / 5);
          growth = 2;
          linearize();
          if (gain < tolerance * Math.max(1, cost / Math.max(1, rows))) {
            reason = StopReason.CONVERGED;
            return;
          }
        } else {
          if (nextCost - cost < 1e-9 * cost) {
            reason = StopReason.CONVERGED;
            return;
          }
          if (lambda > LARGEST_DAMPING || Double.isNaN(cost)) {
            reason = StopReason.NO_DESCENT;
            return;
          }
          lambda *= growth;
          growth *= 2;
        }
      }
    }

    /** What a step should take off the cost if residuals were linear. */
    private double expectedGain(double[] step, List<double[]> nextOwn) {
      double gain = 0;
      for (int k = 0; k < kicks.size(); k++) {
        for (int i = 0; i < nextOwn.get(k).length; i++) {
          gain += blocks[k].ga[i] * (nextOwn.get(k)[i] - own.get(k)[i]);
        }
        for (int f = 0; f < step.length; f++) {
          gain += blocks[k].gc[f] * step[f];
        }
      }
      for (int f = 0; f < step.length; f++) {
        Prior prior = problem.priors().get(free[f]);
        gain -= prior.precision() * (values[free[f]] - prior.mean()) * step[f];
      }
      return gain;
    }

    private List<double[]> ownAfter(double[] step) {
      List<double[]> moved = new ArrayList<>();
      for (int k = 0; k < kicks.size(); k++) {
        double[] change = blocks[k].ownStep(step);
        double[] next = own.get(k).clone();
        for (int i = 0; i < next.length; i++) {
          next[i] += change[i];
        }
        kicks.get(k).clamp(next);
        moved.add(next);
      }
      return moved;
    }

    /**
     * The kicks' own parameters after a step of theirs alone: the second order of a shared step (Fletcher 1982, "Second order corrections"). Where shared and own parameters are multiplied, as kSwitch and each kick's spin, the straight step leaves the curved floor of
     * the cost at once and the solver would creep.
     */
    private List<double[]> corrected(double[] at, List<double[]> owns) {
      S state = problem.model().at(at);
      double[] means = means(at);
      return IntStream.range(0, kicks.size())
          .parallel()
          .mapToObj(
              k -> {
                KickTerm<S> term = kicks.get(k);
                double[] next = owns.get(k).clone();
                double[] residuals = new double[term.rows()];
                term.residuals(next, state, residuals);
                KickBlock block = block(term, next, state, residuals, problem.weights()[k]);
                tie(block, term, next, means, null, scatters);
                block.factor(lambda);
                double[] change = block.ownStep(new double[0]);
                for (int i = 0; i < next.length; i++) {
                  next[i] += change[i];
                }
                term.clamp(next);
                return next;
              })
          .toList();
    }

    private double cost(double[] at, List<double[]> owns) {
      S state = problem.model().at(at);
      double[] means = means(at);
      double[] costs =
          IntStream.range(0, kicks.size())
              .parallel()
              .mapToDouble(
                  k -> {
                    KickTerm<S> term = kicks.get(k);
                    double[] r = new double[term.rows()];
                    term.residuals(owns.get(k), state, r);
                    return problem.weights()[k] * KickBlock.dot(r, r)
                        + ownCost(term, owns.get(k), means, scatters);
                  })
              .toArray();
      // Summed in order, so that the result does not depend on the number of threads.
      double sum = globalCost(at);
      for (double c : costs) {
        sum += c;
      }
      return sum;
    }

    private double globalCost(double[] at) {
      double sum = 0;
      for (int f : free) {
        Prior prior = problem.priors().get(f);
        double d = at[f] - prior.mean();
        sum += prior.precision() * d * d;
      }
      return sum;
    }

    private void linearize() {
      blocks = new Linearizer<>(problem, kicks, own, values, scatters).blocks(free, meanColumns);
      cost = globalCost(values);
      for (KickBlock block : blocks) {
        cost += block.chiSquare + block.priorCost;
      }
    }

    /** The damped step of the free global parameters; null when the equations stay singular. */
    private double[] step() {
      int n = free.length;
      double[] scale = new double[n];
      for (int f = 0; f < n; f++) {
        scale[f] = problem.globals().get(free[f]).scale();
      }
      while (true) {
        double[][] h = new double[n][n];
        double[] g = new double[n];
        for (KickBlock block : blocks) {
          block.factor(lambda);
          double[][] s = block.reducedMatrix();
          double[] t = block.reducedGradient();
          for (int i = 0; i < n; i++) {
            g[i] += t[i];
            for (int j = 0; j < n; j++) {
              h[i][j] += s[i][j];
            }
          }
        }
        if (n == 0) {
          return g;
        }
        for (int i = 0; i < n; i++) {
          Prior prior = problem.priors().get(free[i]);
          h[i][i] += prior.precision();
          g[i] -= prior.precision() * (values[free[i]] - prior.mean());
        }
        holdAtBounds(h, g);
        double[] step = solveScaled(h, g, scale, lambda);
        if (step != null) {
          return step;
        }
        if (lambda > LARGEST_DAMPING) {
          return null;
        }
        lambda = Math.max(FIRST_DAMPING, 10 * lambda);
      }
    }

    /** A parameter on its bound that wants to go beyond is held for this step. */
    private void holdAtBounds(double[][] h, double[] g) {
      for (int i = 0; i < free.length; i++) {
        Parameter p = problem.globals().get(free[i]);
        double v = values[free[i]];
        if (v >= p.max() && g[i] > 0 || v <= p.min() && g[i] < 0) {
          for (int j = 0; j < free.length; j++) {
            h[i][j] = 0;
            h[j][i] = 0;
          }
          h[i][i] = 1 / (p.scale() * p.scale());
          g[i] = 0;
        }
      }
    }

    private SharedSolution<S> solution() {
      for (KickBlock block : blocks) {
        block.factor(0);
      }
      return new SharedSolution<>(
          problem, kicks, own, values, scatters, free, blocks, cost, iterations, reason);
    }
  }

  /** Equations in scaled variables, symmetric to the last bit: entries that are nothing but rounding differ across the diagonal by more than a decomposition accepts. */
  static double[][] scaled(double[][] h, double[] scale) {
    int n = scale.length;
    double[][] scaled = new double[n][n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        scaled[i][j] = 0.5 * (h[i][j] + h[j][i]) * scale[i] * scale[j];
        scaled[j][i] = scaled[i][j];
      }
    }
    return scaled;
  }

  /** Solves (H + λ·diag H)·x = g in scaled variables; null when that is not positive definite. */
  static double[] solveScaled(double[][] h, double[] g, double[] scale, double lambda) {
    int n = g.length;
    double[][] scaled = scaled(h, scale);
    double[] rhs = new double[n];
    for (int i = 0; i < n; i++) {
      scaled[i][i] = scaled[i][i] * (1 + lambda) + UNDETERMINED;
      rhs[i] = g[i] * scale[i];
      if (!Double.isFinite(scaled[i][i] + rhs[i])) {
        return null;
      }
    }
    try {
      double[] x =
          new CholeskyDecomposition(new Array2DRowRealMatrix(scaled, false), 1e-9, 1e-14)
              .getSolver()
              .solve(new ArrayRealVector(rhs, false))
              .toArray();
      for (int i = 0; i < n; i++) {
        x[i] *= scale[i];
      }
      return x;
    } catch (NonPositiveDefiniteMatrixException e) {
      return null;
    }
  }
}
