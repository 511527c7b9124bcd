package fieldcal.ball;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * The path of a chipped ball: flights and impacts as {@link ChipModel} describes them, then rolling to rest; closed form, straight
 * over the ground. Impacts take no time; at the last one the horizontal velocity is damped like at any other, and the ball
 * rolls on.
 *
 * <p>Immutable; see {@link BallTrajectory} for what all paths have in common.
 */
public final class ChipTrajectory extends SegmentedTrajectory {
  /** Index of the derivative with respect to the kick position's x. */
  public static final int X0 = 0;

  /** Index of the derivative with respect to the kick position's y. */
  public static final int Y0 = 1;

  /** Index of the derivative with respect to the kick velocity's x. */
  public static final int VX0 = 2;

  /** Index of the derivative with respect to the kick velocity's y. */
  public static final int VY0 = 3;

  /** Index of the derivative with respect to the kick velocity's z. */
  public static final int VZ0 = 4;

  /** Index of the derivative with respect to the kick time. */
  public static final int T0 = 5;

  /** Index of the derivative with respect to {@link ChipModel#dampingXyFirstHop()}; the model's other parameters follow in its order. */
  public static final int DAMPING_XY_FIRST_HOP = 6;

  /** Index of the derivative with respect to {@link ChipModel#dampingXyOtherHops()}. */
  public static final int DAMPING_XY_OTHER_HOPS = 7;

  /** Index of the derivative with respect to {@link ChipModel#dampingZ()}. */
  public static final int DAMPING_Z = 8;

  /** Index of the derivative with respect to {@link ChipModel#accRoll()}. */
  public static final int ACC_ROLL = 9;

  /** The number of derivatives of one coordinate. */
  public static final int SENSITIVITIES = 10;

  private static final ChipTakeoff[] NONE = {};

  private final ChipModel model;
  private final ChipTakeoff[] takeoffs;
  private final double speed;
  private final double directionX;
  private final double directionY;
  private final double kickVz;

  private ChipTrajectory(ChipModel model, Segment[] segments, ChipTakeoff[] takeoffs, double vz) {
    super(segments);
    this.model = model;
    this.takeoffs = takeoffs;
    kickVz = vz;
    speed = Math.hypot(segments[0].vx, segments[0].vy);
    directionX = speed > 0 ? segments[0].vx / speed : 0;
    directionY = speed > 0 ? segments[0].vy / speed : 0;
  }

  /**
   * The path of a ball kicked off the carpet, with as many flights as {@link ChipModel#lowestHop} allows.
   *
   * @param model the model
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz vertical velocity right after the kick, m/s, not negative; when even the kick's own flight would stay under the
   *     limit, the ball rolls at once, undamped
   * @return the path
   * @throws IllegalArgumentException when a number is not finite or {@code vz} is negative
   */
  public static ChipTrajectory fromKick(
      ChipModel model, double t0, double x, double y, double vx, double vy, double vz) {
    return fromKickWithHops(model, t0, x, y, vx, vy, vz, flightsByRule(model, vz));
  }

  /**
   * The path of a ball kicked off the carpet, with a given number of flights. At a fixed number the path depends smoothly on
   * all other numbers; the rule of the hop height makes it jump.
   *
   * @param model the model
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz vertical velocity right after the kick, m/s, not negative
   * @param flights number of flights, the kick's own included, 0 to {@link ChipModel#MAX_FLIGHTS}; 0 = rolls at once, undamped
   * @return the path
   * @throws IllegalArgumentException when a number is not finite, {@code vz} is negative or {@code flights} is out of its range
   */
  public static ChipTrajectory fromKickWithHops(
      ChipModel model,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz,
      int flights) {
    Objects.requireNonNull(model, "model");
    Checks.notNegative("vz", vz);
    Checks.between("flights", flights, 0, ChipModel.MAX_FLIGHTS);
    BallState kick = checkedState(t0, new BallState(x, y, 0, vx, vy, flights > 0 ? vz : 0));
    ChipTakeoff[] takeoffs = new ChipTakeoff[flights + 1];
    takeoffs[0] = ChipTakeoff.KICK;
    for (int i = 0; i < flights; i++) {
      takeoffs[i + 1] = takeoffs[i].next(model, vz, i + 1);
    }
    return new ChipTrajectory(model, segments(model, t0, kick, 0, flights), takeoffs, vz);
  }

  /**
   * The path of a chipped ball seen in motion. It begins at the time of the state, which becomes its kick time; the path does not contain what happened before. A ball on the carpet with too little vertical velocity for a hop rolls.
   *
   * @param model the model
   * @param t time of the state, s
   * @param state the state, not below the carpet; on the carpet not moving down
   * @param impactsBefore number of impacts before the state, not negative; with 0 the next impact is damped as the first
   * @return the path from {@code t} on
   * @throws IllegalArgumentException when a number is not finite or out of its range
   */
  public static ChipTrajectory fromState(
      ChipModel model, double t, BallState state, int impactsBefore) {
    Objects.requireNonNull(model, "model");
    checkedState(t, state);
    Checks.notNegative("z", state.z());
    Checks.finite("vz", state.vz());
    Checks.between("impactsBefore", impactsBefore, 0, Integer.MAX_VALUE - ChipModel.MAX_FLIGHTS);
    int flights;
    if (state.z() > 0) {
      // It is in the air, so this flight ends at the carpet, however low it is.
      double g = Gravity.ACCELERATION;
      double impactVz = Math.sqrt(state.vz() * state.vz() + 2 * g * state.z());
      flights = 1 + flightsByRule(model, impactVz * model.dampingZ());
    } else {
      flights = flightsByRule(model, state.vz());
    }
    int limited = Math.min(flights, ChipModel.MAX_FLIGHTS);
    return new ChipTrajectory(
        model, segments(model, t, state, impactsBefore, limited), NONE, state.vz());
  }

  /**
   * How many flights a ball makes that leaves the carpet with a given vertical velocity, each apex {@code vz²/(2g)} being at
   * least {@link ChipModel#lowestHop}.
   *
   * @param model the model
   * @param vz vertical velocity of the first flight, m/s, not negative
   * @return the number of flights, 0 when even the first is too low, at most {@link ChipModel#MAX_FLIGHTS}
   * @throws IllegalArgumentException when {@code vz} is negative or not finite
   */
  public static int flightsByRule(ChipModel model, double vz) {
    double next = Checks.notNegative("vz", vz);
    int flights = 0;
    while (flights < ChipModel.MAX_FLIGHTS
        && next * next >= 2 * Gravity.ACCELERATION * model.lowestHop()) {
      flights++;
      next *= model.dampingZ();
    }
    return flights;
  }

  /**
   * The model behind this path.
   *
   * @return the model
   */
  public ChipModel model() {
    return model;
  }

  /**
   * How many flights the path has.
   *
   * @return the number of flights, the kick's own (or the rest of the one the state was in) included
   */
  public int hops() {
    return movingCount() - 1;
  }

  /**
   * The landing points of all flights.
   *
   * @return one for each flight, in order of time; cannot be changed
   */
  public List<Landing> landings() {
    List<Landing> landings = new ArrayList<>(hops());
    for (int i = 1; i <= hops(); i++) {
      Segment after = segment(i + 1);
      landings.add(new Landing(after.start, after.x, after.y));
    }
    return List.copyOf(landings);
  }

  /**
   * Where the ball is, and how its position changes with each number that the path depends on: the derivatives at a fixed time {@code t} and a
   * fixed number of flights, in the order of the index constants. Does not allocate. They jump at the kick and at impacts.
   * Before the kick only the derivatives with respect to the place of the kick are not zero. For a chip straight up the
   * direction of rolling is not defined; the derivatives with respect to the horizontal velocity are then those of the flights alone.
   *
   * @param t time, s
   * @param xyz receives the position, m
   * @param dx receives the {@link #SENSITIVITIES} derivatives of x
   * @param dy receives the {@link #SENSITIVITIES} derivatives of y
   * @param dz receives the {@link #SENSITIVITIES} derivatives of z
   * @throws IllegalArgumentException when {@code t} is NaN
   * @throws IllegalStateException when the path was continued from a state: it then depends on numbers that are not in the list
   */
  public void sensitivitiesAt(double t, double[] xyz, double[] dx, double[] dy, double[] dz) {
    if (takeoffs.length == 0) {
      throw new IllegalStateException("sensitivities are known for paths from a kick only");
    }
    int index = indexAt(t);
    position(index, t, xyz);
    Arrays.fill(dx, 0, SENSITIVITIES, 0);
    Arrays.fill(dy, 0, SENSITIVITIES, 0);
    Arrays.fill(dz, 0, SENSITIVITIES, 0);
    dx[X0] = 1;
    dy[Y0] = 1;
    if (t < kickTime()) {
      return;
    }
    if (index <= hops()) {
      ChipTakeoff from = takeoffs[index - 1];
      double tau = t - segment(index).start;
      double reach = from.reach() + from.pace() * tau;
      overGround(from, tau, reach, reach, speed * from.pace(), dx, dy);
      vertical(from, tau, dz);
    } else {
      ChipTakeoff from = takeoffs[hops()];
      double r = model.accRoll();
      double sigma = Math.min(t, restTime()) - segment(hops() + 1).start;
      // Zero once the ball rests: a later landing then no longer shortens the distance, since the
      // ball also comes to
      // rest later.
      double v = speed * from.pace() + r * sigma;
      double bySpeed = from.reach() + from.pace() * sigma;
      double reach = speed > 0 ? bySpeed + 0.5 * r * sigma * sigma / speed : bySpeed;
      overGround(from, sigma, reach, bySpeed, v, dx, dy);
      set(ACC_ROLL, 0.5 * sigma * sigma, dx, dy);
    }
  }

  /**
   * How the distance over the ground changes with the damping at each single impact while the others stay as they are: the derivatives at a fixed time and number of flights. Those of all impacts but the first
   * add up to the derivative with respect to {@link #DAMPING_XY_OTHER_HOPS}. Does not allocate.
   *
   * @param t time, s
   * @param byImpact receives the derivatives, m, that of the first impact first; elements beyond the last impact become 0
   * @throws IllegalArgumentException when {@code t} is NaN
   * @throws IllegalStateException when the path was continued from a state
   */
  public void dampingSensitivitiesAt(double t, double[] byImpact) {
    if (takeoffs.length == 0) {
      throw new IllegalStateException("sensitivities are known for paths from a kick only");
    }
    Arrays.fill(byImpact, 0);
    int index = indexAt(t);
    if (t < kickTime() || index == 0) {
      return;
    }
    // Flights after the one that is under way do not matter yet.
    int landed = Math.min(index - 1, hops());
    double until = index <= hops() ? t : Math.min(t, restTime());
    ChipTakeoff from = takeoffs[landed];
    double reach = from.reach() + from.pace() * (until - segment(landed + 1).start);
    for (int impact = 1; impact <= Math.min(landed, byImpact.length); impact++) {
      double scaled = speed * (reach - takeoffs[impact].reach());
      byImpact[impact - 1] = scaled / model.dampingXyAtImpact(impact);
    }
  }

  /**
   * Distance over the ground; {@code reach} = distance per kick speed, {@code bySpeed} = derivative of the distance by the kick speed, v = present speed.
   */
  private void overGround(
      ChipTakeoff from,
      double tau,
      double reach,
      double bySpeed,
      double v,
      double[] dx,
      double[] dy) {
    double stretch = bySpeed - reach;
    dx[VX0] = reach + stretch * directionX * directionX;
    dx[VY0] = stretch * directionX * directionY;
    dy[VX0] = dx[VY0];
    dy[VY0] = reach + stretch * directionY * directionY;
    set(T0, -v, dx, dy);
    // If the takeoff is one second later, the ball is v metres behind.
    set(VZ0, speed * from.reachByVz() - v * from.timeByVz(), dx, dy);
    double byFirst = from.reachByFirst() + from.paceByFirst() * tau;
    double byOther = from.reachByOther() + from.paceByOther() * tau;
    set(DAMPING_XY_FIRST_HOP, speed * byFirst, dx, dy);
    set(DAMPING_XY_OTHER_HOPS, speed * byOther, dx, dy);
    double byDampingZ = speed * from.reachByDampingZ() - v * from.timeByDampingZ();
    set(DAMPING_Z, byDampingZ, dx, dy);
  }

  private void vertical(ChipTakeoff from, double tau, double[] dz) {
    double vz = kickVz * from.lift() - Gravity.ACCELERATION * tau;
    dz[T0] = -vz;
    dz[VZ0] = from.lift() * tau - vz * from.timeByVz();
    dz[DAMPING_Z] = kickVz * from.liftByDampingZ() * tau - vz * from.timeByDampingZ();
  }

  private void set(int index, double lengthDerivative, double[] dx, double[] dy) {
    dx[index] = lengthDerivative * directionX;
    dy[index] = lengthDerivative * directionY;
  }

  private static Segment[] segments(
      ChipModel model, double t0, BallState kick, int impactsBefore, int flights) {
    Segment[] segments = new Segment[flights + 1];
    double start = t0;
    BallState at = kick;
    for (int i = 0; i < flights; i++) {
      segments[i] = Segment.flight(start, at);
      start = segments[i].end();
      double damping = model.dampingXyAtImpact(impactsBefore + i + 1);
      BallState end = segments[i].stateAt(segments[i].duration);
      at =
          new BallState(
              end.x(),
              end.y(),
              0,
              end.vx() * damping,
              end.vy() * damping,
              -end.vz() * model.dampingZ());
    }
    segments[flights] =
        Segment.roll(start, new BallState(at.x(), at.y(), 0, at.vx(), at.vy(), 0), model.accRoll());
    return segments;
  }

  private static BallState checkedState(double t, BallState state) {
    Checks.finite("time", t);
    Checks.finite("x", state.x());
    Checks.finite("y", state.y());
    Checks.finite("vx", state.vx());
    Checks.finite("vy", state.vy());
    return state;
  }

  @Override
  public String toString() {
    return "ChipTrajectory[%s at %s s, %d flights, %s]"
        .formatted(stateAt(kickTime()), kickTime(), hops(), model);
  }
}
