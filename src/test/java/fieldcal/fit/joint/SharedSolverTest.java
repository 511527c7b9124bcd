package fieldcal.fit.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution.StopReason;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;

/** The kernel on linear problems, of which everything is known. */
class SharedSolverTest {
  private static final double[] TRUTH = {1.5, -0.7, 0.4};

  /** Tight, so that what is compared is the answer and not where the solver stopped. */
  private static final SharedSolver SOLVER = SharedSolver.withDefaults().withTolerance(1e-12);

  private static List<ToyKick> kicks(int n, long seed) {
    return ToyProblem.kicks(n, TRUTH, 0, new SplittableRandom(seed));
  }

  private static List<Parameter> globals(int n) {
    List<Parameter> all = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      all.add(ToyProblem.parameter("g" + k, 0, 1 + k));
    }
    return all;
  }

  private static SharedSolution<double[]> solve(List<ToyKick> kicks) {
    return SOLVER.solve(ToyProblem.problem(kicks, globals(3), ToyProblem.noPriors(3)));
  }

  private static void assertClose(double[] found, double[] expected, double tolerance) {
    assertThat(found).hasSameSizeAs(expected);
    for (int k = 0; k < found.length; k++) {
      assertThat(found[k]).as("number %d", k).isEqualTo(expected[k], within(tolerance));
    }
  }

  @Test
  void estimatesAndErrorsAreThoseOfTheWholeSystem() {
    List<ToyKick> kicks = kicks(9, 1);
    ToyProblem.Dense dense = ToyProblem.dense(kicks, 3, new double[3]);
    SharedSolution<double[]> s = solve(kicks);
    assertThat(s.stopReason()).isEqualTo(StopReason.CONVERGED);
    assertClose(s.values(), dense.globals(3), 1e-6);
    assertClose(s.own(4), Arrays.copyOfRange(dense.values(), 8, 10), 1e-6);
    assertThat(s.chiSquare()).isEqualTo(dense.chiSquare(), within(1e-6));
    assertThat(s.rows()).isEqualTo(9 * 12);
    assertThat(s.reducedChiSquare()).isEqualTo(dense.chiSquare() / (9 * 12 - 21), within(1e-7));
    double[][] v = s.covariance().orElseThrow();
    for (int i = 0; i < 3; i++) {
      // The larger of what residuals and what the scatter between kicks say.
      double smallest = dense.covariance()[18 + i][18 + i];
      assertThat(v[i][i]).isBetween(0.999 * smallest, 4 * smallest);
    }
    assertThat(s.toString()).contains("CONVERGED", "g2", "9 kicks");
  }

  /** Of eight kicks the third begins where nothing can be predicted. */
  private static SharedProblem<double[]> withABlindKick(List<ToyKick> kicks) {
    SharedProblem<double[]> seen = ToyProblem.problem(kicks, globals(3), ToyProblem.noPriors(3));
    List<KickTerm<double[]>> terms = new ArrayList<>(kicks);
    terms.set(2, new BlindKick(kicks.get(2), 50));
    List<double[]> starts = new ArrayList<>(seen.starts());
    starts.set(2, new double[] {80, 0});
    return new SharedProblem<>(
        seen.model(), terms, starts, seen.globals(), seen.priors(), List.of(), seen.weights());
  }

  @Test
  void whereNothingCanBePredictedNothingIsFitted() {
    SharedSolution<double[]> s = SOLVER.solve(withABlindKick(kicks(8, 6)));
    assertThat(s.stopReason()).isEqualTo(StopReason.SINGULAR);
    assertThat(s.values()).containsOnly(0);
  }

  @Test
  void aKickThatCannotBePredictedBeginsAgain() {
    List<ToyKick> kicks = kicks(8, 6);
    SharedSolution<double[]> s = SOLVER.settlingVariants().solve(withABlindKick(kicks));
    assertThat(s.stopReason()).isEqualTo(StopReason.CONVERGED);
    assertClose(s.values(), ToyProblem.dense(kicks, 3, new double[3]).globals(3), 1e-6);
  }

  @Test
  void priorsCountLikeData() {
    List<ToyKick> kicks = kicks(5, 2);
    double[] precisions = {0, 30, 5};
    List<Prior> priors = List.of(Prior.NONE, new Prior(0, 30), new Prior(0, 5));
    SharedSolution<double[]> s = SOLVER.solve(ToyProblem.problem(kicks, globals(3), priors));
    assertClose(s.values(), ToyProblem.dense(kicks, 3, precisions).globals(3), 1e-6);
  }

  @Test
  void leavingKicksOutIsFittingWithoutThem() {
    List<ToyKick> kicks = kicks(8, 3);
    boolean[] without = new boolean[8];
    without[2] = true;
    without[5] = true;
    List<ToyKick> rest = new ArrayList<>(kicks);
    rest.remove(5);
    rest.remove(2);
    // The step is damped by a thousandth.
    assertClose(solve(kicks).valuesWithout(without), solve(rest).values(), 1e-3);
  }

  /** A law with a limit, as of friction, that no row comes to, and on which the rows depend hardly otherwise. */
  private record LimitedKick(double wanted) implements KickTerm<double[]> {
    private static final double HARDLY = 0.3;

    /** What the limit bounds: up to 0.7. */
    private static double free(int row) {
      return 0.1 * (row % 8);
    }

    private static double slight(int row) {
      return row % 2 == 0 ? HARDLY : -HARDLY;
    }

    @Override
    public int ownSize() {
      return 1;
    }

    @Override
    public int rows() {
      return 16;
    }

    @Override
    public void residuals(double[] own, double[] state, double[] out) {
      for (int i = 0; i < out.length; i++) {
        double limited = 10 * (free(i) - Math.min(free(i), state[0]));
        out[i] = limited + slight(i) * (wanted - state[0]) - own[0];
      }
    }

    @Override
    public void ownColumns(double[] own, double[] state, double[] residuals, double[][] columns) {
      Arrays.fill(columns[0], 1);
    }

    @Override
    public double ownPrior(int index) {
      return 0;
    }

    @Override
    public double ownPrecision(int index) {
      return 0;
    }
  }

  private static SharedSolution<double[]> solveLimited(List<LimitedKick> kicks) {
    double[] weights = new double[kicks.size()];
    Arrays.fill(weights, 1);
    return SOLVER.solve(
        new SharedProblem<>(
            double[]::clone,
            kicks,
            kicks.stream().map(k -> new double[1]).toList(),
            List.of(new Parameter("limit", "", 1, 1, 0, 10, true, "test")),
            List.of(Prior.NONE),
            List.of(),
            weights));
  }

  @Test
  void kicksAreSolvedAgainWhereTheEquationsDoNotHoldWithoutSome() {
    // All together want a limit of 1; without the first, one of −1, where it would bind.
    List<LimitedKick> kicks =
        List.of(new LimitedKick(7), new LimitedKick(-1), new LimitedKick(-1), new LimitedKick(-1));
    SharedSolution<double[]> all = solveLimited(kicks);
    assertThat(all.values()[0]).isCloseTo(1, within(1e-6));
    double without = all.valuesWithout(new boolean[] {true, false, false, false})[0];
    double best = solveLimited(kicks.subList(1, 4)).values()[0];
    assertThat(best).isBetween(0.6, 0.75);
    assertThat(without).isCloseTo(best, within(0.02));
  }

  private static SharedSolution<double[]> holding(List<ToyKick> kicks, int... held) {
    List<Parameter> globals = new ArrayList<>(globals(3));
    for (int k : held) {
      globals.set(k, globals.get(k).fixed());
    }
    return SOLVER.solve(ToyProblem.problem(kicks, globals, ToyProblem.noPriors(3)));
  }

  @Test
  void waldsLossIsWhatTheCostRisesBy() {
    List<ToyKick> kicks = kicks(8, 4);
    SharedSolution<double[]> s = solve(kicks);
    assertThat(s.waldLoss(1))
        .isEqualTo(holding(kicks, 1).cost() - s.cost(), within(1e-5 * s.waldLoss(1)));
    assertThat(s.waldLoss(0, 2))
        .isEqualTo(holding(kicks, 0, 2).cost() - s.cost(), within(1e-5 * s.waldLoss(0, 2)));
  }

  @Test
  void aKickOnABoundKeepsNobodyFromMoving() {
    List<ToyKick> free = kicks(8, 6);
    double wanted = solve(free).own(3)[0];
    // On its bound from the beginning, and on the way to it.
    for (double most : new double[] {wanted - 1, Math.max(1e-3, wanted - 0.2)}) {
      List<ToyKick> kicks = new ArrayList<>(free);
      kicks.set(3, free.get(3).withMost(most));
      SharedSolution<double[]> s = solve(kicks);
      assertThat(s.stopReason()).isEqualTo(StopReason.CONVERGED);
      // Linear equations: one step to the minimum, and those that confirm it.
      assertThat(s.iterations()).isLessThan(5);
      assertThat(s.own(3)[0]).isEqualTo(most);
      // Everything else is where its slope vanishes.
      double[] r = new double[12];
      double[] slope = new double[3];
      for (int k = 0; k < 8; k++) {
        kicks.get(k).residuals(s.own(k), s.values(), r);
        for (int g = 0; g < slope.length; g++) {
          slope[g] += KickBlock.dot(r, kicks.get(k).b[g]);
        }
        assertThat(KickBlock.dot(r, kicks.get(k).a[1])).isEqualTo(0, within(1e-4));
      }
      assertClose(slope, new double[3], 1e-4);
    }
  }

  @Test
  void scoresAreTrueGains() {
    List<ToyKick> kicks = kicks(8, 5);
    SharedSolution<double[]> without = holding(kicks, 2);
    double[] stepped = without.values();
    stepped[2] += 0.1;
    double[] weights = new double[8];
    Arrays.fill(weights, 1);
    ScoreSystem system = without.scores(List.of(new Probe<>(null, stepped, 0.1)), weights);
    assertThat(system.base()).isEqualTo(2);
    assertThat(system.size()).isEqualTo(3);
    assertThat(system.kicks()).isEqualTo(8);
    // What is left of the probe's curvature when the other two follow.
    double det =
        system.curvature(0, 0) * system.curvature(1, 1)
            - system.curvature(0, 1) * system.curvature(0, 1);
    double a = system.curvature(0, 2);
    double b = system.curvature(1, 2);
    double absorbed =
        (a * a * system.curvature(1, 1)
                - 2 * a * b * system.curvature(0, 1)
                + b * b * system.curvature(0, 0))
            / det;
    double gain = system.slope(2) * system.slope(2) / (system.curvature(2, 2) - absorbed);
    assertThat(system.slope(0)).isEqualTo(0, within(1e-4));
    assertThat(gain).isEqualTo(without.cost() - solve(kicks).cost(), within(1e-4 * gain));
    double sum = 0;
    for (int k = 0; k < 8; k++) {
      sum += system.slope(k, 2);
    }
    assertThat(sum).isEqualTo(system.slope(2), within(1e-9));
  }

  @Test
  void aProblemsEquationsAreThereWithoutSolvingIt() {
    List<ToyKick> kicks = kicks(8, 5);
    SharedProblem<double[]> problem = ToyProblem.problem(kicks, globals(3), ToyProblem.noPriors(3));
    ScoreSystem system = ScoreSystem.at(problem);
    assertThat(system.base()).isEqualTo(3);
    // One Newton step from anywhere is the answer, and what is left then is its cost.
    SharedSolution<double[]> s = SOLVER.solve(problem);
    double left = 0;
    for (int k = 0; k < 8; k++) {
      left += system.cost(k);
    }
    for (int i = 0; i < 3; i++) {
      double slope = 0;
      for (int j = 0; j < 3; j++) {
        slope += system.curvature(i, j) * s.values()[j];
      }
      assertThat(system.slope(i)).isEqualTo(slope, within(1e-5));
      left -= s.values()[i] * system.slope(i);
    }
    assertThat(left).isEqualTo(s.cost(), within(1e-4));
  }

  /** All kicks alike, each measuring its value ten times: the maximum of the restricted likelihood is known. */
  @Test
  void theScatterIsTheMostLikelyOne() {
    SplittableRandom random = new SplittableRandom(6);
    int n = 8;
    int rows = 10;
    double[] means = new double[n];
    List<ToyKick> kicks = new ArrayList<>();
    List<double[]> starts = new ArrayList<>();
    double[] weights = new double[n];
    Arrays.fill(weights, 1);
    for (int k = 0; k < n; k++) {
      double value = 2 + 0.8 * random.nextGaussian();
      double[] y = new double[rows];
      double[] one = new double[rows];
      for (int i = 0; i < rows; i++) {
        y[i] = value + random.nextGaussian();
        one[i] = 1;
        means[k] += y[i] / rows;
      }
      kicks.add(new ToyKick(y, new double[][] {one}, new double[][] {new double[rows]}));
      starts.add(new double[1]);
    }
    double mean = Arrays.stream(means).average().orElseThrow();
    double variance = Arrays.stream(means).map(m -> (m - mean) * (m - mean)).sum() / (n - 1);
    SharedSolution<double[]> s =
        SOLVER.solve(
            new SharedProblem<>(
                double[]::clone,
                kicks,
                starts,
                globals(1),
                ToyProblem.noPriors(1),
                List.of(new RandomEffect(0, 0.3, 1e-3, 10)),
                weights));
    assertThat(s.values()[0]).isEqualTo(mean, within(1e-6));
    double scatter = Math.sqrt(variance - 1.0 / rows);
    // EM ends when a round changes it by less than two per cent.
    assertThat(s.scatters()[0]).isEqualTo(scatter, within(0.05 * scatter));
    double error = Math.sqrt(s.covariance().orElseThrow()[0][0]);
    assertThat(error).isEqualTo(Math.sqrt(variance / n), within(0.15 * error));
    // Each kick's own value is drawn towards the mean by the share that its data do not tell.
    double share = 1 / (1 + 1 / (rows * s.scatters()[0] * s.scatters()[0]));
    assertThat(s.own(3)[0]).isEqualTo(mean + share * (means[3] - mean), within(1e-4));
  }

  /** Where the data are followed exactly, weights change nothing but what each kick tells of its value. */
  @Test
  void costsWithOtherWeightsAreThoseOfAFitWithThem() {
    List<ToyKick> exact = new ArrayList<>();
    for (ToyKick kick : ToyProblem.kicks(8, TRUTH, 0, new SplittableRandom(13))) {
      double[] y = new double[kick.rows()];
      for (int i = 0; i < y.length; i++) {
        for (int g = 0; g < TRUTH.length; g++) {
          y[i] += TRUTH[g] * kick.b[g][i];
        }
      }
      exact.add(new ToyKick(y, kick.a, kick.b));
    }
    SharedProblem<double[]> moved = ToyProblem.withRandom(exact, globals(3));
    double[] weights = {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1, 1};
    SharedSolution<double[]> alike = SOLVER.solve(held(moved, moved.weights()));
    SharedSolution<double[]> weighed = SOLVER.solve(held(moved, weights));
    assertThat(alike.costWith(moved.weights())).isEqualTo(alike.cost());
    assertThat(alike.costWith(weights)).isCloseTo(weighed.cost(), within(1e-6));
    assertThat(weighed.costWith(moved.weights())).isCloseTo(alike.cost(), within(1e-6));
    assertThat(alike.cost()).isGreaterThan(weighed.cost() + 1);
  }

  private static SharedProblem<double[]> held(SharedProblem<double[]> of, double[] weights) {
    return new SharedProblem<>(
        of.model(),
        of.kicks(),
        of.starts(),
        of.globals(),
        of.priors(),
        List.of(new RandomEffect(0, 0.5, 0.499_999_9, 0.500_000_1)),
        weights);
  }

  @Test
  void theDiscreteUnknownIsSettled() {
    SplittableRandom random = new SplittableRandom(7);
    List<ToyKick> kicks = new ArrayList<>();
    for (ToyKick kick : ToyProblem.kicks(6, TRUTH, 0, random)) {
      double[] y = kick.y.clone();
      for (int i = 0; i < y.length; i++) {
        y[i] += 2 * i;
      }
      // From impossible, from below and from above.
      int start = kicks.size() % 3 == 0 ? 4 : kicks.size() % 3;
      kicks.add(new ToyKick(y, kick.a, kick.b).withShift(start));
    }
    SharedProblem<double[]> problem = ToyProblem.problem(kicks, globals(3), ToyProblem.noPriors(3));
    SharedSolution<double[]> s = SOLVER.settlingVariants().solve(problem);
    assertThat(s.kicks()).allSatisfy(k -> assertThat(((ToyKick) k).shift()).isEqualTo(2));
    assertThat(SOLVER.solve(problem).kicks()).isEqualTo(problem.kicks());
  }

  @Test
  void aParameterOnItsBoundIsReported() {
    List<Parameter> globals = new ArrayList<>(globals(3));
    globals.set(0, globals.get(0).withBounds(-1, 1));
    SharedSolution<double[]> s =
        SOLVER.solve(ToyProblem.problem(kicks(10, 8), globals, ToyProblem.noPriors(3)));
    assertThat(s.boundsHit()).containsExactly("g0");
    assertThat(s.values()[0]).isEqualTo(1);
    assertThat(s.toString()).contains("on a bound: [g0]");
  }

  @Test
  void whatNothingDeterminesHasNoError() {
    List<ToyKick> twice = new ArrayList<>();
    for (ToyKick k : kicks(6, 9)) {
      twice.add(new ToyKick(k.y, k.a, new double[][] {k.b[0], k.b[0], k.b[2]}));
    }
    SharedSolution<double[]> s = solve(twice);
    // Beyond all bounds, or none at all; the third is known.
    s.covariance()
        .ifPresent(
            v -> {
              assertThat(Math.sqrt(v[0][0])).isGreaterThan(1e3);
              assertThat(Math.sqrt(v[2][2])).isLessThan(1);
            });
    ToyKick broken =
        new ToyKick(
            new double[] {1, Double.NaN, 2},
            new double[][] {{1, 1, 1}},
            new double[][] {{1, 2, 3}});
    SharedSolution<double[]> none =
        SOLVER.solve(ToyProblem.problem(List.of(broken), globals(1), ToyProblem.noPriors(1)));
    assertThat(none.stopReason()).isEqualTo(StopReason.SINGULAR);
    assertThat(none.covariance()).isEmpty();
    assertThat(none.toString()).contains("SINGULAR");
  }

  /** Two columns that have nothing in common leave rounding of either sign beside the diagonal. */
  @Test
  void roundingBesideTheDiagonalIsNoAsymmetry() {
    double[][] h = {{4, 1e-18}, {-2e-18, 25}};
    double[] scale = {1, 1};
    assertThat(ScaledEquations.solve(h, new double[] {8, 50}, scale, 0))
        .containsExactly(new double[] {2, 2}, within(1e-8));
    double[][] inverse = ScaledEquations.inverse(h, scale).orElseThrow();
    assertThat(inverse[0][0]).isEqualTo(0.25, within(1e-8));
    assertThat(inverse[1][1]).isEqualTo(0.04, within(1e-8));
  }

  @Test
  void wrongProblemsAreRefused() {
    assertThatThrownBy(() -> ToyProblem.problem(List.of(), globals(1), ToyProblem.noPriors(1)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("at least one kick");
    assertThatThrownBy(() -> ToyProblem.problem(kicks(2, 1), globals(3), ToyProblem.noPriors(2)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("3 global parameters, but 2 priors");
    assertThatThrownBy(() -> new RandomEffect(0, 1, 2, 3))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void theNumberOfThreadsChangesNothing() throws Exception {
    List<ToyKick> kicks = ToyProblem.kicks(30, TRUTH, 0.5, new SplittableRandom(10));
    String one = reportWith(1, kicks);
    assertThat(reportWith(4, kicks)).isEqualTo(one);
    assertThat(reportWith(2, kicks)).isEqualTo(one);
  }

  private static String reportWith(int threads, List<ToyKick> kicks) throws Exception {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      return pool.submit(
              () -> {
                SharedSolution<double[]> s =
                    SOLVER.settlingVariants().solve(ToyProblem.withRandom(kicks, globals(3)));
                return Arrays.toString(s.values()) + Arrays.toString(s.scatters()) + s.cost();
              })
          .get();
    } finally {
      pool.shutdown();
    }
  }

  /** 95 ± 3 % of the estimates within two standard errors, with and without what differs from kick to kick. */
  @Test
  void standardErrorsCover() {
    for (double scatter : new double[] {0, 0.8}) {
      int within = 0;
      int all = 0;
      for (long seed = 1; seed <= 300; seed++) {
        List<ToyKick> kicks =
            ToyProblem.kicks(20, TRUTH, scatter, new SplittableRandom(1000 + seed));
        SharedSolution<double[]> s =
            SharedSolver.withDefaults()
                .solve(
                    scatter > 0
                        ? ToyProblem.withRandom(kicks, globals(3))
                        : ToyProblem.problem(kicks, globals(3), ToyProblem.noPriors(3)));
        double[][] v = s.covariance().orElseThrow();
        for (int k = 0; k < 3; k++) {
          all++;
          within += Math.abs(s.values()[k] - TRUTH[k]) < 2 * Math.sqrt(v[k][k]) ? 1 : 0;
        }
      }
      assertThat(100.0 * within / all)
          .as("per cent within two standard errors, scatter %s", scatter)
          .isBetween(92.0, 98.0);
    }
  }
}
