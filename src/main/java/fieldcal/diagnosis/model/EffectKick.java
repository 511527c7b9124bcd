package fieldcal.diagnosis.model;

import fieldcal.ball.ChipModel;
import fieldcal.effect.Area;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.Reports;
import fieldcal.effect.Sightings;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.Probe;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * One kick under a model with effects, as a term of the kernel. Own parameters: position x, y (m), velocity vx, vy, for chips vz (m/s), time (s), then its values of the random effects. A chip's number of flights is the discrete
 * unknown. Immutable.
 */
public final class EffectKick implements KickTerm<ModelState> {
  /** Steps of the numerical derivatives: velocity, m/s; time, s; share of a random effect's scale. As small as those of the shared parameters, for the same reason. */
  private static final double VELOCITY_STEP = 1e-4;

  private static final double TIME_STEP = 1e-4;
  private static final double RANDOM_STEP = 0.002;

  /** Slowest rise of a chip, m/s. */
  private static final double SLOWEST_RISE = 0.05;

  /** Penalty of a number of flights against the rule, in units of chi-square; noise reaches it once in ten thousand kicks. */
  private static final double RULE_PENALTY = 15;

  /** Share by which the vertical speed may be off because of errors of the fit when the rule is applied. */
  private static final double RULE_TOLERANCE = 0.025;

  /** Largest difference of the numbers of flights that a restart tries; a chip of 6.5 m/s makes five or six. */
  private static final int MOST_TRIED = 6;

  /** Distance from a place within which a path counts as passing it, m: allows for its bend between two sightings, and for its way while cameras are late. */
  private static final double PATH_MARGIN = 0.1;

  private final KickRecord record;
  private final double[] randomScales;
  private final double sessionStart;
  private final Effort effort;
  private final int flights;

  /**
   * A kick.
   *
   * @param record its observations
   * @param model whose random effects the kick has values of
   * @param sessionStart beginning of the session on the kicks' clock, s
   * @param effort to which its paths are added
   */
  public EffectKick(KickRecord record, EffectModel model, double sessionStart, Effort effort) {
    this(
        record,
        model.random().stream().mapToDouble(c -> c.coordinates().get(0).scale()).toArray(),
        sessionStart,
        effort,
        record.flights);
  }

  private EffectKick(
      KickRecord record, double[] randomScales, double sessionStart, Effort effort, int flights) {
    this.record = record;
    this.randomScales = randomScales;
    this.sessionStart = sessionStart;
    this.effort = effort;
    this.flights = flights;
  }

  /**
   * The same with another number of flights.
   *
   * @param newFlights 1 or more; of a chip
   * @return the changed copy
   */
  public EffectKick withFlights(int newFlights) {
    return new EffectKick(record, randomScales, sessionStart, effort, newFlights);
  }

  /**
   * The same with other detections.
   *
   * @param other of the same kick
   * @return the changed copy
   */
  public EffectKick with(KickRecord other) {
    return new EffectKick(other, randomScales, sessionStart, effort, flights);
  }

  /**
   * The same taken for a kick of the other kind.
   *
   * @param other with the fit as that kind
   * @return the changed copy, with the number of flights of that fit
   */
  public EffectKick as(KickRecord other) {
    return new EffectKick(other, randomScales, sessionStart, effort, other.flights);
  }

  /**
   * The observations.
   *
   * @return of this kick
   */
  public KickRecord record() {
    return record;
  }

  /**
   * The discrete unknown.
   *
   * @return number of flights; of no meaning for flat kicks
   */
  public int flights() {
    return flights;
  }

  @Override
  public int ownSize() {
    return KickRecord.ownSize(record.kind) + randomScales.length;
  }

  @Override
  public int rows() {
    return 2 * record.blocks.length;
  }

  /**
   * When the ball was kicked.
   *
   * @param own the kick's own parameters
   * @return s since the beginning of the session
   */
  public double sessionTime(double[] own) {
    return own[record.timeIndex()] - sessionStart;
  }

  /**
   * The ball's path.
   *
   * @param own the kick's own parameters
   * @param state of the model
   * @return the path with this number of flights
   */
  public ExtendedTrajectory path(double[] own, ModelState state) {
    return path(own, state, Double.POSITIVE_INFINITY);
  }

  /** The path as far as these sightings go. */
  private ExtendedTrajectory path(double[] own, ModelState state, Sightings seen) {
    return path(own, state, state.measurement().lastBallTime(seen, sessionStart));
  }

  private ExtendedTrajectory path(double[] own, ModelState state, double until) {
    ExtendedTrajectory path = integrated(own, state, until);
    effort.add(path.pieces());
    return path;
  }

  private ExtendedTrajectory integrated(double[] own, ModelState state, double until) {
    MotionEffects motion = state.motionOf(own);
    double t0 = own[record.timeIndex()];
    if (record.kind == KickKind.FLAT) {
      return ExtendedTrajectory.flat(
          state.flat(), motion, sessionStart, t0, own[0], own[1], own[2], own[3], until);
    }
    return ExtendedTrajectory.chipWithHops(
        state.chip(),
        state.flat(),
        motion,
        sessionStart,
        t0,
        own[0],
        own[1],
        own[2],
        own[3],
        Math.max(SLOWEST_RISE, own[4]),
        flights,
        until);
  }

  /**
   * How many flights the rule of the lowest hop gives.
   *
   * @param own the kick's own parameters
   * @param state of the model
   * @return at least 1 for a chip that rises
   */
  public int flightsByRule(double[] own, ModelState state) {
    return flightsByRule(own, state, 1);
  }

  private int flightsByRule(double[] own, ModelState state, double rise) {
    return ExtendedTrajectory.flightsByRule(
        state.chip(),
        state.motionOf(own),
        sessionStart,
        own[record.timeIndex()],
        own[0],
        own[1],
        own[2],
        own[3],
        rise * Math.max(SLOWEST_RISE, own[4]));
  }

  @Override
  public void residuals(double[] own, ModelState state, double[] out) {
    double[] ground = reported(own, state);
    for (int b = 0; b < record.blocks.length; b++) {
      double s1 = 0;
      double s2 = 0;
      int[] block = record.blocks[b];
      for (int i : block) {
        double rx = record.x[i] - ground[2 * i];
        double ry = record.y[i] - ground[2 * i + 1];
        s1 += record.w11[i] * rx;
        s2 += record.w21[i] * rx + record.w22[i] * ry;
      }
      double root = record.rootOfSum(block.length);
      out[2 * b] = s1 / root;
      out[2 * b + 1] = s2 / root;
    }
  }

  /**
   * Residuals in the plane, seen minus predicted, of all detections, including those that are not used.
   *
   * @param own the kick's own parameters
   * @param state of the model
   * @param rx receives m
   * @param ry receives m
   */
  public void plainResiduals(double[] own, ModelState state, double[] rx, double[] ry) {
    double[] ground = reported(own, state);
    for (int i = 0; i < record.size; i++) {
      rx[i] = record.x[i] - ground[2 * i];
      ry[i] = record.y[i] - ground[2 * i + 1];
    }
  }

  @Override
  public void ownColumns(double[] own, ModelState state, double[] residuals, double[][] columns) {
    columns(own, state, residuals, List.of(), columns, new double[0][]);
  }

  /** Where the cameras report the ball, of all detections, m. */
  private double[] reported(double[] own, ModelState state) {
    double[] ground = new double[2 * record.size];
    ExtendedTrajectory path = path(own, state, record.sightings);
    state.measurement().report(record.sightings, path, sessionStart, ground);
    return ground;
  }

  private double step(int k) {
    int time = record.timeIndex();
    if (k < time) {
      return VELOCITY_STEP;
    }
    return k == time ? TIME_STEP : RANDOM_STEP * randomScales[k - time - 1];
  }

  @Override
  public void sharedColumns(
      double[] own,
      ModelState state,
      double[] residuals,
      List<Probe<ModelState>> probes,
      double[][] columns) {
    new Surroundings(own, state, probes).byShared(probes, columns);
  }

  @Override
  public void columns(
      double[] own,
      ModelState state,
      double[] residuals,
      List<Probe<ModelState>> probes,
      double[][] ownColumns,
      double[][] sharedColumns) {
    Surroundings around = new Surroundings(own, state, probes);
    around.byOwn(ownColumns);
    around.byShared(probes, sharedColumns);
  }

  /** What is reported near one state and these own parameters; what all derivatives there have in common is computed once. */
  private final class Surroundings {
    private final double[] own;
    private final ModelState state;
    private final double until;

    /** Shared with the states that differ in what the cameras do. */
    private final ExtendedTrajectory path;

    private final Reports reports;

    private final double[] here = new double[2 * record.blocks.length];
    private double[] way;

    Surroundings(double[] own, ModelState state, List<Probe<ModelState>> probes) {
      this.own = own;
      this.state = state;
      double last = state.measurement().lastBallTime(record.blockSightings, sessionStart);
      for (Probe<ModelState> probe : probes) {
        last = Math.max(last, lastBallTime(probe.to()));
        last = probe.from() == null ? last : Math.max(last, lastBallTime(probe.from()));
      }
      until = last;
      path = path(own, state, until);
      reports = new Reports(state.measurement(), record.blockSightings, path, sessionStart);
      reports.copyTo(here);
    }

    private double lastBallTime(ModelState there) {
      MeasurementEffects cameras = there.measurement();
      return cameras.isAsLateAs(state.measurement())
          ? Double.NEGATIVE_INFINITY
          : cameras.lastBallTime(record.blockSightings, sessionStart);
    }

    void byOwn(double[][] columns) {
      double[] ball = new double[3];
      for (int b = 0; b < record.blocks.length; b++) {
        // To first order, moving the kick moves its whole path.
        double f = 1;
        if (record.kind == KickKind.CHIP) {
          path.positionAt(record.blockTime[b], ball);
          f = record.blockHeight[b] / (record.blockHeight[b] - ball[2]);
        }
        columns[0][2 * b] = f;
        columns[0][2 * b + 1] = 0;
        columns[1][2 * b] = 0;
        columns[1][2 * b + 1] = f;
      }
      whiten(columns[0]);
      whiten(columns[1]);
      double[] p = own.clone();
      for (int k = 2; k < own.length; k++) {
        double h = step(k);
        p[k] = own[k] + h;
        reported(state, path(p, state, until), columns[k]);
        p[k] = own[k];
        difference(here, h, columns[k]);
      }
    }

    void byShared(List<Probe<ModelState>> probes, double[][] columns) {
      double[] from = new double[here.length];
      for (int c = 0; c < columns.length; c++) {
        Probe<ModelState> probe = probes.get(c);
        if (!comesToWhereTheyDiffer(probe)) {
          Arrays.fill(columns[c], 0);
          continue;
        }
        if (probe.from() != null) {
          report(probe.from(), from);
        }
        report(probe.to(), columns[c]);
        difference(probe.from() == null ? here : from, probe.width(), columns[c]);
      }
    }

    private boolean comesToWhereTheyDiffer(Probe<ModelState> probe) {
      Optional<Area> area = probe.to().reach();
      if (area.isEmpty()) {
        return true;
      }
      way = way == null ? way(path) : way;
      return comes(way, area.get());
    }

    private void report(ModelState there, double[] out) {
      if (there.hasMotionOf(state, record.kind == KickKind.CHIP, sessionTime(own))) {
        reports.under(there.measurement(), out);
      } else {
        reports.near(path(own, there, until), out);
      }
    }
  }

  /** Places of the ball at the kick and whenever it was seen, x and y in turn. */
  private double[] way(ExtendedTrajectory path) {
    double[] way = new double[2 * (record.blocks.length + 1)];
    double[] ball = new double[3];
    path.positionAt(path.kickTime(), ball);
    way[0] = ball[0];
    way[1] = ball[1];
    for (int b = 0; b < record.blocks.length; b++) {
      path.positionAt(record.blockTime[b], ball);
      way[2 * b + 2] = ball[0];
      way[2 * b + 3] = ball[1];
    }
    return way;
  }

  private static boolean comes(double[] way, Area area) {
    for (int i = 2; i < way.length; i += 2) {
      if (area.isNear(way[i - 2], way[i - 1], way[i], way[i + 1], PATH_MARGIN)) {
        return true;
      }
    }
    return false;
  }

  private void reported(ModelState state, ExtendedTrajectory path, double[] out) {
    state.measurement().report(record.blockSightings, path, sessionStart, out);
  }

  /** The whitened derivative from two reports. */
  private void difference(double[] centre, double h, double[] column) {
    for (int i = 0; i < column.length; i++) {
      column[i] = (column[i] - centre[i]) / h;
    }
    whiten(column);
  }

  private void whiten(double[] column) {
    for (int b = 0; b < record.blocks.length; b++) {
      double dx = column[2 * b];
      double dy = column[2 * b + 1];
      column[2 * b] = record.block11[b] * dx;
      column[2 * b + 1] = record.block21[b] * dx + record.block22[b] * dy;
    }
  }

  @Override
  public double ownPrior(int index) {
    return index == record.timeIndex() ? record.kick.time() : 0;
  }

  @Override
  public double ownPrecision(int index) {
    boolean tied = index == record.timeIndex() && !record.fromRest;
    return tied ? 1 / (record.kick.timeError() * record.kick.timeError()) : 0;
  }

  @Override
  public void clamp(double[] own) {
    if (record.kind == KickKind.CHIP) {
      own[4] = Math.max(SLOWEST_RISE, own[4]);
    }
  }

  @Override
  public List<KickTerm<ModelState>> neighbours() {
    if (record.kind == KickKind.FLAT) {
      return List.of();
    }
    List<KickTerm<ModelState>> others = new ArrayList<>();
    if (flights > 1) {
      others.add(withFlights(flights - 1));
    }
    if (flights < ChipModel.MAX_FLIGHTS) {
      others.add(withFlights(flights + 1));
    }
    return others;
  }

  @Override
  public KickTerm<ModelState> byRule(double[] own, ModelState state) {
    int expected = record.kind == KickKind.FLAT ? flights : flightsByRule(own, state);
    return expected == flights ? this : withFlights(expected);
  }

  @Override
  public List<Restart<ModelState>> restarts(double[] own, ModelState state) {
    double[] first = own.clone();
    System.arraycopy(record.start, 0, first, 0, record.start.length);
    if (record.kind == KickKind.FLAT) {
      return List.of(new Restart<>(this, first));
    }
    List<Restart<ModelState>> all = new ArrayList<>();
    int byRule = flightsByRule(own, state);
    int least = Math.max(1, Math.min(flights, byRule) - 1);
    int most = Math.min(ChipModel.MAX_FLIGHTS, Math.min(least + MOST_TRIED, byRule + 1));
    for (int n = least; n <= most; n++) {
      all.add(new Restart<>(withFlights(n), first));
      all.add(new Restart<>(withFlights(n), own));
    }
    return all;
  }

  @Override
  public double penalty(double[] own, ModelState state) {
    if (record.kind == KickKind.FLAT) {
      return 0;
    }
    int fewest = flightsByRule(own, state, 1 - RULE_TOLERANCE);
    int most = flightsByRule(own, state, 1 + RULE_TOLERANCE);
    if (flights >= fewest && flights <= most) {
      return 0;
    }
    boolean near = flights >= fewest - 1 && flights <= most + 1;
    return near ? RULE_PENALTY : Double.POSITIVE_INFINITY;
  }
}
