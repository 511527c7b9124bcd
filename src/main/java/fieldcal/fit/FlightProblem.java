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
  /** Number of observations that are summed up at a time: a sum is loaded and stored once for all of them, and they are added in their order. */
  private static final int BLOCK = 4;

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

  /** Derivatives of the whitened predictions of a block of observations by the columns, with the weights and whitened residuals of these observations. */
  private final double[][] j1 = new double[BLOCK][];

  private final double[][] j2 = new double[BLOCK][];
  private final double[] weights = new double[BLOCK];
  private final double[] r1 = new double[BLOCK];
  private final double[] r2 = new double[BLOCK];
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

  /** Leaves the columns of fixed parameters out of the normal equations. */
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
    for (int n = 0; n < BLOCK; n++) {
      j1[n] = new double[chosen.length];
      j2[n] = new double[chosen.length];
    }
  }

  /** Cauchy's loss with this scale, in standard deviations; infinite for plain least squares. */
  void lossScale(double scale) {
    lossScale = scale;
  }

  /** Adds prior knowledge of one unknown, with its standard deviation. */
  void prior(int index, double value, double standardDeviation) {
    priorValue[index] = value;
    priorWeight[index] = 1 / (standardDeviation * standardDeviation);
  }

  double cost(double[] theta) {
    return costBelow(Double.POSITIVE_INFINITY, theta);
  }

  /** The cost where it is below a limit; where it is not, the same or infinity. */
  double costBelow(double limit, double[] theta) {
    evaluations++;
    curve.set(theta);
    loss.reset(lossScale, limit);
    for (int i = 0; i < data.size; i++) {
      if (used[i]) {
        loss.add(squaredDistance(i));
        if (loss.isAbove()) {
          return Double.POSITIVE_INFINITY;
        }
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
    int inBlock = 0;
    for (int i = 0; i < data.size; i++) {
      if (used[i]) {
        linearize(i, inBlock++);
      }
      if (inBlock == BLOCK) {
        accumulateBlock();
        inBlock = 0;
      }
    }
    for (int n = 0; n < inBlock; n++) {
      accumulate(n);
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

  /** Puts one observation into the block. */
  private void linearize(int i, int inBlock) {
    curve.sensitivities(data.time[i], xyz, dx, dy, dz);
    double f = data.stretch(i, xyz[2]);
    double px = xyz[0] - data.cameraX[i];
    double py = xyz[1] - data.cameraY[i];
    double rx = data.residualX(i, xyz, f);
    double ry = data.residualY(i, xyz, f);
    double w11 = data.w11[i];
    double w21 = data.w21[i];
    double w22 = data.w22[i];
    double along = w11 * rx;
    double across = w21 * rx + w22 * ry;
    r1[inBlock] = along;
    r2[inBlock] = across;
    weights[inBlock] = loss.add(along * along + across * across);
    double fz = f * f / data.cameraHeight[i];
    double fzx = px * fz;
    double fzy = py * fz;
    double[] d1 = j1[inBlock];
    double[] d2 = j2[inBlock];
    for (int c = 0; c < columns.length; c++) {
      int k = columns[c];
      double gx = f * dx[k] + fzx * dz[k];
      double gy = f * dy[k] + fzy * dz[k];
      d1[c] = w11 * gx;
      d2[c] = w21 * gx + w22 * gy;
    }
  }

  /** The inner loop of all fits, over contiguous arrays, so that the JVM checks bounds only once. */
  private void accumulateBlock() {
    double[] p1 = j1[0];
    double[] p2 = j2[0];
    double[] q1 = j1[1];
    double[] q2 = j2[1];
    double[] s1 = j1[2];
    double[] s2 = j2[2];
    double[] t1 = j1[3];
    double[] t2 = j2[3];
    for (int c = 0; c < p1.length; c++) {
      double a1 = weights[0] * p1[c];
      double a2 = weights[0] * p2[c];
      double b1 = weights[1] * q1[c];
      double b2 = weights[1] * q2[c];
      double c1 = weights[2] * s1[c];
      double c2 = weights[2] * s2[c];
      double d1 = weights[3] * t1[c];
      double d2 = weights[3] * t2[c];
      double right = rightSide[c] + (a1 * r1[0] + a2 * r2[0]);
      right += b1 * r1[1] + b2 * r2[1];
      right += c1 * r1[2] + c2 * r2[2];
      rightSide[c] = right + (d1 * r1[3] + d2 * r2[3]);
      double[] row = sums[c];
      for (int d = 0; d < row.length; d++) {
        double sum = row[d] + (a1 * p1[d] + a2 * p2[d]);
        sum += b1 * q1[d] + b2 * q2[d];
        sum += c1 * s1[d] + c2 * s2[d];
        row[d] = sum + (d1 * t1[d] + d2 * t2[d]);
      }
    }
  }

  /** Sums up the observations of a block that is not full. */
  private void accumulate(int n) {
    double[] d1 = j1[n];
    double[] d2 = j2[n];
    for (int c = 0; c < d1.length; c++) {
      double a1 = weights[n] * d1[c];
      double a2 = weights[n] * d2[c];
      rightSide[c] += a1 * r1[n] + a2 * r2[n];
      double[] row = sums[c];
      for (int d = 0; d < row.length; d++) {
        row[d] += a1 * d1[d] + a2 * d2[d];
      }
    }
  }
}
