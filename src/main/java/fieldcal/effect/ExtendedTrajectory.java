package fieldcal.effect;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Phase;
import java.util.Objects;
import java.util.OptionalDouble;

/**
 * The path of a kicked ball on which effects act, integrated numerically when it is made; afterwards immutable, any state in well under a microsecond.
 *
 * <p>The equations are those of the closed forms with forces added. With the spin as the velocity s at which a ball with that spin rolls without slip,
 * and the slip u = v − s: sliding, dv/dt = accSlide·û + f and ds/dt along û so that |u| shrinks at |accSlide|/(1 − kSwitch) where f = 0; rolling,
 * dv/dt = accRoll·v̂ + f/(1+β), s = v; in flight dv/dt = f − g. On the carpet only the horizontal part of f is added; its vertical part scales all
 * friction by the pressure on the carpet, 1 − f_z/g. At an impact the models' fixed losses act, and the torque of the impulse m·Δv changes the spin by Δs = −Δv/β, at most until the ball
 * rolls. After the last flight the ball rolls, unless a law of impacts holds.
 *
 * <p>Spin that the kick gave the ball, q (as s), acts at impacts, too. The impulse along the ground follows from the slip of the contact point (R. L. Garwin, "Kinematics of an ultraelastic rough ball", Am. J. Phys.
 * 37, 1969; R. Cross, "Grip-slip behavior of a bouncing ball", Am. J. Phys. 70, 2002): as long as the ball grips, Δv = −k·(v − s), which for a ball without spin is the model's loss with k = 1 − dampingXyFirstHop. So the path without q stays
 * the model's, and q is a linear perturbation of it with the same k: at each impact v gets k·q more, and q is used up by the torque, q ← q·max(0, 1 − k/β). A {@linkplain MotionEffect.ImpactLaw law of impacts} takes the place of both; the slip
 * that its impacts leave ends by sliding with accSlide, ds/dt = −(dv/dt)/β, before the ball rolls.
 *
 * <p>From the second impact on, this differs from the contact law itself, in which the velocity gained from q contributes to the slip, too. The simulation uses that law; until the last flight ends, the two differ by up to 1.3 mm in usual chips. It is not used here, because it explains the chips of another simulator, whose
 * impacts are integrated, less well.
 *
 * <p>Without effects the path is {@link fieldcal.ball.FlatTrajectory}'s or {@link ChipTrajectory}'s.
 *
 * <p>A slope that rolling resistance cannot hold would keep the ball rolling for ever: the path ends after {@link #MAX_DURATION}.
 */
public final class ExtendedTrajectory implements BallTrajectory {
  /** Longest path, s; chosen, because no kick rolls for half a minute. */
  public static final double MAX_DURATION = 60;

  private final Path path;
  private final double kickTime;
  private final double restTime;
  private final int flights;
  private final double kickX;
  private final double kickY;

  private ExtendedTrajectory(PathIntegrator integrator, double t0, double x, double y) {
    path = integrator.path();
    flights = integrator.flights();
    kickTime = t0;
    kickX = x;
    kickY = y;
    restTime = path.count() == 0 ? t0 : path.end();
  }

  /**
   * The path of a flat kick.
   *
   * @param model how the ball slides and rolls
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @return the path
   * @throws IllegalArgumentException when a number is not finite
   */
  public static ExtendedTrajectory flat(
      FlatModel model,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy) {
    return flat(model, effects, sessionStart, t0, x, y, vx, vy, Double.POSITIVE_INFINITY);
  }

  /**
   * The path of a flat kick up to a given time, which takes less time than the whole path where the ball was seen only for a part of its way.
   *
   * @param model how the ball slides and rolls
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param until the latest time that will be asked about, s; the path may end at any time after it, as if the ball stopped there
   * @return the path, up to that time the same as the whole
   * @throws IllegalArgumentException when a number is not finite; {@code until} may be infinite
   */
  public static ExtendedTrajectory flat(
      FlatModel model,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double until) {
    Objects.requireNonNull(model, "model");
    requireNumber("until", until);
    finite(sessionStart, t0, x, y, vx, vy, 0);
    PathIntegrator integrator =
        new PathIntegrator(
            effects, sessionStart, model.accRoll(), t0, PathIntegrator.NO_BOUNCES, until);
    integrator.slideFrom(model, t0, x, y, vx, vy);
    return new ExtendedTrajectory(integrator, t0, x, y);
  }

  /**
   * The path of a chip, with as many flights as {@link ChipModel#lowestHop} allows.
   *
   * @param model how the ball bounces and rolls
   * @param flat how it slides after the last impact, where an {@link MotionEffect.ImpactLaw} leaves slip: its accSlide counts
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s, not negative
   * @return the path
   * @throws IllegalArgumentException when a number is not finite or {@code vz} is negative
   */
  public static ExtendedTrajectory chip(
      ChipModel model,
      FlatModel flat,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz) {
    boolean rolls = ChipTrajectory.flightsByRule(model, vz) == 0;
    int flights = rolls ? 0 : PathIntegrator.BY_RULE;
    return bounce(
        model,
        flat,
        effects,
        sessionStart,
        t0,
        x,
        y,
        vx,
        vy,
        vz,
        flights,
        Double.POSITIVE_INFINITY);
  }

  /**
   * How many flights {@link ChipModel#lowestHop} allows, found without integrating the rolling that follows.
   *
   * @param model how the ball bounces
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s, not negative
   * @return those of {@link #chip(ChipModel, FlatModel, MotionEffects, double, double, double, double, double, double, double)}
   * @throws IllegalArgumentException when a number is not finite or {@code vz} is negative
   */
  public static int flightsByRule(
      ChipModel model,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz) {
    if (ChipTrajectory.flightsByRule(model, vz) == 0) {
      return 0;
    }
    int byRule = PathIntegrator.BY_RULE;
    FlatModel any = FlatModel.typical();
    return bounce(model, any, effects, sessionStart, t0, x, y, vx, vy, vz, byRule, t0).flights();
  }

  /**
   * The path of a chip with a given number of flights, on which it depends smoothly.
   *
   * @param model how the ball bounces and rolls
   * @param flat how it slides after the last impact, where an {@link MotionEffect.ImpactLaw} leaves slip: its accSlide counts
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s, not negative
   * @param flights number of flights, the kick's own included, 0 to {@link ChipModel#MAX_FLIGHTS}
   * @return the path
   * @throws IllegalArgumentException when a number is not finite, {@code vz} is negative or {@code flights} out of its range
   */
  public static ExtendedTrajectory chipWithHops(
      ChipModel model,
      FlatModel flat,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz,
      int flights) {
    double always = Double.POSITIVE_INFINITY;
    return chipWithHops(model, flat, effects, sessionStart, t0, x, y, vx, vy, vz, flights, always);
  }

  /**
   * The path of a chip with a given number of flights, up to a given time.
   *
   * @param model how the ball bounces and rolls
   * @param flat how it slides after the last impact, where an {@link MotionEffect.ImpactLaw} leaves slip: its accSlide counts
   * @param effects what acts in addition
   * @param sessionStart when the session began, on the clock of {@code t0}, s
   * @param t0 time of the kick, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s, not negative
   * @param flights number of flights, the kick's own included, 0 to {@link ChipModel#MAX_FLIGHTS}
   * @param until the latest time that will be asked about, s; all flights are integrated, but on the carpet the path may end at any later time, as if the ball stopped there
   * @return the path, up to that time the same as the whole
   * @throws IllegalArgumentException when a number is not finite ({@code until} may be infinite), {@code vz} is negative or {@code flights} is out of its range
   */
  public static ExtendedTrajectory chipWithHops(
      ChipModel model,
      FlatModel flat,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz,
      int flights,
      double until) {
    if (flights < 0 || flights > ChipModel.MAX_FLIGHTS) {
      throw new IllegalArgumentException("flights out of range: " + flights);
    }
    return bounce(model, flat, effects, sessionStart, t0, x, y, vx, vy, vz, flights, until);
  }

  private static ExtendedTrajectory bounce(
      ChipModel model,
      FlatModel flat,
      MotionEffects effects,
      double sessionStart,
      double t0,
      double x,
      double y,
      double vx,
      double vy,
      double vz,
      int flights,
      double until) {
    Objects.requireNonNull(model, "model");
    Objects.requireNonNull(flat, "flat");
    requireNumber("until", until);
    finite(sessionStart, t0, x, y, vx, vy, vz);
    if (vz < 0) {
      throw new IllegalArgumentException("vz must not be negative, but is " + vz);
    }
    PathIntegrator integrator =
        new PathIntegrator(effects, sessionStart, model.accRoll(), t0, flights, until);
    integrator.flyFrom(model, flat, t0, x, y, vx, vy, vz);
    return new ExtendedTrajectory(integrator, t0, x, y);
  }

  private static void finite(
      double session, double t0, double x, double y, double vx, double vy, double vz) {
    EffectParameters.requireFinite("kick", session, t0, x, y, vx, vy, vz);
  }

  /**
   * How much work it took to integrate the path.
   *
   * @return pieces that were integrated one by one
   */
  public int pieces() {
    return path.count();
  }

  /**
   * How many flights the path has.
   *
   * @return the number, 0 for a flat kick
   */
  public int flights() {
    return flights;
  }

  @Override
  public double kickTime() {
    return kickTime;
  }

  @Override
  public double restTime() {
    return restTime;
  }

  @Override
  public BallState stateAt(double t) {
    if (t >= kickTime && t < restTime) {
      int i = path.indexAt(t);
      double s = path.share(i, t);
      return new BallState(
          path.position(i, 0, s),
          path.position(i, 1, s),
          path.height(i, s),
          path.velocity(i, 0, s),
          path.velocity(i, 1, s),
          path.phase(i) == Phase.FLYING ? path.velocity(i, 2, s) : 0);
    }
    double[] xyz = new double[3];
    positionAt(t, xyz);
    return new BallState(xyz[0], xyz[1], xyz[2], 0, 0, 0);
  }

  @Override
  public void positionAt(double t, double[] xyz) {
    requireNumber("t", t);
    if (t < kickTime || path.count() == 0) {
      xyz[0] = kickX;
      xyz[1] = kickY;
      xyz[2] = 0;
      return;
    }
    int i = path.indexAt(t);
    double s = path.share(i, t);
    xyz[0] = path.position(i, 0, s);
    xyz[1] = path.position(i, 1, s);
    xyz[2] = path.height(i, s);
  }

  PathFollower follower() {
    return new PathFollower(path, kickTime, kickX, kickY);
  }

  @Override
  public Phase phaseAt(double t) {
    requireNumber("t", t);
    if (t < kickTime) {
      return Phase.RESTING_BEFORE_KICK;
    }
    return t < restTime ? path.phase(path.indexAt(t)) : Phase.STOPPED;
  }

  @Override
  public double distanceAt(double t) {
    requireNumber("t", t);
    if (t < kickTime) {
      return 0;
    }
    if (t >= restTime) {
      return path.wayBefore(path.count());
    }
    int i = path.indexAt(t);
    return path.wayBefore(i) + path.length(i, path.share(i, t));
  }

  @Override
  public OptionalDouble timeAtDistance(double distance) {
    if (!(distance >= 0) || Double.isInfinite(distance)) {
      throw new IllegalArgumentException("distance must be 0 or more, but is " + distance);
    }
    if (distance > path.wayBefore(path.count())) {
      return OptionalDouble.empty();
    }
    if (distance == 0) {
      return OptionalDouble.of(kickTime);
    }
    int low = 0;
    int high = path.count() - 1;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (path.wayBefore(middle + 1) >= distance) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    double s = path.shareAtLength(low, distance - path.wayBefore(low));
    return OptionalDouble.of(path.start(low) + s * path.duration(low));
  }

  @Override
  public OptionalDouble speedAtDistance(double distance) {
    OptionalDouble time = timeAtDistance(distance);
    return time.isEmpty() ? time : OptionalDouble.of(stateAt(time.getAsDouble()).groundSpeed());
  }

  private static void requireNumber(String name, double t) {
    if (Double.isNaN(t)) {
      throw new IllegalArgumentException(name + " must be a number, but is NaN");
    }
  }

  @Override
  public String toString() {
    return "ExtendedTrajectory[kick at " + kickTime + " s, rest at " + restTime + " s]";
  }
}
