package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;

/**
 * The solution of a {@link SharedProblem}.
 *
 * <p>Covariance: residuals are taken to be whitened and independent within a kick, kicks to be independent of each other. The variance of a global parameter is the larger of the one that follows from
 * the residuals, times the reduced chi-square with the kicks' weights, and the one from the scatter between kicks (cluster-robust; Liang and Zeger 1986): where the model is not quite right, the first is too small. There is none where the
 * equations are singular.
 *
 * @param <S> what the global parameters amount to
 */
public final class SharedSolution<S> {

  /** Why the solver stopped. */
  public enum StopReason {
    /** A step gained too little to matter. */
    CONVERGED,
    /** The limit of iterations was reached. */
    TOO_MANY_ITERATIONS,
    /** No step, however short, lowers the cost. */
    NO_DESCENT,
    /** The equations are singular even when damped, or not finite. */
    SINGULAR
  }

  /** Relative damping of the step to the solution without some kicks: along directions that hardly any kick determines it would lead beyond where the equations hold. */
  private static final double NEWTON_DAMPING = 1e-3;

  /**
   * Steps of a fit without some of the kicks, which begins at the fit of all. Where the model is right two or three end it; where nothing is right, it would creep along for forty, which took half of the time of a diagnosis, and what is
   * asked is how the kicks that were left out are predicted, not where the last unit of chi-square is. Chosen.
   */
  private static final int MOST_STEPS_WITHOUT = 10;

  private final SharedProblem<S> problem;
  private final List<KickTerm<S>> kicks;
  private final List<double[]> own;
  private final double[] values;
  private final double[] scatters;
  private final int[] free;
  private final double[][][] reduced;
  private final double[][] gradients;

  /** For each kick and free global parameter, by how much the own parameters follow it, with the sign turned round. */
  private final double[][][] following;

  private final double[] chiSquares;

  /** For each kick and random effect, what the kick itself tells of its value, in units of what the scatter tells. */
  private final double[][] told;

  private final double cost;
  private final double randomCost;
  private final int iterations;
  private final StopReason stopReason;

  SharedSolution(
      SharedProblem<S> problem,
      List<KickTerm<S>> kicks,
      List<double[]> own,
      double[] values,
      double[] scatters,
      int[] free,
      KickBlock[] blocks,
      double cost,
      int iterations,
      StopReason stopReason) {
    this.problem = problem;
    this.kicks = List.copyOf(kicks);
    this.own = own.stream().map(double[]::clone).toList();
    this.values = values.clone();
    this.scatters = scatters.clone();
    this.free = free.clone();
    this.cost = cost;
    this.iterations = iterations;
    this.stopReason = stopReason;
    reduced = new double[blocks.length][][];
    gradients = new double[blocks.length][];
    following = new double[blocks.length][][];
    chiSquares = new double[blocks.length];
    told = new double[blocks.length][scatters.length];
    double marginal = 0;
    for (int k = 0; k < blocks.length; k++) {
      reduced[k] = blocks[k].reducedMatrix();
      gradients[k] = blocks[k].reducedGradient();
      following[k] = blocks[k].following();
      chiSquares[k] = blocks[k].chiSquare / problem.weights()[k];
      for (int r = 0; r < scatters.length; r++) {
        double left = blocks[k].ownVariance(blocks[k].own - scatters.length + r);
        told[k][r] = Math.max(0, scatters[r] * scatters[r] / left - 1);
        marginal += Math.log1p(told[k][r]);
      }
    }
    randomCost = marginal;
  }

  private SharedSolution(SharedSolution<S> of, int[] kept) {
    problem = of.problem.restrictedTo(kept);
    kicks = Arrays.stream(kept).mapToObj(of.kicks::get).toList();
    own = Arrays.stream(kept).mapToObj(of.own::get).toList();
    values = of.values;
    scatters = of.scatters;
    free = of.free;
    cost = of.cost;
    randomCost = of.randomCost;
    iterations = of.iterations;
    stopReason = of.stopReason;
    reduced = Arrays.stream(kept).mapToObj(k -> of.reduced[k]).toArray(double[][][]::new);
    gradients = Arrays.stream(kept).mapToObj(k -> of.gradients[k]).toArray(double[][]::new);
    following = Arrays.stream(kept).mapToObj(k -> of.following[k]).toArray(double[][][]::new);
    chiSquares = Arrays.stream(kept).mapToDouble(k -> of.chiSquares[k]).toArray();
    told = Arrays.stream(kept).mapToObj(k -> of.told[k]).toArray(double[][]::new);
  }

  /**
   * The same parameters, looked at for some of the kicks only; costs stay those of all.
   *
   * @param kept indices of the kicks
   * @return the kicks in that order
   */
  public SharedSolution<S> restrictedTo(int[] kept) {
    return new SharedSolution<>(this, kept);
  }

  /**
   * What was solved.
   *
   * @return the problem
   */
  public SharedProblem<S> problem() {
    return problem;
  }

  /**
   * The kicks with the values of their discrete unknowns.
   *
   * @return in the problem's order
   */
  public List<KickTerm<S>> kicks() {
    return kicks;
  }

  /**
   * Own parameters of a kick.
   *
   * @param kick index of the kick, from 0
   * @return a copy, in the order and the units of its {@link KickTerm}; the values of random effects come last
   */
  public double[] own(int kick) {
    return own.get(kick).clone();
  }

  /**
   * Own parameters of all kicks.
   *
   * @return one array for each kick as {@link #own(int)}, in the problem's order; not to be changed
   */
  public List<double[]> own() {
    return own;
  }

  /**
   * Values of all global parameters, held ones included.
   *
   * @return a copy, in the problem's order, each in its parameter's unit
   */
  public double[] values() {
    return values.clone();
  }

  /**
   * The global parameters with their values; their standard errors are in {@link #covariance}.
   *
   * @return in the problem's order, held ones included
   */
  public List<Parameter> globals() {
    List<Parameter> all = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      all.add(problem.globals().get(i).withValue(values[i]));
    }
    return all;
  }

  /**
   * Scatters of the random effects: standard deviations from kick to kick.
   *
   * @return a copy, in the problem's order, each in the unit of its mean; empty without random effects
   */
  public double[] scatters() {
    return scatters.clone();
  }

  /**
   * What the kicks predict with.
   *
   * @return the state of the shared model at the solution
   */
  public S state() {
    return problem.model().at(values);
  }

  /**
   * Sum of squared whitened residuals of a kick, whatever its weight.
   *
   * @param kick index of the kick, from 0
   * @return chi-square (–), about the number of its residuals where the model is right
   */
  public double chiSquare(int kick) {
    return chiSquares[kick];
  }

  /**
   * Sum of squared whitened residuals of all kicks, each with weight 1.
   *
   * @return chi-square
   */
  public double chiSquare() {
    return Arrays.stream(chiSquares).sum();
  }

  /**
   * How many residuals there are.
   *
   * @return the number for all kicks together
   */
  public int rows() {
    return kicks.stream().mapToInt(KickTerm::rows).sum();
  }

  /**
   * Chi-square over degrees of freedom: the residuals minus the free global parameters and the kicks' own, values of random effects not counted; at least 1.
   *
   * @return (–) about 1 where the model is right
   */
  public double reducedChiSquare() {
    return chiSquare() / degreesOfFreedom();
  }

  private double degreesOfFreedom() {
    int unknowns = free.length;
    for (double[] p : own) {
      unknowns += p.length - scatters.length;
    }
    return Math.max(1, rows() - unknowns);
  }

  /** A kick that weighs less has already had its noise enlarged. */
  private double weightedReducedChiSquare() {
    double sum = 0;
    for (int k = 0; k < chiSquares.length; k++) {
      sum += problem.weights()[k] * chiSquares[k];
    }
    return sum / degreesOfFreedom();
  }

  /**
   * What was minimised: weighted chi-square and priors, and of random effects what the marginal likelihood adds.
   *
   * @return twice the negative logarithm of the posterior density, but for a constant
   */
  public double cost() {
    return cost + randomCost;
  }

  /**
   * The same with other weights of the kicks, everything held. A kick that weighs more also tells more of its values of random effects, which pay for that.
   *
   * @param weights one for each kick
   * @return twice the negative logarithm of the posterior density, but for a constant
   */
  public double costWith(double[] weights) {
    double sum = cost();
    for (int k = 0; k < weights.length; k++) {
      double before = problem.weights()[k];
      sum += (weights[k] - before) * chiSquares[k];
      for (double t : told[k]) {
        sum += Math.log1p(t * weights[k] / before) - Math.log1p(t);
      }
    }
    return sum;
  }

  /**
   * How many steps were tried.
   *
   * @return their number, those included that were not accepted
   */
  public int iterations() {
    return iterations;
  }

  /**
   * Why it ended.
   *
   * @return the reason
   */
  public StopReason stopReason() {
    return stopReason;
  }

  /**
   * Estimated parameters that ended on one of their bounds; their values are no measurements.
   *
   * @return names, in the problem's order; empty in a good fit
   */
  public List<String> boundsHit() {
    List<String> hit = new ArrayList<>();
    for (int f : free) {
      Parameter p = problem.globals().get(f);
      if (values[f] <= p.min() || values[f] >= p.max()) {
        hit.add(p.name());
      }
    }
    return hit;
  }

  /**
   * Covariance of all global parameters, see above; rows and columns of held ones are zero.
   *
   * @return square, as many rows as global parameters, in the product of their units; empty when the equations are singular
   */
  public Optional<double[][]> covariance() {
    int n = free.length;
    double[] scale = scales();
    double[][] h = information(new boolean[kicks.size()]);
    Optional<double[][]> inverse = ScaledEquations.inverse(h, scale);
    if (inverse.isEmpty()) {
      return Optional.empty();
    }
    double[][] v = inverse.get();
    double[][] scatter = new double[n][n];
    for (double[] g : gradients) {
      for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
          scatter[i][j] += g[i] * g[j];
        }
      }
    }
    int count = kicks.size();
    // The number of clusters less the parameters they share; Student's t of so few has longer
    // tails.
    double small = count > n + 1 ? count / (double) (count - 1) : 1;
    double noise = Math.max(1, weightedReducedChiSquare());
    double[][] sandwich = product(product(v, scatter), v);
    double[] larger = new double[n];
    for (int i = 0; i < n; i++) {
      double modelVariance = v[i][i] * noise;
      double robust = count > 2 ? sandwich[i][i] * small : 0;
      larger[i] = Math.sqrt(Math.max(1, robust / modelVariance) * noise);
    }
    double[][] full = new double[values.length][values.length];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        full[free[i]][free[j]] = v[i][j] * larger[i] * larger[j];
      }
    }
    return Optional.of(full);
  }

  private static double[][] product(double[][] a, double[][] b) {
    return new Array2DRowRealMatrix(a, false)
        .multiply(new Array2DRowRealMatrix(b, false))
        .getData();
  }

  private double[] scales() {
    return problem.scales(free);
  }

  private double[][] information(boolean[] without) {
    int n = free.length;
    double[][] h = new double[n][n];
    for (int k = 0; k < reduced.length; k++) {
      if (!without[k]) {
        for (int i = 0; i < n; i++) {
          for (int j = 0; j < n; j++) {
            h[i][j] += reduced[k][i][j];
          }
        }
      }
    }
    for (int i = 0; i < n; i++) {
      h[i][i] += problem.priors().get(free[i]).precision();
    }
    return h;
  }

  /**
   * What the cost would rise by, to first order, were some global parameters zero and all others fitted again: Wald's statistic.
   *
   * @param indices of free global parameters
   * @return rise of the cost; NaN when the equations are singular
   */
  public double waldLoss(int... indices) {
    Optional<double[][]> inverse =
        ScaledEquations.inverse(information(new boolean[kicks.size()]), scales());
    if (inverse.isEmpty()) {
      return Double.NaN;
    }
    int n = indices.length;
    double[] z = new double[n];
    double[] one = new double[n];
    double[][] correlation = new double[n][n];
    int[] at = new int[n];
    for (int i = 0; i < n; i++) {
      at[i] = Arrays.binarySearch(free, indices[i]);
    }
    double[][] v = inverse.get();
    for (int i = 0; i < n; i++) {
      z[i] = values[indices[i]] / Math.sqrt(v[at[i]][at[i]]);
      one[i] = 1;
      for (int j = 0; j < n; j++) {
        correlation[i][j] = v[at[i]][at[j]] / Math.sqrt(v[at[i]][at[i]] * v[at[j]][at[j]]);
      }
    }
    double[] solved = ScaledEquations.solve(correlation, z, one, 0);
    if (solved == null) {
      return Double.NaN;
    }
    double loss = 0;
    for (int i = 0; i < n; i++) {
      loss += z[i] * solved[i];
    }
    return loss;
  }

  /**
   * The global parameters as they would be without some kicks: one Newton step from the solution, exact where the model is linear. Where it leads beyond where the equations hold (a law with a limit, as of friction, that the kicks are short of), the other kicks are explained worse than before,
   * by more than the one unit of chi-square that a standard error is: they are then solved again, the scatters held.
   *
   * @param without whether to leave out each kick, one for each
   * @return values of all global parameters, within their bounds, in the problem's order
   */
  public double[] valuesWithout(boolean[] without) {
    return valuesWithoutEach(List.of(without)).get(0);
  }

  /**
   * The same for several choices of kicks, for which derivatives are taken at most once.
   *
   * @param parts for each choice, whether to leave out each kick
   * @return values for each choice
   */
  public List<double[]> valuesWithoutEach(List<boolean[]> parts) {
    List<double[]> all = new ArrayList<>();
    Descent<S> here = null;
    for (boolean[] without : parts) {
      double[] stepped = steppedWithout(without);
      if (stepped == null) {
        here = here == null ? descentFromHere() : here;
        stepped = refitted(here, without);
      }
      all.add(stepped);
    }
    return all;
  }

  /** The values after the Newton step; null where the other kicks are explained worse by it. */
  private double[] steppedWithout(boolean[] without) {
    int n = free.length;
    double[] g = new double[n];
    for (int k = 0; k < gradients.length; k++) {
      if (!without[k]) {
        for (int i = 0; i < n; i++) {
          g[i] += gradients[k][i];
        }
      }
    }
    for (int i = 0; i < n; i++) {
      Prior prior = problem.priors().get(free[i]);
      g[i] -= prior.precision() * (values[free[i]] - prior.mean());
    }
    double[] step = ScaledEquations.solve(information(without), g, scales(), NEWTON_DAMPING);
    if (step == null) {
      return values.clone();
    }
    double[] moved = values.clone();
    for (int i = 0; i < n; i++) {
      moved[free[i]] = problem.globals().get(free[i]).clamp(values[free[i]] + step[i]);
    }
    double[] before = problem.means(values);
    double[] after = problem.means(moved);
    S state = problem.model().at(moved);
    double least = costOfOthers(without, values, k -> cost(k, own.get(k), chiSquares[k], before));
    double reached = costOfOthers(without, moved, k -> costAt(moved, state, k, after));
    return reached <= least + Math.max(1, reducedChiSquare()) ? moved : null;
  }

  /** Global parameters of the kicks that stay, with the scatters and the discrete unknowns of all. What is asked is how others are predicted, so what the derivatives at the solution of all kicks say of the minimum will do. */
  private static <S> double[] refitted(Descent<S> here, boolean[] without) {
    int[] kept = IntStream.range(0, without.length).filter(k -> !without[k]).toArray();
    Descent<S> descent = here.restrictedTo(kept);
    descent.approach();
    return descent.values().clone();
  }

  private Descent<S> descentFromHere() {
    List<Parameter> start =
        IntStream.range(0, values.length)
            .mapToObj(i -> problem.globals().get(i).withValue(values[i]))
            .toList();
    List<RandomEffect> held =
        IntStream.range(0, scatters.length)
            .mapToObj(r -> problem.randoms().get(r).withScatter(scatters[r]))
            .toList();
    return new Descent<>(
        new SharedProblem<>(
            problem.model(), kicks, own, start, problem.priors(), held, problem.weights()),
        MOST_STEPS_WITHOUT,
        SharedSolver.COARSE);
  }

  /** The cost of all kicks but some, and of the priors. */
  private double costOfOthers(boolean[] without, double[] at, IntToDoubleFunction costOf) {
    double[] costs =
        IntStream.range(0, without.length)
            .parallel()
            .mapToDouble(k -> without[k] ? 0 : costOf.applyAsDouble(k))
            .toArray();
    // Summed in order, so that the result does not depend on the number of threads.
    double sum = 0;
    for (double c : costs) {
      sum += c;
    }
    for (int f : free) {
      Prior prior = problem.priors().get(f);
      double d = at[f] - prior.mean();
      sum += prior.precision() * d * d;
    }
    return sum;
  }

  private double cost(int k, double[] ownParameters, double chiSquare, double[] means) {
    return problem.weights()[k] * chiSquare
        + OwnPriors.cost(kicks.get(k), ownParameters, means, scatters);
  }

  /** The cost of a kick at other values of the global parameters, which its own ones follow to first order. */
  private double costAt(double[] at, S state, int k, double[] means) {
    KickTerm<S> term = kicks.get(k);
    double[] p = own.get(k).clone();
    for (int i = 0; i < free.length; i++) {
      double step = at[free[i]] - values[free[i]];
      for (int j = 0; step != 0 && j < p.length; j++) {
        p[j] -= following[k][i][j] * step;
      }
    }
    term.clamp(p);
    double[] residuals = new double[term.rows()];
    term.residuals(p, state, residuals);
    return cost(k, p, KickBlock.dot(residuals, residuals), means);
  }

  /**
   * The system of equations at the solution with further columns.
   *
   * @param probes one per column
   * @param weights of the kicks, which may differ from those that were solved with
   * @return the system
   */
  public ScoreSystem scores(List<Probe<S>> probes, double[] weights) {
    SharedProblem<S> weighted = problem.withWeights(weights);
    KickBlock[] blocks =
        new Linearizer<>(weighted, kicks, own, values, scatters)
            .blocks(free, problem.meanColumns(free), probes);
    return ScoreSystem.of(free.length, blocks);
  }

  /** The full report: why it stopped, costs, counts, values, bounds hit. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "%s after %d steps: cost %.6g, chi-square %.6g of %d residuals (reduced %.4g), %d"
                + " kicks%n",
            stopReason,
            iterations,
            cost(),
            chiSquare(),
            rows(),
            reducedChiSquare(),
            kicks.size()));
    Optional<double[][]> v = covariance();
    for (int i = 0; i < values.length; i++) {
      Parameter p = problem.globals().get(i);
      int index = i;
      String error = !p.estimated() ? "held" : v.map(c -> error(c, index)).orElse("singular");
      text.append(
          String.format(Locale.ROOT, "  %s = %.6g %s %s%n", p.name(), values[i], p.unit(), error));
    }
    for (int r = 0; r < scatters.length; r++) {
      text.append(
          String.format(
              Locale.ROOT,
              "  scatter of %s = %.4g%n",
              problem.globals().get(problem.randoms().get(r).mean()).name(),
              scatters[r]));
    }
    if (!boundsHit().isEmpty()) {
      text.append("  on a bound: ").append(boundsHit()).append('\n');
    }
    return text.toString();
  }

  private static String error(double[][] covariance, int i) {
    return String.format(Locale.ROOT, "± %.3g", Math.sqrt(covariance[i][i]));
  }
}
