package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * One kick within a joint fit: its own unknowns, and how its normal equations reduce to the shared ones.
 *
 * <p>The kick's own unknowns are eliminated (Schur complement), so that the joint system stays as small as the shared model,
 * however many kicks there are.
 */
final class JointKick {
  private final KickKind kind;
  private final int own;
  private final int size;
  private final int[] shared;
  private final double[] scale;
  private final List<Parameter> ownParameters;
  private final KickFit fit;
  private final FlightData data;
  private final int[] slot;
  private final int cameras;
  private final NormalEquations equations;
  private final double[] ownValues;
  private final double[] candidate;
  private final double[] point;
  private final double[][] factor;
  private final double[] ownStep;
  private FlightProblem problem;
  private int flights;

  /**
   * @param fit where the kick starts
   * @param shared index of each of the kick's other unknowns in the shared vector
   */
  JointKick(KickFit fit, FlightData data, int[] slot, int cameras, int[] shared) {
    kind = fit.kind();
    own = FlightLayout.kickSize(kind);
    this.data = data;
    this.slot = slot;
    this.cameras = cameras;
    this.shared = shared;
    size = own + shared.length;
    this.fit = fit;
    ownParameters = fit.estimates().subList(0, own).stream().map(Estimate::parameter).toList();
    scale = ownParameters.stream().mapToDouble(Parameter::scale).toArray();
    flights = fit.statistics().flights();
    equations = new NormalEquations(size);
    ownValues = Arrays.copyOf(fit.values(), own);
    candidate = ownValues.clone();
    point = new double[size];
    factor = new double[own][own];
    ownStep = new double[own];
    boolean[] used = new boolean[data.size];
    for (int i = 0; i < used.length; i++) {
      used[i] = fit.used(i);
    }
    problem = flightProblem(flights, used);
    tieTime();
  }

  private FlightProblem flightProblem(int flightCount, boolean[] used) {
    FlightCurve curve =
        kind == KickKind.FLAT ? new FlightCurve.Flat() : new FlightCurve.Chip(flightCount);
    FlightProblem flight = new FlightProblem(data, curve, FlightLayout.size(kind), slot, cameras);
    System.arraycopy(used, 0, flight.used(), 0, used.length);
    return flight;
  }

  private void tieTime() {
    if (!fit.kick().fromRest()) {
      problem.prior(FlightLayout.timeIndex(kind), fit.kick().time(), FlightFitter.TIME_PRIOR);
    }
  }

  KickKind kind() {
    return kind;
  }

  private double[] at(double[] ownPart, double[] sharedValues) {
    System.arraycopy(ownPart, 0, point, 0, own);
    for (int k = 0; k < shared.length; k++) {
      point[own + k] = sharedValues[shared[k]];
    }
    return point;
  }

  /** Adds this kick's reduced normal equations at the current point to the shared ones; returns its cost. */
  double reduce(double[] sharedValues, double lambda, double[][] a, double[] b) {
    problem.linearize(at(ownValues, sharedValues), equations);
    return reduceAgain(lambda, a, b);
  }

  /** The same with another damping, without evaluating anything anew. */
  double reduceAgain(double lambda, double[][] a, double[] b) {
    factorOwn(lambda);
    int n = shared.length;
    double[] column = new double[own];
    double[] rhs = new double[own];
    for (int i = 0; i < own; i++) {
      rhs[i] = equations.b[i] * scale[i];
    }
    NormalEquations.solveInPlace(factor, rhs);
    double[][] solved = new double[n][];
    for (int k = 0; k < n; k++) {
      for (int i = 0; i < own; i++) {
        column[i] = equations.a[own + k][i] * scale[i];
      }
      solved[k] = column.clone();
      NormalEquations.solveInPlace(factor, solved[k]);
    }
    for (int k = 0; k < n; k++) {
      double sum = equations.b[own + k];
      for (int i = 0; i < own; i++) {
        sum -= equations.a[own + k][i] * scale[i] * rhs[i];
      }
      b[shared[k]] += sum;
      for (int m = 0; m < n; m++) {
        double entry = k >= m ? equations.a[own + k][own + m] : equations.a[own + m][own + k];
        for (int i = 0; i < own; i++) {
          entry -= equations.a[own + k][i] * scale[i] * solved[m][i];
        }
        a[shared[k]][shared[m]] += entry;
      }
    }
    return equations.cost;
  }

  private void factorOwn(double lambda) {
    for (int i = 0; i < own; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = equations.a[i][j] * scale[i] * scale[j];
        if (i == j) {
          sum = sum * (1 + lambda) + 1e-12;
        }
        for (int k = 0; k < j; k++) {
          sum -= factor[i][k] * factor[j][k];
        }
        factor[i][j] = i == j ? Math.sqrt(Math.max(sum, 1e-12)) : sum / factor[j][j];
      }
    }
  }

  /** Cost after the shared unknowns moved by {@code step} and the kick's own ones followed. */
  double costAfter(double[] sharedCandidate, double[] step) {
    for (int i = 0; i < own; i++) {
      double sum = equations.b[i];
      for (int k = 0; k < shared.length; k++) {
        sum -= equations.a[own + k][i] * step[shared[k]];
      }
      ownStep[i] = sum * scale[i];
    }
    NormalEquations.solveInPlace(factor, ownStep);
    for (int i = 0; i < own; i++) {
      candidate[i] = ownParameters.get(i).clamp(ownValues[i] + ownStep[i] * scale[i]);
    }
    return problem.cost(at(candidate, sharedCandidate));
  }

  void accept() {
    System.arraycopy(candidate, 0, ownValues, 0, own);
  }

  /** Tries one flight more and one less with the shared unknowns held; true when that explains the kick better. */
  boolean tryFlights(double[] sharedValues) {
    if (kind == KickKind.FLAT) {
      return false;
    }
    double cost = problem.cost(at(ownValues, sharedValues));
    double best = FlightLayout.pricedCost(at(ownValues, sharedValues), flights, cost);
    FlightProblem kept = problem;
    double[] keptValues = ownValues.clone();
    int keptFlights = flights;
    boolean changed = false;
    for (int other : new int[] {keptFlights - 1, keptFlights + 1}) {
      if (other < 1 || other > ChipModel.MAX_FLIGHTS) {
        continue;
      }
      problem = flightProblem(other, kept.used());
      tieTime();
      double[] theta = at(keptValues, sharedValues).clone();
      double tried = new LevenbergMarquardt(alone(theta)).minimize(problem, theta);
      double priced = FlightLayout.pricedCost(theta, other, tried);
      int byRule =
          ChipTrajectory.flightsByRule(FlightLayout.chipModel(theta), theta[ChipTrajectory.VZ0]);
      if (Math.abs(byRule - other) <= 1 && priced < best - 1e-6 * best) {
        best = priced;
        changed = true;
        flights = other;
        System.arraycopy(theta, 0, ownValues, 0, own);
        kept = problem;
      }
    }
    problem = kept;
    return changed;
  }

  /** The kick's own unknowns as they are, everything shared held. */
  private List<Parameter> alone(double[] theta) {
    List<Parameter> all = new ArrayList<>(ownParameters);
    for (int k = own; k < size; k++) {
      all.add(
          new Parameter(
              "shared " + k, "", theta[k], 1, theta[k] - 1, theta[k] + 1, false, "the joint fit"));
    }
    return all;
  }

  /** Leaves outliers out anew. */
  void leaveOutliersOut(double[] sharedValues, double outlierDistance) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    problem.residuals(at(ownValues, sharedValues), rx, ry);
    Screening screening = Screening.of(data, rx, ry, outlierDistance);
    for (int i = 0; i < data.size; i++) {
      problem.used()[i] = screening.kept(i);
    }
  }

  /** Adds the squared residuals per axis to {@code sums[0]} and their number to {@code sums[1]}. */
  void residuals(double[] sharedValues, double[] sums) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    problem.residuals(at(ownValues, sharedValues), rx, ry);
    for (int i = 0; i < data.size; i++) {
      if (problem.used()[i]) {
        sums[0] += rx[i] * rx[i] + ry[i] * ry[i];
        sums[1] += 2;
      }
    }
  }

  int observations() {
    return data.size;
  }

  int own() {
    return own;
  }
}
