package fieldcal.fit;

import fieldcal.ball.Parameter;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Residuals of a path against the observations of one kick, as least squares with a robust loss.
 *
 * <p>A ball at (x, y, z) is reported at {@code g = c + (p − c)·H/(H − z)} by a camera at c, H above the plane of resting balls.
 * The loss is Cauchy's, {@code ρ(s) = k² ln(1 + s/k²)} of the squared whitened distance: it keeps 95 % of the efficiency of plain
 * least squares and hardly feels a detection that is metres away. With {@code k} infinite it is plain least squares.
 */
final class FlightProblem {
  private final FlightData data;
  private final FlightCurve curve;
  private final int size;
  private final boolean[] used;
  private double lossScale = Double.POSITIVE_INFINITY;

  /** The unknowns whose columns are asked for. */
  private int[] columns;

  private final double[] priorValue;
  private final double[] priorWeight;
  private final double[] xyz = new double[3];
  private final double[] dx;
  private final double[] dy;
  private final double[] dz;
  private final double[] j1;
  private final double[] j2;
  private final CauchyLoss loss = new CauchyLoss();
  private int evaluations;

  FlightProblem(FlightData data, FlightCurve curve, int size) {
    this.data = data;
    this.curve = curve;
    this.size = size;
    used = new boolean[data.size];
    Arrays.fill(used, true);
    columns = IntStream.range(0, size).toArray();
    priorValue = new double[size];
    priorWeight = new double[size];
    dx = new double[size];
    dy = new double[size];
    dz = new double[size];
    j1 = new double[size];
    j2 = new double[size];
  }

  FlightData data() {
    return data;
  }

  int size() {
    return size;
  }

  int evaluations() {
    return evaluations;
  }

  boolean[] used() {
    return used;
  }

  /** Leaves the columns of parameters that are held out of the normal equations: what nobody solves for, nobody needs to sum up. */
  void holdFixed(List<Parameter> parameters) {
    columns = Arrays.stream(columns).filter(k -> parameters.get(k).estimated()).toArray();
  }

  /** Cauchy's loss with this scale, in standard deviations; infinite for plain least squares. */
  void lossScale(double scale) {
    lossScale = scale;
  }

  /** One unknown is known beforehand to this precision. */
  void prior(int index, double value, double standardDeviation) {
    priorValue[index] = value;
    priorWeight[index] = 1 / (standardDeviation * standardDeviation);
  }

  double cost(double[] theta) {
    evaluations++;
    curve.set(theta);
    loss.reset(lossScale);
    for (int i = 0; i < data.size; i++) {
      if (used[i]) {
        loss.add(squaredDistance(i));
      }
    }
    return loss.sum() + priorCost(theta);
  }

  private double priorCost(double[] theta) {
    double cost = 0;
    for (int k = 0; k < size; k++) {
      double d = theta[k] - priorValue[k];
      cost += d * d * priorWeight[k];
    }
    return cost;
  }

  private double squaredDistance(int i) {
    curve.position(data.time[i], xyz);
    double rx = data.residualX(i, xyz);
    double ry = data.residualY(i, xyz);
    double r1 = data.w11[i] * rx;
    double r2 = data.w21[i] * rx + data.w22[i] * ry;
    return r1 * r1 + r2 * r2;
  }

  /** Seen minus predicted position in the ground plane, m. */
  void residuals(double[] theta, double[] rx, double[] ry) {
    curve.set(theta);
    for (int i = 0; i < data.size; i++) {
      curve.position(data.time[i], xyz);
      rx[i] = data.residualX(i, xyz);
      ry[i] = data.residualY(i, xyz);
    }
  }

  /** Fills in the normal equations at {@code theta}. */
  void linearize(double[] theta, NormalEquations to) {
    evaluations++;
    to.clear();
    curve.set(theta);
    loss.reset(lossScale);
    for (int i = 0; i < data.size; i++) {
      if (!used[i]) {
        continue;
      }
      curve.sensitivities(data.time[i], xyz, dx, dy, dz);
      double h = data.cameraHeight[i];
      double f = h / (h - xyz[2]);
      double px = xyz[0] - data.cameraX[i];
      double py = xyz[1] - data.cameraY[i];
      double rx = data.residualX(i, xyz);
      double ry = data.residualY(i, xyz);
      double r1 = data.w11[i] * rx;
      double r2 = data.w21[i] * rx + data.w22[i] * ry;
      double s = r1 * r1 + r2 * r2;
      double weight = loss.add(s);
      double fz = f * f / h;
      for (int k : columns) {
        double gx = f * dx[k] + px * fz * dz[k];
        double gy = f * dy[k] + py * fz * dz[k];
        j1[k] = data.w11[i] * gx;
        j2[k] = data.w21[i] * gx + data.w22[i] * gy;
      }
      accumulate(to, weight, r1, r2);
    }
    to.cost = loss.sum() + priorCost(theta);
    for (int k = 0; k < size; k++) {
      to.a[k][k] += priorWeight[k];
      to.b[k] += priorWeight[k] * (priorValue[k] - theta[k]);
    }
  }

  private void accumulate(NormalEquations to, double weight, double r1, double r2) {
    for (int i = 0; i < columns.length; i++) {
      int k = columns[i];
      double a1 = weight * j1[k];
      double a2 = weight * j2[k];
      if (a1 == 0 && a2 == 0) {
        continue;
      }
      to.b[k] += a1 * r1 + a2 * r2;
      double[] row = to.a[k];
      for (int j = 0; j <= i; j++) {
        int m = columns[j];
        row[m] += a1 * j1[m] + a2 * j2[m];
      }
    }
  }
}
