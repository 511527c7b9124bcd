package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution.StopReason;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * Where a joint fit stands, and its way down: Levenberg–Marquardt on the equations from which each kick's own parameters are eliminated (Schur complement).
 *
 * <p>Derivatives are what takes the time, so they serve for several steps (chord steps; Ortega and Rheinboldt 1970, "Iterative solution of nonlinear equations", chapter 7): with old derivatives a step moves towards a point where these, and not the
 * new ones, see no slope. So a descent to a minimum ends only after a step with new derivatives that gains too little to matter. Mutable, not thread-safe; kicks are worked on in parallel with the same result as one by one.
 *
 * @param <S> what the global parameters amount to
 */
final class Descent<S> {
  /** A step counts as foreseen when it takes that share of what it should off the cost (Nocedal and Wright, "Numerical optimization", chapter 4). */
  private static final double GOOD_STEP = 0.25;

  /** A step with old derivatives must gain less than that share of the step before, or they are not good enough: errors then shrink to less than a third with each step. */
  private static final double FAST = 0.1;

  /** What a descent may gain in all, in gains that the equations promise where it begins: the promise is exact where residuals are linear. Where paths bend, these are not all: chosen; of 16 descents for hops that were worth it, in chips of two other generators, none gained more than 1.6 times as much. */
  static final double TRUSTED = 2;

  /** A cost that rises by less than that share is the same but for rounding. */
  private static final double SAME_COST = 1e-9;

  private final SharedProblem<S> problem;
  private final int maxIterations;
  private final double tolerance;
  private final int[] free;
  private final int[] meanColumns;
  private final double[] scale;
  private final int rows;

  private final List<KickTerm<S>> kicks;
  private final List<double[]> own = new ArrayList<>();
  private double[] values;
  private final double[] scatters;

  private Damping damping = new Damping();
  private boolean corrects;

  /** Null where there are none, or none for the kicks as they are now. */
  private KickColumns[] columns;

  /** Whether the derivatives are those of this very point. */
  private boolean fresh;

  /** Null where they are not known. */
  private double[][] residuals;

  private KickBlock[] blocks;
  private double cost;
  private int iterations;
  private StopReason reason = StopReason.TOO_MANY_ITERATIONS;

  Descent(SharedProblem<S> problem, int maxIterations, double tolerance) {
    this.problem = problem;
    this.maxIterations = maxIterations;
    this.tolerance = tolerance;
    kicks = new ArrayList<>(problem.kicks());
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
    scale = problem.scales(free);
    rows = kicks.stream().mapToInt(KickTerm::rows).sum();
  }

  /** The same for some of the kicks, to go down from here with the derivatives that all have here; before the first step. */
  Descent<S> restrictedTo(int[] kept) {
    if (columns == null) {
      linearize();
    }
    Descent<S> some = new Descent<>(problem.restrictedTo(kept), maxIterations, tolerance);
    some.columns = Arrays.stream(kept).mapToObj(k -> columns[k]).toArray(KickColumns[]::new);
    some.residuals = Arrays.stream(kept).mapToObj(k -> residuals[k]).toArray(double[][]::new);
    some.fresh = fresh;
    return some;
  }

  /** A place to come back to, with the derivatives that there were. */
  record Mark<S>(
      List<KickTerm<S>> kicks,
      List<double[]> own,
      double[] values,
      StopReason reason,
      KickColumns[] columns,
      boolean fresh,
      double[][] residuals) {}

  Mark<S> mark() {
    return new Mark<>(
        List.copyOf(kicks), List.copyOf(own), values, reason, columns, fresh, residuals);
  }

  void backTo(Mark<S> mark) {
    for (int k = 0; k < kicks.size(); k++) {
      put(k, mark.kicks.get(k), mark.own.get(k));
    }
    values = mark.values;
    reason = mark.reason;
    columns = mark.columns;
    fresh = mark.fresh;
    residuals = mark.residuals;
    if (columns != null) {
      equate();
    }
  }

  List<KickTerm<S>> kicks() {
    return kicks;
  }

  List<double[]> own() {
    return own;
  }

  double[] values() {
    return values;
  }

  double[] means() {
    return problem.means(values);
  }

  double[] scatters() {
    return scatters;
  }

  S state() {
    return problem.model().at(values);
  }

  /** The equations here, as last seen; with the scatters of that time. */
  KickBlock[] blocks() {
    return blocks;
  }

  /** The cost as last seen. */
  double cost() {
    return cost;
  }

  /** A kick with another value of its discrete unknown, or started elsewhere. */
  void put(int kick, KickTerm<S> term, double[] ownParameters) {
    kicks.set(kick, term);
    own.set(kick, ownParameters);
    columns = null;
    residuals = null;
  }

  /** Steps are damped as at the beginning again. */
  void undamp() {
    damping = new Damping();
  }

  /** From now on steps are corrected: along curved floors at the end, since from far away it leads to other minima than the nearest. */
  void correct() {
    corrects = true;
    undamp();
  }

  SharedSolution<S> solution() {
    if (columns == null) {
      linearize();
    }
    for (KickBlock block : blocks) {
      block.factor(0);
    }
    return new SharedSolution<>(
        problem, kicks, own, values, scatters, free, blocks, cost, iterations, reason);
  }

  /** Whether a descent from here may end below a cost: the equations promise at least half of what is missing. */
  boolean mayFallBelow(double limit) {
    if (columns == null) {
      linearize();
    }
    double[] step = step();
    if (step == null) {
      return true;
    }
    double[] made = madeBy(after(step));
    return cost - TRUSTED * expectedGain(made, ownAfter(made)) <= limit;
  }

  /** Goes down to the next minimum, the scatters held. */
  void descend() {
    descend(true);
  }

  /** The same, but what old derivatives hold for the minimum will do: something changes again before the end. */
  void approach() {
    descend(false);
  }

  private void descend(boolean confirms) {
    if (columns == null || corrects && !fresh) {
      linearize();
    } else {
      equate();
    }
    if (!Double.isFinite(cost)) {
      // Nothing can be predicted here, so there are no equations that lead away.
      reason = StopReason.SINGULAR;
      return;
    }
    damping.restarted();
    reason = StopReason.TOO_MANY_ITERATIONS;
    double gainBefore = Double.POSITIVE_INFINITY;
    // Steps with old derivatives are not counted: each but the last of a row gains a tenth of the
    // one before.
    for (int i = 0; i < maxIterations; i += fresh ? 1 : 0) {
      iterations++;
      double[] step = step();
      if (step == null && !fresh) {
        linearize();
        continue;
      }
      if (step == null) {
        reason = StopReason.SINGULAR;
        return;
      }
      boolean exact = fresh;
      Point next = next(step);
      if (next.cost <= cost) {
        double gain = cost - next.cost;
        moveTo(next);
        damping.accepted();
        boolean small = gain < tolerance * Math.max(1, cost / Math.max(1, rows));
        if (small && (exact || !confirms)) {
          reason = StopReason.CONVERGED;
          return;
        }
        boolean slow = small || corrects || gain > FAST * gainBefore;
        gainBefore = gain;
        if (slow) {
          linearize();
          gainBefore = Double.POSITIVE_INFINITY;
        }
      } else if (!exact) {
        linearize();
        gainBefore = Double.POSITIVE_INFINITY;
      } else {
        if (next.cost - cost < SAME_COST * cost) {
          reason = StopReason.CONVERGED;
          return;
        }
        if (damping.isLargest()) {
          reason = StopReason.NO_DESCENT;
          return;
        }
        damping.rejected();
      }
    }
  }

  /** Somewhere near, with residuals and cost. */
  private record Point(double[] values, List<double[]> own, double[][] residuals, double cost) {}

  /** Where a step of the free global parameters leads, each kick's own parameters following. */
  private Point next(double[] step) {
    double[] next = after(step);
    double[] made = madeBy(next);
    Point straight = point(next, ownAfter(made));
    if (!corrects || straight.cost <= cost) {
      return straight;
    }
    Point corrected = point(next, corrected(next, straight.own));
    double expected = expectedGain(made, straight.own);
    return cost - corrected.cost > GOOD_STEP * expected ? corrected : straight;
  }

  /** The global parameters after a step of the free ones, as far as their bounds allow it. */
  private double[] after(double[] step) {
    double[] next = values.clone();
    for (int f = 0; f < free.length; f++) {
      next[free[f]] = problem.globals().get(free[f]).clamp(values[free[f]] + step[f]);
    }
    return next;
  }

  /** The step of the free global parameters that leads to these. */
  private double[] madeBy(double[] next) {
    double[] made = new double[free.length];
    for (int f = 0; f < free.length; f++) {
      made[f] = next[free[f]] - values[free[f]];
    }
    return made;
  }

  private Point point(double[] at, List<double[]> owns) {
    S state = problem.model().at(at);
    double[] means = problem.means(at);
    double[][] all = new double[kicks.size()][];
    double[] costs = new double[kicks.size()];
    IntStream.range(0, costs.length)
        .parallel()
        .forEach(
            k -> {
              KickTerm<S> term = kicks.get(k);
              double[] r = new double[term.rows()];
              all[k] = r;
              if (!KickBlock.areFinite(owns.get(k))) {
                costs[k] = Double.POSITIVE_INFINITY;
                return;
              }
              term.residuals(owns.get(k), state, r);
              costs[k] =
                  problem.weights()[k] * KickBlock.dot(r, r)
                      + OwnPriors.cost(term, owns.get(k), means, scatters);
            });
    // Summed in order, so that the result does not depend on the number of threads.
    double sum = globalCost(at);
    for (double c : costs) {
      sum += c;
    }
    return new Point(at, owns, all, sum);
  }

  private void moveTo(Point next) {
    values = next.values;
    for (int k = 0; k < own.size(); k++) {
      own.set(k, next.own.get(k));
    }
    residuals = next.residuals;
    fresh = false;
    equate();
  }

  /**
   * Where the equations of this point have their minimum.
   *
   * @param means of the random effects
   * @param own parameters of each kick
   */
  record Foreseen(double[] means, List<double[]> own) {}

  /** The minimum that the equations promise beside the scatters as they are now; this point where they are singular. Nothing is predicted again. Leaves the blocks factored without damping. */
  Foreseen foreseen() {
    equate();
    double[] step = step();
    Foreseen there = new Foreseen(means(), List.copyOf(own));
    if (step != null) {
      double[] next = after(step);
      there = new Foreseen(problem.means(next), ownAfter(madeBy(next)));
    }
    for (KickBlock block : blocks) {
      block.factor(0);
    }
    return there;
  }

  /** Takes new derivatives. */
  private void linearize() {
    residuals = residuals == null ? new double[kicks.size()][] : residuals.clone();
    columns = new Linearizer<>(problem, kicks, own, values, scatters).columns(free, residuals);
    fresh = true;
    equate();
  }

  /** Makes the equations of this point from the derivatives that there are. */
  private void equate() {
    double[] means = means();
    blocks =
        eachKick(
                k -> {
                  KickBlock block = columns[k].equations(residuals[k]);
                  OwnPriors.tie(block, kicks.get(k), own.get(k), means, meanColumns, scatters);
                  return block;
                })
            .toArray(KickBlock[]::new);
    cost = globalCost(values);
    for (KickBlock block : blocks) {
      cost += block.chiSquare + block.priorCost;
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
    OwnFitter<S> fitter =
        new OwnFitter<>(1, tolerance, problem.model().at(at), problem.means(at), scatters);
    double lambda = damping.lambda();
    return eachKick(k -> fitter.stepped(kicks.get(k), owns.get(k), problem.weights()[k], lambda));
  }

  /** Something of every kick, worked out in parallel. */
  <T> List<T> eachKick(IntFunction<T> work) {
    List<T> all = new ArrayList<>();
    IntStream.range(0, kicks.size()).parallel().mapToObj(work).forEachOrdered(all::add);
    return all;
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

  /** The information of the free global parameters, the kicks' own ones eliminated; the blocks must be factored. */
  private double[][] information() {
    double[][] h = new double[free.length][];
    IntStream.range(0, h.length)
        .parallel()
        .forEach(
            i -> {
              h[i] = new double[i + 1];
              for (KickBlock block : blocks) {
                block.addReducedRow(i, h[i]);
              }
              h[i][i] += problem.priors().get(free[i]).precision();
            });
    return mirrored(h);
  }

  private static double[][] mirrored(double[][] lower) {
    int n = lower.length;
    double[][] full = new double[n][];
    for (int i = 0; i < n; i++) {
      full[i] = Arrays.copyOf(lower[i], n);
      for (int j = i + 1; j < n; j++) {
        full[i][j] = lower[j][i];
      }
    }
    return full;
  }

  /** The damped step of the free global parameters; null when the equations stay singular. */
  private double[] step() {
    double[][] given = new double[blocks.length][];
    for (int k = 0; k < given.length; k++) {
      given[k] = OwnBounds.given(kicks.get(k), own.get(k), blocks[k].ga);
    }
    double[] step = step(given);
    for (int round = 0; round < OwnBounds.ROUNDS && step != null; round++) {
      boolean cut = false;
      for (int k = 0; k < given.length; k++) {
        cut |= OwnBounds.cut(kicks.get(k), own.get(k), blocks[k].ownStep(step), given[k]);
      }
      if (!cut) {
        break;
      }
      step = step(given);
    }
    return step == null || !KickBlock.areFinite(step) ? null : step;
  }

  /** The same with the steps of some own parameters given. */
  private double[] step(double[][] given) {
    int n = free.length;
    while (true) {
      double lambda = damping.lambda();
      double[] g = new double[n];
      for (double[] t :
          eachKick(
              k -> {
                blocks[k].factor(lambda, given[k]);
                return blocks[k].reducedGradient();
              })) {
        for (int i = 0; i < n; i++) {
          g[i] += t[i];
        }
      }
      if (n == 0) {
        return g;
      }
      for (int i = 0; i < n; i++) {
        Prior prior = problem.priors().get(free[i]);
        g[i] -= prior.precision() * (values[free[i]] - prior.mean());
      }
      double[][] h = information();
      holdAtBounds(h, g);
      double[] step = ScaledEquations.solve(h, g, scale, lambda);
      if (step != null) {
        return step;
      }
      if (damping.isLargest()) {
        return null;
      }
      damping.singular();
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

  /** Variance of a random effect's mean; 0 when that is held, not determined, or as uncertain as a single value. The blocks must be factored without damping. */
  double meanVariance(int random) {
    int column = meanColumns[random];
    if (column < 0) {
      return 0;
    }
    return ScaledEquations.inverse(information(), scale)
        .map(v -> v[column][column])
        .filter(v -> v < scatters[random] * scatters[random])
        .orElse(0.0);
  }
}
