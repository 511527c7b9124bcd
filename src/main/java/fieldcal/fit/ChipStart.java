package fieldcal.fit;

import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.Gravity;
import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.Arrays;
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
 * linear in p0, v and vz. It does not depend on initial values from a wrong model, and the search that follows begins near the right minimum.
 */
final class ChipStart {
  private static final double[] DAMPING_Z = {0.3, 0.38, 0.46, 0.54, 0.62, 0.7, 0.78};
  private static final double[] DAMPING_XY = {0.55, 0.7, 0.85, 1.0};

  /** From the lowest that is a chip to what 6.5 m/s upwards at 60 degrees gives, m/s. */
  private static final double[] VERTICAL_SPEED = {0.8, 1.2, 1.7, 2.2, 2.8, 3.4, 4.1, 4.9, 5.7};

  private ChipStart() {}

  /**
   * Starts worth trying: the linear solution for the first flight, and, where the camera is almost above the ball and the height
   * hardly shows, the best horizontal motion for each of a range of vertical speeds.
   *
   * @param time when the kick was, s
   * @return position, velocity (3) and time of the kick, each
   */
  static List<double[]> firstFlights(FlightData data, double time, double lossScale) {
    List<double[]> starts = new ArrayList<>();
    double[] free = firstFlight(data, time, lossScale);
    if (free != null) {
      starts.add(free);
    }
    for (double vz : VERTICAL_SPEED) {
      double[] given =
          solve(data, time, time + 2 * vz / Gravity.ACCELERATION - 0.01, null, lossScale, vz);
      if (given != null) {
        starts.add(given);
      }
    }
    return starts;
  }

  private static double[] firstFlight(FlightData data, double time, double lossScale) {
    double until = time + 0.25;
    double[] solution = null;
    for (int round = 0; round < 4; round++) {
      double[] next = solve(data, time, until, solution, lossScale, Double.NaN);
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

  /** The linear system for the observations until a time; the vertical speed is an unknown, too, when {@code givenVz} is NaN. */
  private static double[] solve(
      FlightData d,
      double t0,
      double until,
      double[] weightsFrom,
      double lossScale,
      double givenVz) {
    int n = 0;
    for (int i = 0; i < d.size; i++) {
      n += d.time[i] <= until ? 1 : 0;
    }
    if (n < 6) {
      return null;
    }
    boolean known = !Double.isNaN(givenVz);
    int unknowns = known ? 4 : 5;
    Array2DRowRealMatrix a = new Array2DRowRealMatrix(2 * n, unknowns);
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
        if (known) {
          b.setEntry(row, w * (o * (fall - givenVz * t) + h * c));
        } else {
          a.setEntry(row, 4, w * o * t);
          b.setEntry(row, w * (o * fall + h * c));
        }
        row++;
      }
    }
    try {
      RealVector x = new QRDecomposition(a, 1e-10).getSolver().solve(b);
      return new double[] {
        x.getEntry(0),
        x.getEntry(1),
        x.getEntry(2),
        x.getEntry(3),
        known ? givenVz : x.getEntry(4),
        t0
      };
    } catch (SingularMatrixException parallel) {
      return null;
    }
  }

  /** The best dampings of a grid, within their bounds, for the kick in {@code theta}; changed in place. Returns the cost. */
  static double dampings(FlightProblem problem, List<Parameter> parameters, double[] theta) {
    double best = Double.POSITIVE_INFINITY;
    double[] trial = theta.clone();
    for (double z : grid(parameters, ChipTrajectory.DAMPING_Z, DAMPING_Z)) {
      for (double first : grid(parameters, ChipTrajectory.DAMPING_XY_FIRST_HOP, DAMPING_XY)) {
        for (double other : grid(parameters, ChipTrajectory.DAMPING_XY_OTHER_HOPS, DAMPING_XY)) {
          trial[ChipTrajectory.DAMPING_Z] = z;
          trial[ChipTrajectory.DAMPING_XY_FIRST_HOP] = first;
          trial[ChipTrajectory.DAMPING_XY_OTHER_HOPS] = other;
          double cost = problem.costBelow(best, trial);
          if (cost < best) {
            best = cost;
            System.arraycopy(trial, 0, theta, 0, theta.length);
          }
        }
      }
    }
    return best;
  }

  /** The values of a parameter that are tried: those of a grid within its bounds, or the one that it is held at. */
  private static double[] grid(List<Parameter> parameters, int index, double[] values) {
    Parameter p = parameters.get(index);
    return p.estimated()
        ? Arrays.stream(values).map(p::clamp).distinct().toArray()
        : new double[] {p.value()};
  }
}
