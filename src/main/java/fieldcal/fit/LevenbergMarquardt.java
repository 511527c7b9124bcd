package fieldcal.fit;

import fieldcal.ball.Parameter;
import java.util.List;

/**
 * Levenberg–Marquardt within bounds, on normal equations (Levenberg 1944, Marquardt 1963; the damping rule is Nielsen's of 1999).
 *
 * <p>An unknown that sits on a bound and would leave it is held there for the step. Needs the problem's derivatives to be exact.
 */
final class LevenbergMarquardt {
  private static final int MAX_ITERATIONS = 60;

  /**
   * A step that decreases the cost by a smaller part is the last. With a thousand residuals a step that gains less moves no unknown
   * by a hundredth of its error, and the next one would move it far less.
   */
  private static final double TOLERANCE = 1e-7;

  /** The same on the way to another cost function. */
  private static final double ROUGH_TOLERANCE = 1e-5;

  /** Why an optimisation stopped. */
  enum Stop {
    CONVERGED,
    NO_DESCENT,
    ITERATIONS
  }

  private final int size;
  private final double[] scale;
  private final double[] min;
  private final double[] max;
  private final boolean[] estimated;
  private final boolean[] free;
  private final double[][] l;
  private final double[] step;
  private final double[] candidate;
  private final NormalEquations equations;
  private double tolerance = TOLERANCE;
  private Stop stop = Stop.ITERATIONS;
  private int iterations;

  LevenbergMarquardt(List<Parameter> parameters) {
    size = parameters.size();
    scale = parameters.stream().mapToDouble(Parameter::scale).toArray();
    min = parameters.stream().mapToDouble(Parameter::min).toArray();
    max = parameters.stream().mapToDouble(Parameter::max).toArray();
    estimated = new boolean[size];
    for (int i = 0; i < size; i++) {
      estimated[i] = parameters.get(i).estimated();
    }
    free = new boolean[size];
    l = new double[size][size];
    step = new double[size];
    candidate = new double[size];
    equations = new NormalEquations(size);
  }

  /** Stops early, for a cost that is only a step towards another one. */
  LevenbergMarquardt roughly() {
    tolerance = ROUGH_TOLERANCE;
    return this;
  }

  Stop stop() {
    return stop;
  }

  int iterations() {
    return iterations;
  }

  /** Normal equations at the last accepted point. */
  NormalEquations equations() {
    return equations;
  }

  double[] scale() {
    return scale;
  }

  /** Improves {@code theta} in place; returns the cost there. */
  double minimize(FlightProblem problem, double[] theta) {
    problem.linearize(theta, equations);
    double cost = equations.cost;
    double lambda = 1e-4;
    double growth = 2;
    stop = Stop.ITERATIONS;
    for (iterations = 0; iterations < MAX_ITERATIONS; iterations++) {
      chooseFree(theta);
      if (!equations.factor(lambda, scale, free, l)) {
        lambda = Math.max(10 * lambda, 1e-9);
        if (lambda > 1e12) {
          stop = Stop.NO_DESCENT;
          break;
        }
        continue;
      }
      equations.solve(l, scale, free, step);
      double predicted = advance(theta, lambda);
      if (predicted < tolerance * cost) {
        stop = Stop.CONVERGED;
        break;
      }
      double next = problem.cost(candidate);
      double gain = cost - next;
      if (gain > 0) {
        System.arraycopy(candidate, 0, theta, 0, size);
        double rho = gain / Math.max(predicted, 1e-300);
        lambda *= Math.max(1.0 / 3, 1 - Math.pow(2 * Math.min(rho, 1.5) - 1, 3));
        growth = 2;
        problem.linearize(theta, equations);
        cost = equations.cost;
        if (gain < tolerance * (cost + 1e-9)) {
          stop = Stop.CONVERGED;
          break;
        }
      } else {
        if (Math.abs(gain) <= 1e-12 * cost) {
          stop = Stop.CONVERGED;
          break;
        }
        lambda *= growth;
        growth *= 2;
        if (lambda > 1e12) {
          stop = Stop.NO_DESCENT;
          break;
        }
      }
    }
    return cost;
  }

  private void chooseFree(double[] theta) {
    for (int i = 0; i < size; i++) {
      boolean atMin = theta[i] <= min[i] && equations.b[i] < 0;
      boolean atMax = theta[i] >= max[i] && equations.b[i] > 0;
      free[i] = estimated[i] && !atMin && !atMax && equations.a[i][i] > 0;
    }
  }

  /** Puts theta + step, kept within bounds, into candidate; returns the decrease of cost that the linear model promises. */
  private double advance(double[] theta, double lambda) {
    double predicted = 0;
    for (int i = 0; i < size; i++) {
      candidate[i] = Math.max(min[i], Math.min(max[i], theta[i] + step[i]));
      predicted += step[i] * (lambda * equations.a[i][i] * step[i] + equations.b[i]);
    }
    return predicted;
  }
}
