package fieldcal.simulation.physics;

import java.util.ArrayList;
import java.util.List;

/**
 * All laws that the simulated ball obeys.
 *
 * @param ball the body
 * @param ground the carpet
 * @param impact the bounce
 * @param air drag, lift
 * @param extras what changes these laws
 * @param seams lines that balls on the ground cross with a jolt
 */
public record BallPhysics(
    Ball ball,
    GroundLaw ground,
    ImpactLaw impact,
    AirLaw air,
    List<ExtraLaw> extras,
    List<Seam> seams) {

  /** Acceleration of free fall, m/s². */
  public static final double GRAVITY = 9.81;

  /** The league's models with typical values of tournaments of 2026: accSlide −3.1 m/s², accRoll −0.28 m/s², kSwitch 0.65; e_xy1 0.75, e_xy 0.95, e_z 0.52. */
  public static final BallPhysics IDEAL = ideal(-3.1, -0.28, 0.65, 0.75, 0.95, 0.52);

  /** Copies the lists. {@inheritDoc} */
  public BallPhysics {
    extras = List.copyOf(extras);
    seams = List.copyOf(seams);
  }

  /**
   * Laws without extras and seams.
   *
   * @param ball the body
   * @param ground the carpet
   * @param impact the bounce
   * @param air drag, lift
   */
  public BallPhysics(Ball ball, GroundLaw ground, ImpactLaw impact, AirLaw air) {
    this(ball, ground, impact, air, List.of(), List.of());
  }

  /**
   * A world in which a kick without spin obeys the league's two-phase law exactly and a chip the fixed-loss law: friction is chosen so that they do, and the carpet lets a golf ball roll as early or as late as {@code kSwitch} says. Wherever something else turns the ball (an impact, a slope under a rolling ball), its inertia is that of a golf ball, as in the extended model of a diagnosis.
   *
   * @param accSlide acceleration while sliding, m/s², negative
   * @param accRoll acceleration while rolling, m/s², negative
   * @param kSwitch speed at which rolling begins over the kick speed, 0 … 1
   * @param dampingXyFirstHop e_xy1 (–)
   * @param dampingXyOtherHops e_xy (–)
   * @param dampingZ e_z (–)
   * @return the laws
   * @throws IllegalArgumentException when a value is out of range
   */
  public static BallPhysics ideal(
      double accSlide,
      double accRoll,
      double kSwitch,
      double dampingXyFirstHop,
      double dampingXyOtherHops,
      double dampingZ) {
    Check.range("kSwitch", kSwitch, 0.1, 0.99);
    return new BallPhysics(
        Ball.GOLF_BALL.withKSwitch(kSwitch),
        GroundLaw.uniform(-accSlide / GRAVITY, -accRoll),
        ImpactLaw.fixedLoss(dampingXyFirstHop, dampingXyOtherHops, dampingZ),
        AirLaw.NONE);
  }

  /**
   * A solid golf ball whose bounces are contacts with friction.
   *
   * @param slidingFriction μ (–)
   * @param rollingDeceleration m/s², positive
   * @param dampingZ e_z (–)
   * @return the laws
   * @throws IllegalArgumentException when a value is out of range
   */
  public static BallPhysics contact(
      double slidingFriction, double rollingDeceleration, double dampingZ) {
    return new BallPhysics(
        Ball.GOLF_BALL,
        GroundLaw.uniform(slidingFriction, rollingDeceleration),
        ImpactLaw.fixedLoss(0.75, 0.95, dampingZ)
            .withTangential(new ImpactLaw.Contact(-0.1, 0.35, 0.02)),
        AirLaw.NONE);
  }

  /**
   * Another ball.
   *
   * @param newBall the body
   * @return the changed laws
   */
  public BallPhysics withBall(Ball newBall) {
    return new BallPhysics(newBall, ground, impact, air, extras, seams);
  }

  /**
   * Another carpet.
   *
   * @param law the carpet
   * @return the changed laws
   */
  public BallPhysics withGround(GroundLaw law) {
    return new BallPhysics(ball, law, impact, air, extras, seams);
  }

  /**
   * Another bounce.
   *
   * @param law the bounce
   * @return the changed laws
   */
  public BallPhysics withImpact(ImpactLaw law) {
    return new BallPhysics(ball, ground, law, air, extras, seams);
  }

  /**
   * Other air.
   *
   * @param law drag and lift
   * @return the changed laws
   */
  public BallPhysics withAir(AirLaw law) {
    return new BallPhysics(ball, ground, impact, law, extras, seams);
  }

  /**
   * One law more.
   *
   * @param law what it changes
   * @return the changed laws
   */
  public BallPhysics withExtra(ExtraLaw law) {
    List<ExtraLaw> all = new ArrayList<>(extras);
    all.add(law);
    return new BallPhysics(ball, ground, impact, air, all, seams);
  }

  /**
   * One seam more.
   *
   * @param seam where and how
   * @return the changed laws
   */
  public BallPhysics withSeam(Seam seam) {
    List<Seam> all = new ArrayList<>(seams);
    all.add(seam);
    return new BallPhysics(ball, ground, impact, air, extras, all);
  }
}
