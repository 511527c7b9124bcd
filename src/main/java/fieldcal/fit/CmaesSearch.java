package fieldcal.fit;

import fieldcal.ball.Parameter;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.exception.TooManyEvaluationsException;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.SimpleBounds;
import org.apache.commons.math3.optim.SimpleValueChecker;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.apache.commons.math3.random.MersenneTwister;

/**
 * Global search for the neighbourhood of the right minimum with Commons Math's CMA-ES (Hansen: evolution strategy with covariance matrix adaptation).
 *
 * <p>It walks in unknowns divided by their scales, within bounds; what is held is left out. The best point ever seen is kept, also
 * when the evaluations run out, which for this purpose is the normal end.
 */
final class CmaesSearch {
  private final FlightProblem problem;
  private final double[] origin;
  private final double[] scale;
  private final int[] index;
  private final double[] lower;
  private final double[] upper;
  private final double[] sigma;
  private final double[] point;
  private final double[] best;
  private double bestCost;

  /** The unknowns are searched around {@code start} with steps of {@code spread} times their scale. */
  CmaesSearch(FlightProblem problem, List<Parameter> parameters, double[] start, double spread) {
    this.problem = problem;
    origin = start.clone();
    point = start.clone();
    best = start.clone();
    bestCost = problem.cost(start);
    int[] free = new int[parameters.size()];
    int n = 0;
    for (int i = 0; i < free.length; i++) {
      if (parameters.get(i).estimated()) {
        free[n++] = i;
      }
    }
    index = Arrays.copyOf(free, n);
    scale = new double[n];
    lower = new double[n];
    upper = new double[n];
    sigma = new double[n];
    for (int k = 0; k < n; k++) {
      Parameter p = parameters.get(index[k]);
      scale[k] = p.scale();
      lower[k] = (p.min() - origin[index[k]]) / scale[k];
      upper[k] = (p.max() - origin[index[k]]) / scale[k];
      // A start sigma beyond the bounds is refused by the optimizer.
      sigma[k] = Math.min(spread, 0.3 * (upper[k] - lower[k]));
    }
  }

  /** Searches; the best point found, never worse than the start. */
  double[] search(int evaluations, long seed) {
    int dimension = index.length;
    int population = 4 + (int) (3 * Math.log(dimension));
    CMAESOptimizer optimizer =
        new CMAESOptimizer(
            10_000,
            0,
            true,
            0,
            0,
            new MersenneTwister(seed),
            false,
            new SimpleValueChecker(1e-3, 1e-3));
    try {
      optimizer.optimize(
          new MaxEval(evaluations),
          new ObjectiveFunction(this::evaluate),
          GoalType.MINIMIZE,
          new CMAESOptimizer.PopulationSize(population),
          new CMAESOptimizer.Sigma(sigma),
          new InitialGuess(new double[dimension]),
          new SimpleBounds(lower, upper));
    } catch (TooManyEvaluationsException spent) {
      // The budget is the stopping rule; the best point is kept below.
    }
    return best;
  }

  private double evaluate(double[] u) {
    for (int k = 0; k < u.length; k++) {
      point[index[k]] = origin[index[k]] + u[k] * scale[k];
    }
    double cost = problem.cost(point);
    if (cost < bestCost) {
      bestCost = cost;
      System.arraycopy(point, 0, best, 0, point.length);
    }
    return cost;
  }
}
