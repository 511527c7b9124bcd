package fieldcal.movement;

import java.util.ArrayList;
import java.util.List;

/**
 * The limit of acceleration or of braking, and whether it depends on speed or direction.
 *
 * <p>An effect is named when, with it, clearly more manoeuvres lie at the limit than at the best uniform limit, its coefficient is clearly not zero, and large enough to matter. With a coefficient that is not
 * there, one finds some 1 % more by chance; the margins are wide enough for the eight tests that two teams need.
 */
final class AccelerationLimit {
  /** So many manoeuvres are needed for a limit … */
  private static final int FEWEST = 15;

  /** … and so many for telling effects. */
  private static final int FEWEST_FOR_EFFECTS = 60;

  /** A higher mode counts as the limit when it holds at least this part of the largest one's mass … */
  private static final double SECOND_MODE = 0.12;

  /** … and at least so many manoeuvres. */
  private static final double SECOND_MODE_MASS = 8;

  /** With the effect so many times more manoeuvres must lie at the limit. */
  private static final double GAIN = 1.1;

  /** Standard errors from zero. */
  private static final double SIGNIFICANT = 5;

  private static final double SMALLEST = 0.08;
  private static final double LARGEST = 0.97;

  /** When less of the manoeuvres lie there, the limit was not reached. */
  private static final double REACHED = 0.1;

  /**
   * What the method is off by beside noise, in parts of the limit: corners of other shapes than a {@link Rounding} describes, and robots of a team that differ by 1 %. Half a per cent rms over 60 teams of another simulator (trapezoids, limited jerk, controllers that lag or plan with a
   * margin). It goes into the standard error.
   */
  private static final double SYSTEMATIC = 0.006;

  /** The same for a limit that few manoeuvres reach: pieces that were cut wrongly made small heaps up to 3 % above the limit of two of these teams. */
  private static final double SYSTEMATIC_OF_FEW = 0.015;

  /**
   * What a coefficient is off by beside noise: pieces of constant acceleration over one that falls with speed, cells of the table. Up to 0.01 in simulated matches of ten minutes.
   */
  private static final double SYSTEMATIC_COEFFICIENT = 0.01;

  private static final double[] QUANTILES = {0.15, 0.3, 0.45, 0.6, 0.75, 0.85, 0.92, 0.97};
  private static final double[] COEFFICIENTS = {0, 0.3, 0.6};
  private static final double[] NARROWING = {0.3, 0.15, 0.07};

  private final ManoeuvreTable.Columns data;
  private final long samples;
  private final String seenIn;
  private final int robots;
  private final boolean uniformSoFar;
  private final List<MovementEffect> named = new ArrayList<>();
  private SaturationFit.Mode uniform;
  private SaturationFit.Mode mode;

  /** Looks at manoeuvres of one kind; torque is only asked for when the robots accelerate. */
  AccelerationLimit(ManoeuvreTable table, double velocity, int robots, boolean accelerating) {
    this(table.columns(), table.samples(), velocity, robots, accelerating, true);
  }

  private AccelerationLimit(
      ManoeuvreTable.Columns columns,
      long samples,
      double velocity,
      int robots,
      boolean accelerating,
      boolean uniformSoFar) {
    data = columns;
    this.robots = robots;
    this.uniformSoFar = uniformSoFar;
    this.samples = samples;
    seenIn = accelerating ? "acceleration" : "braking";
    if (samples < FEWEST) {
      return;
    }
    uniform = highest();
    mode = uniform;
    if (uniform == null || samples < FEWEST_FOR_EFFECTS) {
      return;
    }
    List<List<MovementEffect>> candidates = new ArrayList<>();
    candidates.add(List.of(MovementEffect.DIRECTIONAL));
    if (accelerating && velocity > 0) {
      candidates.add(List.of(MovementEffect.TORQUE_LIMITED));
      candidates.add(List.of(MovementEffect.TORQUE_LIMITED, MovementEffect.DIRECTIONAL));
    }
    double most = largest().mass();
    for (List<MovementEffect> effects : candidates) {
      SaturationFit.Mode with = withEffects(effects, velocity);
      if (with != null && with.mass() > GAIN * most && believable(with)) {
        most = with.mass();
        mode = with;
        named.clear();
        named.addAll(effects);
      }
    }
  }

  /**
   * Braking of a team that accelerates less aside: the same wheels brake, so that its braking depends on the direction as well, even where too few manoeuvres use all of it to show that by themselves.
   */
  static AccelerationLimit braking(
      ManoeuvreTable table, double velocity, int robots, AccelerationLimit acceleration) {
    AccelerationLimit own = new AccelerationLimit(table, velocity, robots, false);
    int known = acceleration.named.indexOf(MovementEffect.DIRECTIONAL);
    if (known < 0 || !own.named.isEmpty()) {
      return own;
    }
    double coefficient = acceleration.coefficient(known);
    ManoeuvreTable.Columns columns = table.columns().alongFront(coefficient);
    AccelerationLimit shared =
        new AccelerationLimit(columns, table.samples(), velocity, robots, false, false);
    return shared.mode == null ? own : shared;
  }

  private static boolean believable(SaturationFit.Mode with) {
    for (int k = 1; k < with.beta().length; k++) {
      double coefficient = -with.beta()[k] / with.beta()[0];
      double error = with.errors()[k] / with.beta()[0];
      if (!(coefficient >= SMALLEST
          && coefficient <= LARGEST
          && coefficient > SIGNIFICANT * error)) {
        return false;
      }
    }
    return true;
  }

  private List<SaturationFit.Mode> uniformModes() {
    SaturationFit fit = new SaturationFit(data);
    List<SaturationFit.Mode> modes = new ArrayList<>();
    for (double share : QUANTILES) {
      SaturationFit.Mode found = fit.climb(new double[] {quantile(share)});
      if (found != null) {
        modes.add(found);
      }
    }
    return modes;
  }

  private SaturationFit.Mode largest() {
    SaturationFit.Mode best = null;
    for (SaturationFit.Mode m : uniformModes()) {
      if (best == null || m.mass() > best.mass()) {
        best = m;
      }
    }
    return best;
  }

  /** The highest mode that holds a fair part of what the largest does. */
  private SaturationFit.Mode highest() {
    SaturationFit.Mode most = largest();
    SaturationFit.Mode high = most;
    for (SaturationFit.Mode m : uniformModes()) {
      boolean fair =
          m.mass() > SECOND_MODE * most.mass()
              && m.mass() > SECOND_MODE_MASS
              && m.errors()[0] < 0.1 * m.beta()[0];
      if (fair && m.beta()[0] > high.beta()[0]) {
        high = m;
      }
    }
    return high;
  }

  private SaturationFit.Mode withEffects(List<MovementEffect> effects, double velocity) {
    double[][] columns = new double[effects.size()][];
    for (int k = 0; k < columns.length; k++) {
      columns[k] = column(effects.get(k), velocity);
    }
    SaturationFit fit = new SaturationFit(data, columns);
    SaturationFit.Mode best = null;
    for (double share : QUANTILES) {
      for (double coefficient : COEFFICIENTS) {
        double[] start = new double[1 + columns.length];
        start[0] = quantile(share);
        for (int k = 1; k < start.length; k++) {
          start[k] = -coefficient * start[0];
        }
        SaturationFit.Mode found = fit.climb(start, NARROWING);
        if (found != null && (best == null || found.mass() > best.mass())) {
          best = found;
        }
      }
    }
    return best;
  }

  private double[] column(MovementEffect effect, double velocity) {
    if (effect == MovementEffect.DIRECTIONAL) {
      return data.sine2();
    }
    double[] share = data.speed().clone();
    for (int i = 0; i < share.length; i++) {
      share[i] /= velocity;
    }
    return share;
  }

  private double quantile(double share) {
    double wanted = share * samples;
    double below = 0;
    for (int i = 0; i < data.count().length; i++) {
      below += data.count()[i];
      if (below >= wanted) {
        return data.acceleration()[i];
      }
    }
    return data.acceleration()[data.count().length - 1];
  }

  LimitEstimate estimate() {
    if (mode == null) {
      return LimitEstimate.undetermined(samples, "needs " + FEWEST + " manoeuvres");
    }
    // Where it depends on speed or direction, these are known to cells only, which would blur the
    // edge.
    UpperEdge edge =
        named.isEmpty() && uniformSoFar
            ? UpperEdge.of(data.acceleration(), data.error(), data.count())
            : null;
    if (edge == null) {
      double error = Math.hypot(mode.errors()[0], SYSTEMATIC * mode.beta()[0]);
      return estimate(mode.beta()[0], error, mode.share());
    }
    double differ = edge.scatter() / Math.sqrt(Math.max(1, robots));
    double systematic = edge.share() < REACHED ? SYSTEMATIC_OF_FEW : SYSTEMATIC;
    double error = Math.hypot(Math.hypot(edge.error(), differ), systematic * edge.value());
    return estimate(edge.value(), error, edge.share());
  }

  private LimitEstimate estimate(double value, double error, double share) {
    boolean reached = share >= REACHED;
    String note =
        reached ? "" : "the robots seldom use all they have; few manoeuvres are at this limit";
    return new LimitEstimate(value, error, samples, reached, note);
  }

  private double coefficient(int effect) {
    return -mode.beta()[effect + 1] / mode.beta()[0];
  }

  List<LimitDeviation> deviations() {
    List<LimitDeviation> list = new ArrayList<>();
    for (int k = 0; k < named.size(); k++) {
      list.add(
          new LimitDeviation(
              named.get(k),
              coefficient(k),
              Math.hypot(mode.errors()[k + 1] / mode.beta()[0], SYSTEMATIC_COEFFICIENT),
              seenIn,
              uniform.share(),
              mode.share()));
    }
    return list;
  }
}
