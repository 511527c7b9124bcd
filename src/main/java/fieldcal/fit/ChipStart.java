package fieldcal.fit;

import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.Gravity;
import fieldcal.ball.Parameter;
import java.util.List;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularMatrixException;

/**
 * A start for the chip fit, hop by hop: the first flight from a linear system, then the dampings from a coarse grid.
 *
 * <p>A ball at {@code p = p0 + v·t}, {@code z = vz·t − g·t²/2} is reported at o with {@code (o − c)(H − z) = (p − c)·H}, which is
 * linear in p0, v and vz. No start from a wrong model can spoil it, and the search that follows begins in the right valley.
 */
final class ChipStart {
  private static final double[] DAMPING_Z = {0.3, 0.38, 0.46, 0.54, 0.62, 0.7, 0.78};
  private static final double[] DAMPING_XY = {0.55, 0.7, 0.85, 1.0};

  private ChipStart() {}

  /**
   * Position, velocity (3) and time of the kick; null when the observations do not look like a flight.
   *
   * @param time when the kick was, s
   */
  static double[] firstFlight(FlightData data, double time, double lossScale) {
    double until = time + 0.25;
    double[] solution = null;
    for (int round = 0; round < 4; round++) {
      double[] next = solve(data, time, until, solution, lossScale);
      if (next == null || next[4] < 0.2) {
        return solution;
      }
      solution = next;
      double landing = time + 2 * next[4] / Gravity.ACCELERATION;
      until = Math.min(landing - 0.01, Math.max(until, landing) + 0.3);
      if (until < time + 0.08) {
        return solution;
      }
    }
    return solution;
  }

  private static double[] solve(
      FlightData d, double t0, double until, double[] weightsFrom, double lossScale) {
    int n = 0;
    for (int i = 0; i < d.size; i++) {
      n += d.time[i] <= until ? 1 : 0;
    }
    if (n < 6) {
      return null;
    }
    Array2DRowRealMatrix a = new Array2DRowRealMatrix(2 * n, 5);
    ArrayRealVector b = new ArrayRealVector(2 * n);
    int row = 0;
    for (int i = 0; i < d.size; i++) {
      if (d.time[i] > until) {
        continue;
      }
      double t = Math.max(0, d.time[i] - t0);
      double h = d.cameraHeight[i];
      double fall = h + 0.5 * Gravity.ACCELERATION * t * t;
      for (int axis = 0; axis < 2; axis++) {
        double c = axis == 0 ? d.cameraX[i] : d.cameraY[i];
        double o = (axis == 0 ? d.x[i] : d.y[i]) - c;
        // Divided by H, so that a residual is about one in the ground plane.
        double w = (axis == 0 ? d.w11[i] : d.w22[i]) / h;
        if (weightsFrom != null) {
          double r =
              w
                  * (o * (fall - weightsFrom[4] * t)
                      - h * (weightsFrom[axis] + weightsFrom[2 + axis] * t - c));
          w /= Math.sqrt(1 + r * r / (lossScale * lossScale));
        }
        a.setEntry(row, axis, w * h);
        a.setEntry(row, 2 + axis, w * h * t);
        a.setEntry(row, 4, w * o * t);
        b.setEntry(row, w * (o * fall + h * c));
        row++;
      }
    }
    try {
      RealVector x = new QRDecomposition(a, 1e-10).getSolver().solve(b);
      return new double[] {
        x.getEntry(0), x.getEntry(1), x.getEntry(2), x.getEntry(3), x.getEntry(4), t0
      };
    } catch (SingularMatrixException parallel) {
      return null;
    }
  }

  /** The best dampings of a grid, within their bounds, for the kick in {@code theta}; changed in place. */
  static void dampings(FlightProblem problem, List<Parameter> parameters, double[] theta) {
    double best = Double.POSITIVE_INFINITY;
    double[] trial = theta.clone();
    for (double z : DAMPING_Z) {
      for (double first : DAMPING_XY) {
        for (double other : DAMPING_XY) {
          put(parameters, trial, ChipTrajectory.DAMPING_Z, z);
          put(parameters, trial, ChipTrajectory.DAMPING_XY_FIRST_HOP, first);
          put(parameters, trial, ChipTrajectory.DAMPING_XY_OTHER_HOPS, other);
          double cost = problem.cost(trial);
          if (cost < best) {
            best = cost;
            System.arraycopy(trial, 0, theta, 0, theta.length);
          }
        }
      }
    }
  }

  private static void put(List<Parameter> parameters, double[] theta, int index, double value) {
    Parameter p = parameters.get(index);
    theta[index] = p.estimated() ? p.clamp(value) : p.value();
  }
}
