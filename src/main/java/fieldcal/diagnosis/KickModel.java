package fieldcal.diagnosis;

import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MotionEffects;
import fieldcal.kick.KickKind;
import java.util.Arrays;

/**
 * One kick under a hypothesis: its own unknowns (position, velocity, time, then its magnitudes of the random effects), its residuals, and their derivatives by forward differences. A
 * working object; not thread-safe, but those of different kicks are independent.
 */
final class KickModel {
  /** Steps of the numerical derivatives: position, m; velocity, m/s; time, s; magnitude of a random effect. */
  private static final double POSITION_STEP = 1e-3;

  private static final double VELOCITY_STEP = 1e-3;
  private static final double TIME_STEP = 1e-4;

  private static final double RANDOM_STEP = 0.005;

  /** Slowest rise of a chip, m/s. */
  private static final double SLOWEST_RISE = 0.05;

  final KickData data;
  final int ownSize;
  final int kickSize;
  double[] own;
  int flights;
  private final double sessionStart;

  /** Working space: where a ball is; that of a flat kick is on the carpet. */
  private final double[] ball = new double[3];

  /** Only observations until then count, s. */
  private double until = Double.POSITIVE_INFINITY;

  KickModel(KickData data, int randomEffects, double sessionStart) {
    this.data = data;
    this.sessionStart = sessionStart;
    kickSize = data.start.length;
    ownSize = kickSize + randomEffects;
    own = Arrays.copyOf(data.start, ownSize);
    flights = data.flights;
  }

  /** Starts where another fit of the same kick ended; magnitudes of random effects that it does not know at {@code mean}. */
  void startFrom(double[] otherOwn, int otherFlights, double[] mean) {
    for (int k = 0; k < ownSize; k++) {
      own[k] = k < otherOwn.length ? otherOwn[k] : mean[k - kickSize];
    }
    flights = otherFlights;
  }

  void until(double time) {
    until = time;
  }

  boolean counts(int i) {
    return data.used[i] && data.time[i] <= until;
  }

  ExtendedTrajectory path(SharedState state, double[] p) {
    MotionEffects motion = state.motionOf(p, kickSize);
    double t0 = p[data.timeIndex()];
    if (data.kind == KickKind.FLAT) {
      return ExtendedTrajectory.flat(state.flat, motion, sessionStart, t0, p[0], p[1], p[2], p[3]);
    }
    return ExtendedTrajectory.chipWithHops(
        state.chip, motion, sessionStart, t0, p[0], p[1], p[2], p[3], clampRise(p[4]), flights);
  }

  /** How many flights the 10 mm rule says. */
  int flightsByRule(SharedState state, double[] p) {
    MotionEffects motion = state.motionOf(p, kickSize);
    double t0 = p[data.timeIndex()];
    return ExtendedTrajectory.chip(
            state.chip, motion, sessionStart, t0, p[0], p[1], p[2], p[3], clampRise(p[4]))
        .flights();
  }

  private static double clampRise(double vz) {
    return Math.max(SLOWEST_RISE, vz);
  }

  /** Whitened residuals, seen minus predicted, two per observation, zero for those that do not count; returns the sum of their squares. */
  double residuals(SharedState state, ExtendedTrajectory path, double[] out) {
    state.measurement.report(data.sightings, path, sessionStart, out);
    double sum = 0;
    for (int i = 0; i < data.size; i++) {
      if (!counts(i)) {
        out[2 * i] = 0;
        out[2 * i + 1] = 0;
        continue;
      }
      double rx = data.x[i] - out[2 * i];
      double ry = data.y[i] - out[2 * i + 1];
      double r1 = data.w11[i] * rx;
      double r2 = data.w21[i] * rx + data.w22[i] * ry;
      out[2 * i] = r1;
      out[2 * i + 1] = r2;
      sum += r1 * r1 + r2 * r2;
    }
    return sum;
  }

  /** Residuals in the plane, seen minus predicted, m, of all observations, those included that do not count. */
  void plainResiduals(SharedState state, double[] rx, double[] ry) {
    double[] ground = new double[2 * data.size];
    state.measurement.report(data.sightings, path(state, own), sessionStart, ground);
    for (int i = 0; i < data.size; i++) {
      rx[i] = data.x[i] - ground[2 * i];
      ry[i] = data.y[i] - ground[2 * i + 1];
    }
  }

  /** What the kick's own unknowns cost: a time that no rest pins, magnitudes away from the mean. */
  double priorCost(SharedState state, double[] p, double[] scatter) {
    double cost = 0;
    if (!data.fromRest) {
      double d = (p[data.timeIndex()] - data.kick.time()) / KickData.TIME_PRIOR;
      cost += d * d;
    }
    for (int j = kickSize; j < ownSize; j++) {
      double d = (p[j] - mean(state, j)) / scatter[j - kickSize];
      cost += d * d;
    }
    return cost;
  }

  /** Residuals and what the own unknowns cost: what a fit makes small. */
  double cost(SharedState state, double[] p, double[] scatter, double[] residuals) {
    return residuals(state, path(state, p), residuals) + priorCost(state, p, scatter);
  }

  /** The own unknowns after a step; a chip still rises then. */
  double[] moved(double[] step) {
    double[] next = own.clone();
    for (int k = 0; k < next.length; k++) {
      next[k] += step[k];
    }
    if (data.kind == KickKind.CHIP) {
      next[4] = clampRise(next[4]);
    }
    return next;
  }

  /**
   * Adds what {@link #priorCost} says of the own unknowns to the normal equations.
   *
   * @param meansMove whether the means of the random effects are among the unknowns of those equations
   */
  void tie(KickNormal normal, SharedState state, double[] scatter, boolean meansMove) {
    if (!data.fromRest) {
      int t = data.timeIndex();
      double weight = 1 / (KickData.TIME_PRIOR * KickData.TIME_PRIOR);
      normal.tie(t, -1, own[t] - data.kick.time(), weight);
    }
    for (int j = kickSize; j < ownSize; j++) {
      double s = scatter[j - kickSize];
      int column = meansMove ? meanIndex(state, j) : -1;
      normal.tie(j, column, own[j] - mean(state, j), 1 / (s * s));
    }
  }

  /** Means of the random effects are the last of the shared values. */
  double mean(SharedState state, int ownIndex) {
    return state.values[meanIndex(state, ownIndex)];
  }

  private int meanIndex(SharedState state, int ownIndex) {
    return state.values.length - ownSize + ownIndex;
  }

  /**
   * Derivatives of the prediction by the kick's own unknowns, whitened: one column each, by forward differences. A kick elsewhere in the field moves its path along, but for what depends on the place, which is
   * left out.
   *
   * @param centre residuals at the kick's own unknowns
   */
  void ownColumns(SharedState state, double[] centre, double[][] columns) {
    ExtendedTrajectory path = path(state, own);
    for (int i = 0; i < data.size; i++) {
      boolean counts = counts(i);
      if (data.kind == KickKind.CHIP) {
        path.positionAt(data.time[i], ball);
      }
      double f = counts ? data.enlargement(i, ball[2]) : 0;
      columns[0][2 * i] = f * data.w11[i];
      columns[0][2 * i + 1] = f * data.w21[i];
      columns[1][2 * i] = 0;
      columns[1][2 * i + 1] = f * data.w22[i];
    }
    double[] p = own.clone();
    for (int k = 2; k < ownSize; k++) {
      double h = ownStep(k);
      p[k] = own[k] + h;
      residuals(state, path(state, p), columns[k]);
      p[k] = own[k];
      difference(centre, columns[k], h);
    }
  }

  /** Derivative by something shared, by forward differences to a state that is {@code h} apart. */
  void column(
      SharedState centre,
      ExtendedTrajectory centrePath,
      double[] centreResiduals,
      SharedState plus,
      double h,
      double[] column) {
    residuals(plus, sameMotion(centre, plus) ? centrePath : path(plus, own), column);
    difference(centreResiduals, column, h);
  }

  private static void difference(double[] centre, double[] column, double h) {
    for (int i = 0; i < column.length; i++) {
      column[i] = (centre[i] - column[i]) / h;
    }
  }

  private static boolean sameMotion(SharedState a, SharedState b) {
    return a.motion == b.motion && a.flat.equals(b.flat) && a.chip.equals(b.chip);
  }

  double ownStep(int k) {
    if (k < 2) {
      return POSITION_STEP;
    }
    if (k < data.timeIndex()) {
      return VELOCITY_STEP;
    }
    return k == data.timeIndex() ? TIME_STEP : RANDOM_STEP;
  }
}
