package fieldcal.ball;

import java.util.Arrays;
import java.util.Objects;

/**
 * The path of a ball on the carpet: sliding, then rolling to rest; closed form.
 *
 * <p>Let {@code u = v − s} be the slip, the velocity at which the ball's lowest point rubs over the carpet, with {@code s} the
 * velocity at which a ball of this spin would roll. Friction acts against the slip, so the ball accelerates with {@code
 * |accSlide|} against {@code u}, and the slip keeps its direction and shrinks with {@code |accSlide|/(1 − kSwitch)}. Hence the
 * sliding lasts {@code |u|·(1 − kSwitch)/|accSlide|}, and the ball begins to roll with {@code v − (1 − kSwitch)·u}. Without
 * spin {@code u = v}: a straight path, rolling from {@code kSwitch·v} on. With spin about another axis than the rolling one the
 * sliding path is a parabola, as every billiards player knows (G. G. Coriolis, Théorie mathématique des effets du jeu de
 * billard, 1835).
 *
 * <p>Immutable; see {@link BallTrajectory} for what all paths have in common.
 */
public final class FlatTrajectory extends SegmentedTrajectory {
  /** Index of the derivative with respect to the kick position's x. */
  public static final int X0 = 0;

  /** Index of the derivative with respect to the kick position's y. */
  public static final int Y0 = 1;

  /** Index of the derivative with respect to the kick velocity's x. */
  public static final int VX0 = 2;

  /** Index of the derivative with respect to the kick velocity's y. */
  public static final int VY0 = 3;

  /** Index of the derivative with respect to the kick time. */
  public static final int T0 = 4;

  /** Index of the derivative with respect to {@link FlatModel#accSlide()}; the model's other parameters follow in its order. */
  public static final int ACC_SLIDE = 5;

  /** Index of the derivative with respect to {@link FlatModel#accRoll()}. */
  public static final int ACC_ROLL = 6;

  /** Index of the derivative with respect to {@link FlatModel#kSwitch()}. */
  public static final int K_SWITCH = 7;

  /** The number of derivatives of one coordinate. */
  public static final int SENSITIVITIES = 8;

  private final FlatModel model;
  private final boolean spinFree;
  private final double slipX;
  private final double slipY;
  private final double speed;
  private final double directionX;
  private final double directionY;

  private FlatTrajectory(FlatModel model, Segment slide, double slipX, double slipY, double slip) {
    super(
        new Segment[] {
          slide, Segment.roll(slide.end(), slide.stateAt(slide.duration), model.accRoll())
        });
    this.model = model;
    this.slipX = slipX;
    this.slipY = slipY;
    spinFree = slipX == slide.vx && slipY == slide.vy;
    speed = spinFree ? slip : Math.hypot(slide.vx, slide.vy);
    directionX = speed > 0 ? slide.vx / speed : 0;
    directionY = speed > 0 ? slide.vy / speed : 0;
  }

  /**
   * The path of a ball kicked without spin.
   *
   * @param model the model
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @return the path
   * @throws IllegalArgumentException when a number is not finite
   */
  public static FlatTrajectory fromKick(
      FlatModel model, double t0, double x, double y, double vx, double vy) {
    return fromKickWithSpin(model, t0, x, y, vx, vy, 0, 0);
  }

  /**
   * The path of a ball kicked with spin, or of one that slides with known spin. Spin about the vertical axis does not matter.
   *
   * @param model the model
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param spinX the spin right after the kick, given as the velocity at which a ball with this spin rolls without slip, m/s:
   *     (0, 0) = no spin, (vx, vy) = rolls at once, opposite to the velocity = backspin, across it = side spin
   * @param spinY see {@code spinX}, m/s
   * @return the path
   * @throws IllegalArgumentException when a number is not finite
   */
  public static FlatTrajectory fromKickWithSpin(
      FlatModel model,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double spinX,
      double spinY) {
    Objects.requireNonNull(model, "model");
    BallState kick = checkedState(t0, x, y, vx, vy);
    double slipX = vx - Checks.finite("spinX", spinX);
    double slipY = vy - Checks.finite("spinY", spinY);
    double slip = Math.hypot(slipX, slipY);
    double duration = slip * (model.kSwitch() - 1) / model.accSlide();
    double perSlip = slip > 0 ? model.accSlide() / slip : 0;
    Segment slide = Segment.slide(t0, duration, kick, slipX * perSlip, slipY * perSlip);
    return new FlatTrajectory(model, slide, slipX, slipY, slip);
  }

  /**
   * The path of a ball seen in motion: it slides straight on until it is as slow as the switch speed, then it rolls. The path
   * begins at the time of the state, which becomes its kick time; the path does not contain what happened before.
   *
   * @param model the model
   * @param t time of the state, s
   * @param state the state; height and vertical velocity are ignored
   * @param switchSpeed speed at which it will begin to roll, m/s, not negative: {@code kSwitch} times the speed of its kick;
   *     when it is not below the present speed, the ball rolls already
   * @return the path from {@code t} on
   * @throws IllegalArgumentException when a number is not finite or the switch speed is negative
   */
  public static FlatTrajectory fromState(
      FlatModel model, double t, BallState state, double switchSpeed) {
    Objects.requireNonNull(model, "model");
    Checks.notNegative("switchSpeed", switchSpeed);
    checkedState(t, state.x(), state.y(), state.vx(), state.vy());
    double speed = state.groundSpeed();
    // From vSwitch = v − (1 − kSwitch)·u: the slip, and with it the spin, of a ball that will roll
    // at the switch speed.
    double slip = Math.max(0, speed - switchSpeed) / (1 - model.kSwitch());
    double spin = speed > 0 ? (speed - slip) / speed : 0;
    return fromKickWithSpin(
        model,
        t,
        state.x(),
        state.y(),
        state.vx(),
        state.vy(),
        spin * state.vx(),
        spin * state.vy());
  }

  /**
   * The path of a ball that rolls. It begins at the time of the state, which becomes its kick time.
   *
   * @param model the model
   * @param t time of the state, s
   * @param state the state; height and vertical velocity are ignored
   * @return the path from {@code t} on
   * @throws IllegalArgumentException when a number is not finite
   */
  public static FlatTrajectory fromRolling(FlatModel model, double t, BallState state) {
    return fromKickWithSpin(
        model, t, state.x(), state.y(), state.vx(), state.vy(), state.vx(), state.vy());
  }

  /**
   * The model behind this path.
   *
   * @return the model
   */
  public FlatModel model() {
    return model;
  }

  /**
   * When the ball begins to roll.
   *
   * @return time on the caller's clock, s
   */
  public double tSwitch() {
    return segment(2).start;
  }

  /**
   * The spin at a time, as the velocity at which a ball with this spin rolls without slip.
   *
   * @param t time, s; before the kick and after the rest there is no spin
   * @param spin receives the spin, x and y, m/s
   * @throws IllegalArgumentException when {@code t} is NaN
   */
  public void spinAt(double t, double[] spin) {
    BallState state = stateAt(t);
    double left = phaseAt(t) == Phase.SLIDING ? (tSwitch() - t) / (tSwitch() - kickTime()) : 0;
    spin[0] = state.vx() - left * slipX;
    spin[1] = state.vy() - left * slipY;
  }

  /**
   * Where the ball is, and how its position changes with each number that the path depends on: the derivatives at a fixed time {@code t}, in the
   * order of the index constants. Does not allocate. The derivatives are continuous except those with respect to the kick time
   * at the kick. Before the kick only the derivatives with respect to the place of the kick are not zero. For a kick of zero
   * speed, where the velocity's direction is not defined, its derivatives are zero (the path's length grows with the square of
   * the speed).
   *
   * @param t time, s
   * @param xyz receives the position, m
   * @param dx receives the {@link #SENSITIVITIES} derivatives of x
   * @param dy receives the {@link #SENSITIVITIES} derivatives of y
   * @throws IllegalArgumentException when {@code t} is NaN
   * @throws IllegalStateException when the ball was kicked with spin or the path was continued from a state: it then depends on
   *     numbers that are not in the list
   */
  public void sensitivitiesAt(double t, double[] xyz, double[] dx, double[] dy) {
    if (!spinFree) {
      throw new IllegalStateException("sensitivities are known for kicks without spin only");
    }
    positionAt(t, xyz);
    Arrays.fill(dx, 0, SENSITIVITIES, 0);
    Arrays.fill(dy, 0, SENSITIVITIES, 0);
    dx[X0] = 1;
    dy[Y0] = 1;
    double tau = t - kickTime();
    if (tau < 0 || speed == 0) {
      return;
    }
    if (t < tSwitch()) {
      slidingSensitivities(tau, dx, dy);
    } else {
      rollingSensitivities(Math.min(t, restTime()) - tSwitch(), dx, dy);
    }
  }

  /** Distance since the kick: L = s·τ + ½·a·τ², s the kick speed. */
  private void slidingSensitivities(double tau, double[] dx, double[] dy) {
    double a = model.accSlide();
    alongDirection(tau * (speed + 0.5 * a * tau), tau, speed + a * tau, dx, dy);
    set(ACC_SLIDE, 0.5 * tau * tau, dx, dy);
  }

  /** Distance since the kick: L = s²(k² − 1)/(2a) + k·s·σ + ½·r·σ² with the rolling time σ = τ − s(k − 1)/a. */
  private void rollingSensitivities(double sigma, double[] dx, double[] dy) {
    double a = model.accSlide();
    double r = model.accRoll();
    double k = model.kSwitch();
    double s = speed;
    // Zero once the ball rests: a later switch then no longer shortens the distance, since the ball
    // also comes to
    // rest later.
    double v = k * s + r * sigma;
    double slideWay = s * s * (k * k - 1) / (2 * a);
    double slideTime = s * (k - 1) / a;
    double way = slideWay + sigma * (k * s + 0.5 * r * sigma);
    double bySpeed = s * (k * k - 1) / a + k * sigma - v * (k - 1) / a;
    alongDirection(way, bySpeed, v, dx, dy);
    set(ACC_SLIDE, (v * slideTime - slideWay) / a, dx, dy);
    set(ACC_ROLL, 0.5 * sigma * sigma, dx, dy);
    set(K_SWITCH, s * s * k / a + s * sigma - v * s / a, dx, dy);
  }

  /** Derivatives by the kick: its velocity turns the path (of length {@code way}) and stretches it ({@code bySpeed}), its time shifts it. */
  private void alongDirection(double way, double bySpeed, double v, double[] dx, double[] dy) {
    double turn = way / speed;
    double stretch = bySpeed - turn;
    dx[VX0] = turn + stretch * directionX * directionX;
    dx[VY0] = stretch * directionX * directionY;
    dy[VX0] = dx[VY0];
    dy[VY0] = turn + stretch * directionY * directionY;
    set(T0, -v, dx, dy);
  }

  private void set(int index, double lengthDerivative, double[] dx, double[] dy) {
    dx[index] = lengthDerivative * directionX;
    dy[index] = lengthDerivative * directionY;
  }

  private static BallState checkedState(double t, double x, double y, double vx, double vy) {
    Checks.finite("time", t);
    Checks.finite("x", x);
    Checks.finite("y", y);
    Checks.finite("vx", vx);
    Checks.finite("vy", vy);
    return new BallState(x, y, 0, vx, vy, 0);
  }

  @Override
  public String toString() {
    return "FlatTrajectory[" + stateAt(kickTime()) + " at " + kickTime() + " s, " + model + "]";
  }
}
