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

  /** Lower triangle and right side of the normal equations, of the columns alone. */
  private double[][] sums;

  private double[] rightSide;

  private final double[] priorValue;
  private final double[] priorWeight;
  private final double[] xyz = new double[3];
  private final double[] dx;
  private final double[] dy;
  private final double[] dz;

  /** Derivatives of the whitened prediction of one observation by the columns. */
  private double[] j1;

  private double[] j2;
  private final CauchyLoss loss = new CauchyLoss();
  private int evaluations;

  FlightProblem(FlightData data, FlightCurve curve, int size) {
    this.data = data;
    this.curve = curve;
    this.size = size;
    used = new boolean[data.size];
    Arrays.fill(used, true);
    choose(IntStream.range(0, size).toArray());
    priorValue = new double[size];
    priorWeight = new double[size];
    dx = new double[size];
    dy = new double[size];
    dz = new double[size];
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
    choose(Arrays.stream(columns).filter(k -> parameters.get(k).estimated()).toArray());
  }

  private void choose(int[] chosen) {
    columns = chosen;
    sums = new double[chosen.length][];
    for (int c = 0; c < chosen.length; c++) {
      sums[c] = new double[c + 1];
    }
    rightSide = new double[chosen.length];
    j1 = new double[chosen.length];
    j2 = new double[chosen.length];
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
    double stretch = data.stretch(i, xyz[2]);
    double rx = data.residualX(i, xyz, stretch);
    double ry = data.residualY(i, xyz, stretch);
    double r1 = data.w11[i] * rx;
    double r2 = data.w21[i] * rx + data.w22[i] * ry;
    return r1 * r1 + r2 * r2;
  }

  /** Seen minus predicted position in the ground plane, m. */
  void residuals(double[] theta, double[] rx, double[] ry) {
    curve.set(theta);
    for (int i = 0; i < data.size; i++) {
      curve.position(data.time[i], xyz);
      double stretch = data.stretch(i, xyz[2]);
      rx[i] = data.residualX(i, xyz, stretch);
      ry[i] = data.residualY(i, xyz, stretch);
    }
  }

  /** Fills in the normal equations at {@code theta}. */
  void linearize(double[] theta, NormalEquations to) {
    evaluations++;
    for (double[] row : sums) {
      Arrays.fill(row, 0);
    }
    Arrays.fill(rightSide, 0);
    curve.set(theta);
    loss.reset(lossScale);
    for (int i = 0; i < data.size; i++) {
      if (!used[i]) {
        continue;
      }
      curve.sensitivities(data.time[i], xyz, dx, dy, dz);
      double f = data.stretch(i, xyz[2]);
      double px = xyz[0] - data.cameraX[i];
      double py = xyz[1] - data.cameraY[i];
      double rx = data.residualX(i, xyz, f);
      double ry = data.residualY(i, xyz, f);
      double w11 = data.w11[i];
      double w21 = data.w21[i];
      double w22 = data.w22[i];
      double r1 = w11 * rx;
      double r2 = w21 * rx + w22 * ry;
      double weight = loss.add(r1 * r1 + r2 * r2);
      double fz = f * f / data.cameraHeight[i];
      double fzx = px * fz;
      double fzy = py * fz;
      for (int c = 0; c < columns.length; c++) {
        int k = columns[c];
        double gx = f * dx[k] + fzx * dz[k];
        double gy = f * dy[k] + fzy * dz[k];
        j1[c] = w11 * gx;
        j2[c] = w21 * gx + w22 * gy;
      }
      accumulate(weight, r1, r2);
    }
    to.clear();
    for (int c = 0; c < columns.length; c++) {
      int k = columns[c];
      to.b[k] = rightSide[c];
      for (int d = 0; d <= c; d++) {
        to.a[k][columns[d]] = sums[c][d];
      }
    }
    to.cost = loss.sum() + priorCost(theta);
    for (int k = 0; k < size; k++) {
      to.a[k][k] += priorWeight[k];
      to.b[k] += priorWeight[k] * (priorValue[k] - theta[k]);
    }
  }

  /** The inner loop of all fits: over arrays without gaps, whose bounds the machine checks once. */
  private void accumulate(double weight, double r1, double r2) {
    double[] d1 = j1;
    double[] d2 = j2;
    for (int c = 0; c < d1.length; c++) {
      double a1 = weight * d1[c];
      double a2 = weight * d2[c];
      if (a1 == 0 && a2 == 0) {
        continue;
      }
      rightSide[c] += a1 * r1 + a2 * r2;
      double[] row = sums[c];
      for (int d = 0; d < row.length; d++) {
        row[d] += a1 * d1[d] + a2 * d2[d];
      }
    }
  }
}
