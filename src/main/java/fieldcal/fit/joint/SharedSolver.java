package fieldcal.fit.joint;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Levenberg–Marquardt on the normal equations from which each kick's own parameters are eliminated (Schur complement; Triggs et al. 2000, "Bundle adjustment").
 *
 * <p>Derivatives by global parameters are differences of states, which are made once for all kicks. Scatters of random effects are updated between runs (EM); discrete unknowns of the kicks are settled with the shared
 * parameters held. Kicks are worked on in parallel with the same result as one by one. Immutable and thread-safe.
 */
public final class SharedSolver {
  /** Most steps, accepted or not, where nothing else is asked for. */
  static final int MAX_ITERATIONS = 40;

  /** Rounds in which scatters are updated and everything else follows, for a tolerance of a hundredth; the equations of one round are nearly those of the next. */
  private static final int SCATTER_ROUNDS = 12;

  /** Such rounds for a coarse solution. */
  private static final int FEW_SCATTER_ROUNDS = 3;

  /** From that tolerance on a solution is coarse: half a unit of chi-square moves no estimate by more than its error. */
  static final double COARSE = 0.5;

  /** A scatter that changes by less than that share is settled: its own error is 1/√(2n), a tenth for fifty kicks. */
  private static final double SCATTER_SETTLED = 0.02;

  /** Steps of EM on the same equations: they shrink the distance to the best scatter by half or more where the kicks determine their values. */
  private static final int EXPECTATIONS = 30;

  /** Such a step that changes a scatter by less than that share is the last: a quarter of what settles it. */
  private static final double EXPECTATION_SETTLED = 0.005;

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
    return new SharedSolver(MAX_ITERATIONS, 0.01, false, false);
  }

  /**
   * The same with another limit of steps.
   *
   * @param iterations most steps, accepted or not, at least 1
   * @return the changed copy
   */
  public SharedSolver withMaxIterations(int iterations) {
    return new SharedSolver(iterations, tolerance, settlesVariants, startsByRule);
  }

  /**
   * The same with a limit of steps, unless it has a lower one.
   *
   * @param iterations most steps, accepted or not, at least 1
   * @return the changed copy
   */
  public SharedSolver withAtMost(int iterations) {
    return withMaxIterations(Math.min(iterations, maxIterations));
  }

  /**
   * The same with another end.
   *
   * @param gain of chi-square, in units of the reduced one (–), below which a step is the last; positive, 0.01 by default
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
   * Solves. The same problem gives the same solution, bit by bit.
   *
   * @param problem to be solved, with the values to start from
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
    return new OwnFitter<>(maxIterations, tolerance, state, means, scatters).fit(term, start);
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

  /** One solution; used once. */
  private final class Run<S> {
    private final SharedProblem<S> problem;
    private final Descent<S> descent;

    Run(SharedProblem<S> problem) {
      this.problem = problem;
      descent = new Descent<>(problem, maxIterations, tolerance);
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
        descent.descend();
      }
      if (settlesVariants) {
        obeyRule();
      }
      if (tolerance < COARSE && descent.scatters().length > 0) {
        descent.correct();
        descendWithScatters();
      }
      return descent.solution();
    }

    private void descendWithScatters() {
      if (descent.scatters().length == 0) {
        descent.descend();
        return;
      }
      descent.approach();
      int rounds = tolerance < COARSE ? SCATTER_ROUNDS : FEW_SCATTER_ROUNDS;
      for (int round = 0; round < rounds && updateScatters(); round++) {
        descent.approach();
      }
      descent.descend();
    }

    private OwnFitter<S> ownFitter() {
      return new OwnFitter<>(
          maxIterations, tolerance, descent.state(), descent.means(), descent.scatters());
    }

    /**
     * Gives all discrete unknowns at once the values that their rule says, and keeps that if it explains more. Where the shared model is wrong or was, a bounce too many makes up for it in every kick; then no kick can be brought back alone, since the
     * others hold the shared parameters where theirs need them.
     */
    private void obeyRule() {
      Descent.Mark<S> before = descent.mark();
      double least = pricedCost();
      if (!setByRule()) {
        return;
      }
      descent.undamp();
      if (descent.mayFallBelow(least)) {
        descent.descend();
        if (OwnFitter.isLess(pricedCost(), least)) {
          return;
        }
      }
      descent.backTo(before);
    }

    /** The values of the discrete unknowns by their rule, and what the own parameters are then; says whether that changes anything. */
    private boolean setByRule() {
      S state = descent.state();
      OwnFitter<S> fitter = ownFitter();
      List<Optional<OwnFit<S>>> fits =
          descent.eachKick(
              k -> {
                KickTerm<S> now = descent.kicks().get(k);
                KickTerm<S> expected = now.byRule(descent.own().get(k), state);
                return expected == now
                    ? Optional.empty()
                    : Optional.of(fitter.fit(expected, descent.own().get(k)));
              });
      for (int k = 0; k < fits.size(); k++) {
        int kick = k;
        fits.get(k).ifPresent(f -> descent.put(kick, f.term(), f.own()));
      }
      return fits.stream().anyMatch(Optional::isPresent);
    }

    /** The cost as last seen, with what the values of the discrete unknowns add. */
    private double pricedCost() {
      S state = descent.state();
      double sum = descent.cost();
      for (int k = 0; k < descent.kicks().size(); k++) {
        double penalty = descent.kicks().get(k).penalty(descent.own().get(k), state);
        sum += problem.weights()[k] * penalty;
      }
      return sum;
    }

    /** Gives each kick the value of its discrete unknown that explains it best beside the others; says whether that changes anything. */
    private boolean settle() {
      List<KickTerm<S>> kicks = descent.kicks();
      double[] reduced = new double[kicks.size()];
      for (int k = 0; k < reduced.length; k++) {
        double weighted = descent.blocks()[k].chiSquare;
        reduced[k] = weighted / (problem.weights()[k] * Math.max(1, kicks.get(k).rows()));
      }
      double[] sorted = reduced.clone();
      Arrays.sort(sorted);
      double limit = STUCK * Math.max(1, sorted[sorted.length / 2]);
      boolean[] stuck = new boolean[reduced.length];
      for (int k = 0; k < stuck.length; k++) {
        // Also where nothing can be predicted.
        stuck[k] = !(reduced[k] <= limit);
      }
      OwnFitter<S> fitter = ownFitter();
      List<Optional<OwnFit<S>>> fits =
          descent.eachKick(
              k ->
                  kicks.get(k).neighbours().isEmpty()
                      ? Optional.empty()
                      : Optional.of(
                          fitter.bestVariant(kicks.get(k), descent.own().get(k), stuck[k])));
      boolean changed = false;
      for (int k = 0; k < fits.size(); k++) {
        OwnFit<S> fit = fits.get(k).orElse(null);
        if (fit != null && (fit.term() != kicks.get(k) || stuck[k])) {
          boolean better =
              fit.term() != kicks.get(k)
                  || !(fit.chiSquare() >= IMPROVED * reduced[k] * fit.term().rows());
          if (better) {
            descent.put(k, fit.term(), fit.own());
          }
          changed |= better;
        }
      }
      return changed;
    }

    /** Takes the scatters to where the equations of this point put them; false when they were there already. */
    private boolean updateScatters() {
      if (!Double.isFinite(descent.cost())) {
        return false;
      }
      double[] scatters = descent.scatters();
      double[] before = scatters.clone();
      boolean moves = true;
      for (int round = 0; round < EXPECTATIONS && moves; round++) {
        double[] updated = expectedScatters();
        moves = differ(updated, scatters, EXPECTATION_SETTLED);
        System.arraycopy(updated, 0, scatters, 0, updated.length);
      }
      return differ(scatters, before, SCATTER_SETTLED);
    }

    private static boolean differ(double[] scatters, double[] before, double share) {
      return IntStream.range(0, scatters.length)
          .anyMatch(r -> Math.abs(scatters[r] - before[r]) > share * before[r]);
    }

    /** One step of EM (Dempster, Laird and Rubin 1977): the root mean square of the kicks' values about their mean, with what is not known of them. */
    private double[] expectedScatters() {
      double[] scatters = descent.scatters();
      Descent.Foreseen there = descent.foreseen();
      double[] updated = new double[scatters.length];
      for (int r = 0; r < scatters.length; r++) {
        double meanVariance = descent.meanVariance(r);
        double sum = 0;
        for (int k = 0; k < descent.kicks().size(); k++) {
          double[] own = there.own().get(k);
          int i = own.length - scatters.length + r;
          double d = own[i] - there.means()[r];
          double left = descent.blocks()[k].ownVariance(i);
          // A value that the kick itself determines does not follow the mean when that errs.
          double stays = 1 - left / (scatters[r] * scatters[r]);
          sum += d * d + left + stays * stays * meanVariance;
        }
        RandomEffect random = problem.randoms().get(r);
        double next = Math.sqrt(sum / descent.kicks().size());
        updated[r] = Math.max(random.smallest(), Math.min(random.largest(), next));
      }
      return updated;
    }
  }
}
