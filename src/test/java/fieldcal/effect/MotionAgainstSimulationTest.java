package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.Drift;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.Magnus;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SlipDependentFriction;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.effect.motion.WornRegion;
import fieldcal.simulation.physics.AirLaw;
import fieldcal.simulation.physics.Ball;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallHistory;
import fieldcal.simulation.physics.BallIntegrator;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.GroundLaw;
import fieldcal.simulation.physics.ImpactLaw;
import fieldcal.simulation.physics.ImpactLaw.Contact;
import fieldcal.simulation.physics.Region;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Paths with effects against the simulation's spinning ball, which shares no code and no equations with them. */
class MotionAgainstSimulationTest {
  /** What the design asks for, m. */
  private static final double DESIGN_LIMIT = 1e-4;

  private static final double LIMIT = 2e-5;

  private static final double K = 1 / (1 + Ball.GOLF_BALL.inertiaFactor());

  /** Where teams measure it, and not where mechanics has it without anything else. */
  private static final double LATE = 0.62;

  private static final double SESSION_TIME = 400;
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, K);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.9, 0.52, -0.28);

  private record World(GroundLaw ground, ImpactLaw impact, AirLaw air, double roll, double side) {
    static final World PLAIN =
        new World(
            GroundLaw.uniform(3.1 / 9.81, 0.28),
            ImpactLaw.fixedLoss(0.75, 0.9, 0.52),
            AirLaw.NONE,
            0,
            0);

    World ground(GroundLaw law) {
      return new World(law, impact, air, roll, side);
    }

    World impact(ImpactLaw law) {
      return new World(ground, law, air, roll, side);
    }

    World air(AirLaw law) {
      return new World(ground, impact, law, roll, side);
    }

    World spin(double newRoll, double newSide) {
      return new World(ground, impact, air, newRoll, newSide);
    }
  }

  private static Arguments of(World world, MotionEffect... effects) {
    return Arguments.of(world, List.of(effects));
  }

  static Stream<Arguments> worlds() {
    World p = World.PLAIN;
    GroundLaw g = p.ground;
    return Stream.of(
        of(p),
        of(p.air(p.air.withDrag(0.45)), new AirDrag(0.45)),
        of(p.air(p.air.withDrag(1.5)), new AirDrag(1.5)),
        of(p.air(p.air.withLift(0.5)), new Magnus(0.5)),
        of(
            p.air(p.air.withLift(1)).spin(-0.5, 0.3),
            new Magnus(1),
            new KickSpin(-0.5),
            new SideSpin(0.3)),
        of(p.spin(-0.4, 0), new KickSpin(-0.4)),
        of(p.spin(0.7, 0), new KickSpin(0.7)),
        of(p.spin(0, 0.3), new SideSpin(0.3)),
        of(p.spin(0, -1), new SideSpin(-1)),
        of(p.ground(g.withSlope(0.3, 1)), new FieldSlope(0.3, 1)),
        of(p.ground(g.withSlope(2, -2)), new FieldSlope(2, -2)),
        of(p.ground(g.withNap(0.1, 2)), new CarpetNap(0.1, 2)),
        of(p.ground(g.withNap(0.5, -1)), new CarpetNap(0.5, -1)),
        of(p.ground(g.withSpeedDependentRoll(0.05, 0)), new SpeedDependentRoll(0.05)),
        of(p.ground(g.withSpeedDependentRoll(0.3, 0)), new SpeedDependentRoll(0.3)),
        of(
            p.ground(g.withWornRegion(0.3, new Region(1, 2.5, -1, 2))),
            new WornRegion(0.3, 1, 2.5, -1, 2)),
        of(
            p.ground(g.withWornRegion(-0.5, new Region(0.2, 3, 0.1, 9))),
            new WornRegion(-0.5, 0.2, 3, 0.1, 9)),
        of(p.impact(p.impact.withSpeedSlope(0.05)), new SpeedDependentRestitution(0.05)),
        of(p.impact(p.impact.withSpeedSlope(-0.1)), new SpeedDependentRestitution(-0.1)),
        // A slow impact would keep more speed than it had: both cap the restitution alike.
        of(p.impact(p.impact.withSpeedSlope(-0.4)), new SpeedDependentRestitution(-0.4)),
        of(p.impact(p.impact.withSpinCoupling(0.1)), new BounceSpinCoupling(0.1)),
        of(
            p.impact(p.impact.withSpinCoupling(0.2)).spin(-0.6, 0.2),
            new BounceSpinCoupling(0.2),
            new KickSpin(-0.6),
            new SideSpin(0.2)),
        of(sticking(p, 0, 0.6), new ContactImpacts(0, 0.6, 0, 0, 10)),
        of(sticking(p, 0, 0.2), new ContactImpacts(0, 0.2, 0, 0, 10)),
        // Slip that such impacts leave ends on the carpet.
        of(sticking(p, -0.6, 0.6), new ContactImpacts(-0.6, 0.6, 0, 0, 10)),
        of(
            sticking(p.ground(g.withWornRegion(0.4, new Region(3, 9, -9, 9))), -0.8, 0.6),
            new ContactImpacts(-0.8, 0.6, 0, 0, 10),
            new WornRegion(0.4, 3, 9, -9, 9)),
        of(
            p.impact(p.impact.withTangential(new Contact(0, 0.6, 0.03, 0.03, 0.04))),
            new ContactImpacts(0, 0.6, 0.03, 0.04, 10)),
        // Little friction: the resistance acts on a ball that slides through its impacts.
        of(
            p.impact(p.impact.withTangential(new Contact(0, 0.15, 0, 0, 0.04))),
            new ContactImpacts(0, 0.15, 0, 0.04, 10)),
        // The resistance helps to stop a ball that turns backward, then hinders it.
        of(
            p.impact(p.impact.withTangential(new Contact(0.1, 0.3, 0.01, 0.01, 0.03)))
                .spin(-0.5, 0),
            new ContactImpacts(0.1, 0.3, 0.01, 0.03, 10),
            new KickSpin(-0.5)),
        // More than friction can overcome: the ball slides without turning.
        of(
            p.impact(p.impact.withTangential(new Contact(0, 0.05, 0, 0, 0.2))),
            new ContactImpacts(0, 0.05, 0, 0.2, 10)),
        of(
            p.impact(
                p.impact
                    .withTangential(new Contact(0.15, 0.4, 0.02, 0.02, 0))
                    .withMinHopHeight(0.0005)),
            new ContactImpacts(0.15, 0.4, 0.02, 0, 0.5)),
        of(
            sticking(p, 0, 0.6).spin(-0.5, 0),
            new ContactImpacts(0, 0.6, 0, 0, 10),
            new KickSpin(-0.5)),
        of(
            sticking(p, 0, 0.3).spin(-0.6, 0.3).air(p.air.withLift(0.5)),
            new Magnus(0.5),
            new ContactImpacts(0, 0.3, 0, 0, 10),
            new KickSpin(-0.6),
            new SideSpin(0.3)),
        of(slippery(p, 0.05), new SlipDependentFriction(0.05)),
        of(
            slippery(p, 0.2).spin(-0.4, 0.3),
            new SlipDependentFriction(0.2),
            new KickSpin(-0.4),
            new SideSpin(0.3)),
        of(p.ground(g.withDrift(20.0 / 100 / 600)), new Drift(20)),
        of(
            p.ground(
                    g.withNap(0.2, 1)
                        .withDrift(0.3 / 600)
                        .withSpeedDependentRoll(0.05, 0)
                        .withWornRegion(0.4, new Region(1, 2, -2, 2)))
                .air(p.air.withDrag(0.5).withLift(0.4)),
            new CarpetNap(0.2, 1),
            new Drift(30),
            new SpeedDependentRoll(0.05),
            new WornRegion(0.4, 1, 2, -2, 2),
            new AirDrag(0.5),
            new Magnus(0.4)),
        of(p.ground(g.withDrift(-80.0 / 100 / 600)), new Drift(-80)),
        of(
            p.ground(
                    g.withNap(0.2, 1)
                        .withDrift(0.3 / 600)
                        .withSpeedDependentRoll(0.05, 0)
                        .withSlope(0.4, 2.5)
                        .withWornRegion(0.4, new Region(1, 2, -2, 2)))
                .air(p.air.withDrag(0.5).withLift(0.4))
                .spin(-0.3, 0.2),
            new CarpetNap(0.2, 1),
            new Drift(30),
            new SpeedDependentRoll(0.05),
            new FieldSlope(0.4, 2.5),
            new WornRegion(0.4, 1, 2, -2, 2),
            new AirDrag(0.5),
            new Magnus(0.4),
            new KickSpin(-0.3),
            new SideSpin(0.2)));
  }

  private static World sticking(World world, double reversed, double friction) {
    return world.impact(world.impact.withTangential(new Contact(reversed, friction, 0)));
  }

  private static World slippery(World world, double slope) {
    return world.ground(GroundLaw.uniform(3.1 / 9.81, 0.28).withSlipSlope(slope));
  }

  @ParameterizedTest
  @MethodSource("worlds")
  void flatKicksAgree(World world, List<MotionEffect> effects) {
    double[][] kicks = {{5, 2, 0}, {1.2, 0.3, 0}, {3, -0.5, 0}, {-1, 4, 0}};
    for (double[] v : kicks) {
      ExtendedTrajectory path =
          ExtendedTrajectory.flat(
              FLAT, MotionEffects.of(effects), 0, SESSION_TIME, 0, 0, v[0], v[1]);
      compare(world, path, v);
    }
  }

  /** A twin has the k_switch that was measured, and a golf ball. */
  @ParameterizedTest
  @MethodSource("worlds")
  void flatKicksAgreeWhereTheBallRollsLater(World world, List<MotionEffect> effects) {
    Ball late = Ball.GOLF_BALL.withKSwitch(LATE);
    FlatModel model = new FlatModel(FLAT.accSlide(), FLAT.accRoll(), LATE);
    for (double[] v : new double[][] {{5, 2, 0}, {-1, 4, 0}}) {
      ExtendedTrajectory path =
          ExtendedTrajectory.flat(
              model, MotionEffects.of(effects), 0, SESSION_TIME, 0, 0, v[0], v[1]);
      compare(late, DESIGN_LIMIT, world, path, v, path.restTime() + 0.1);
    }
  }

  /** Impacts that leave no slip: what is left ends in the simulation as the carpet has it, and in the model as at impacts. */
  static Stream<Arguments> worldsOfChipsThatGrip() {
    return worldsOfChips()
        .filter(
            a ->
                ((List<?>) a.get()[1])
                    .stream().noneMatch(e -> e instanceof ContactImpacts c && leavesSlip(c)));
  }

  private static boolean leavesSlip(ContactImpacts law) {
    return law.reversed() < -0.5 || law.rolling() > 0 && law.friction() < 0.5;
  }

  /** Chips have no k_switch. */
  @ParameterizedTest
  @MethodSource("worldsOfChipsThatGrip")
  void chipsAgreeWhereTheBallRollsLater(World world, List<MotionEffect> effects) {
    Ball late = Ball.GOLF_BALL.withKSwitch(LATE);
    for (double[] v : CHIPS) {
      ExtendedTrajectory path = chip(effects, v);
      compare(late, DESIGN_LIMIT, world, path, v, path.restTime() + 0.1);
    }
  }

  private static final double[][] CHIPS = {{3, 1, 3}, {2, -1, 4.2}};

  /** Impacts with a law of their own, and balls that the kick gave no spin. */
  static Stream<Arguments> worldsOfChips() {
    return worlds().filter(a -> !spins(a));
  }

  /** The league's fixed losses, and spin of the kick beside them: Coulomb friction limits none of these impacts. */
  static Stream<Arguments> worldsOfSpinningChips() {
    return worlds().filter(MotionAgainstSimulationTest::spins);
  }

  private static boolean spins(Arguments a) {
    List<?> effects = (List<?>) a.get()[1];
    return effects.stream().anyMatch(MotionEffect.SpinAtKick.class::isInstance)
        && effects.stream().noneMatch(MotionEffect.ImpactLaw.class::isInstance);
  }

  private static ExtendedTrajectory chip(List<MotionEffect> effects, double[] v) {
    return ExtendedTrajectory.chip(
        CHIP, FLAT, MotionEffects.of(effects), 0, SESSION_TIME, 0, 0, v[0], v[1], v[2]);
  }

  @ParameterizedTest
  @MethodSource("worldsOfChips")
  void chipsAgree(World world, List<MotionEffect> effects) {
    for (double[] v : CHIPS) {
      ExtendedTrajectory path = chip(effects, v);
      assertThat(path.flights()).isGreaterThan(2);
      compare(world, path, v);
    }
  }

  @ParameterizedTest
  @MethodSource("worldsOfSpinningChips")
  void spinOfTheKickActsAtTheFirstImpact(World world, List<MotionEffect> effects) {
    for (double[] v : CHIPS) {
      // Air changes how long a flight takes by a few hundredths.
      double second = 0.95 * 2 * v[2] / BallPhysics.GRAVITY * (1 + CHIP.dampingZ());
      compare(world, chip(effects, v), v, SESSION_TIME + second);
    }
  }

  /**
   * From the second impact on they differ by up to 1.3 mm. The simulation lets the whole difference of the spinning ball and the one without spin obey the contact law, u −= k·(u − q), q += k/β·(u − q), with one k; the effect takes the horizontal damping
   * of the hop for u, and its q does not feel u. After the last flight the simulation's ball slides until the slip that is left has gone, the effect's rolls at once. With the simulation's law in the effect both agree to 0.02 mm up to the last flight (commit edbc197),
   * but the chips of ER-Force's simulator were explained worse, so that it was taken back (171c651).
   */
  @Disabled("a decision: with the simulation's law, chips of another simulator are explained worse")
  @ParameterizedTest
  @MethodSource("worldsOfSpinningChips")
  void spinOfTheKickActsAtAllImpacts(World world, List<MotionEffect> effects) {
    for (double[] v : CHIPS) {
      compare(world, chip(effects, v), v);
    }
  }

  private static void compare(World world, ExtendedTrajectory path, double[] v) {
    compare(world, path, v, path.restTime() + 0.1);
  }

  private static void compare(World world, ExtendedTrajectory path, double[] v, double until) {
    compare(Ball.GOLF_BALL, LIMIT, world, path, v, until);
  }

  private static void compare(
      Ball body, double limit, World world, ExtendedTrajectory path, double[] v, double until) {
    BallBody ball = new BallBody();
    ball.place(0, 0);
    ball.kick(v[0], v[1], v[2], world.roll, world.side, Ball.GOLF_BALL.radius());
    BallPhysics physics = new BallPhysics(body, world.ground, world.impact, world.air);
    BallIntegrator integrator = new BallIntegrator(physics);
    BallHistory history = new BallHistory();
    history.node(SESSION_TIME, ball);
    integrator.advance(ball, SESSION_TIME, path.restTime() + 0.2, history);
    double[] truth = new double[3];
    double[] xyz = new double[3];
    for (double t = SESSION_TIME; t < until; t += 0.0137) {
      assertThat(history.positionAt(t, truth)).isTrue();
      path.positionAt(t, xyz);
      assertThat(xyz).containsExactly(truth, within(limit));
    }
  }
}
