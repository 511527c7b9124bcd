package fieldcal.simulation.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.FlatModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Stripes;
import fieldcal.effect.learned.Surface;
import fieldcal.effect.motion.AirDrag;
import fieldcal.simulation.physics.TabulatedLaw.Quantity;
import fieldcal.simulation.physics.TabulatedLaw.Variable;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Laws from tables do what the same law as a formula does. */
class TabulatedLawTest {
  private static final BallPhysics PLAIN = BallPhysics.ideal(-3, -0.3, 0.7, 0.75, 0.9, 0.5);

  /** kSwitch of a solid ball, of whose moment of inertia forces on a rolling ball ask. */
  private static final double SOLID = 5.0 / 7;

  private static final BallPhysics SOLID_BALL = BallPhysics.ideal(-3, -0.3, SOLID, 0.75, 0.9, 0.5);

  private static BallBody after(BallPhysics physics, double vx, double vz, double seconds) {
    BallBody ball = new BallBody();
    ball.launch(vx, 0, vz, 0, 0, 0);
    new BallIntegrator(physics).advance(ball, 0, seconds, new BallHistory());
    return ball;
  }

  private static double[] grid(double from, double to, int n) {
    double[] grid = new double[n];
    for (int i = 0; i < n; i++) {
      grid[i] = from + (to - from) * i / (n - 1);
    }
    return grid;
  }

  private static BallPhysics with(Quantity quantity, Variable variable, Table table) {
    return PLAIN.withExtra(new TabulatedLaw(quantity, variable, table));
  }

  @Test
  void tableIsLinearBetweenPointsAndConstantBeyond() {
    Table table = Table.curve(new double[] {0, 1, 3}, new double[] {0, 2, 4}, 0);
    assertThat(table.at(0.5, 9)).isEqualTo(1);
    assertThat(table.at(2, 0)).isEqualTo(3);
    assertThat(table.at(-5, 0)).isZero();
    assertThat(table.at(7, 0)).isEqualTo(4);
    Table repeating = Table.curve(new double[] {0, 1, 2}, new double[] {0, 1, 0}, 2);
    assertThat(repeating.at(5.25, 0)).isCloseTo(0.75, within(1e-12));
    assertThat(repeating.at(-0.5, 0)).isCloseTo(0.5, within(1e-12));
    Table surface =
        Table.surface(new double[] {0, 1}, new double[] {0, 2}, new double[] {0, 1, 4, 5});
    assertThat(surface.at(0.5, 1)).isEqualTo(2.5);
  }

  @Test
  void tablesThatCannotBeAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Table.curve(new double[] {0, 0}, new double[] {1, 2}, 0))
        .withMessageContaining("ascend");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Table.curve(new double[] {0}, new double[] {Double.NaN}, 0));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new TabulatedLaw(
                    Quantity.TURN,
                    Variable.HOP,
                    Table.surface(new double[] {0}, new double[] {0, 1}, new double[2])))
        .withMessageContaining("hop is one number");
  }

  /** As in the model: how far off the place of the kick a ball is that turns, not how far it has rolled. */
  @Test
  void distanceRolledIsStraightFromTheKick() {
    Table constant = Table.curve(new double[] {0}, new double[] {0.5}, 0);
    Table growing = Table.curve(new double[] {0, 10}, new double[] {0, 1}, 0);
    TabulatedLaw law = new TabulatedLaw(Quantity.ROLLING, Variable.DISTANCE_ROLLED, growing);
    double[] detour = new double[1];
    ExtraLaw watcher =
        new ExtraLaw() {
          @Override
          public double rollingFactor(BallMoment m) {
            double straight = Math.hypot(m.x(), m.y());
            assertThat(law.rollingFactor(m)).isCloseTo(1 + straight / 10, within(1e-9));
            detour[0] = Math.max(detour[0], m.path() - straight);
            return 1;
          }
        };
    after(with(Quantity.ACCELERATION_ACROSS, Variable.SPEED, constant).withExtra(watcher), 3, 0, 4);
    assertThat(detour[0]).isGreaterThan(0.1);
  }

  /** Rolling deceleration that grows with speed, as a formula and as a table of the acceleration along the path. */
  @Test
  void brakingBySpeedEqualsItsFormula() {
    double slope = 0.05;
    double[] speeds = grid(0, 8, 81);
    double[] values = new double[speeds.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = -slope * speeds[i];
    }
    // From rolling on: the formula leaves the sliding ball alone.
    BallBody formula = new BallBody();
    BallBody table = new BallBody();
    for (BallBody ball : new BallBody[] {formula, table}) {
      ball.kick(3, 0, 0, 1, 0, Ball.GOLF_BALL.radius());
    }
    GroundLaw ground = PLAIN.ground().withSpeedDependentRoll(slope, 0);
    new BallIntegrator(PLAIN.withGround(ground)).advance(formula, 0, 4, new BallHistory());
    new BallIntegrator(
            with(Quantity.ACCELERATION_ALONG, Variable.SPEED, Table.curve(speeds, values, 0)))
        .advance(table, 0, 4, new BallHistory());
    assertThat(table.x()).isCloseTo(formula.x(), within(1e-4));
    assertThat(table.x()).isLessThan(3 * 4 - 0.5 * 0.3 * 16 - 0.1);
  }

  @Test
  void frictionFromATableIsAFactorOfSlidingAndRolling() {
    double[] minutes = {0, 60};
    Table more = Table.curve(minutes, new double[] {0.2, 0.2}, 0);
    BallPhysics braked = with(Quantity.FRICTION, Variable.SESSION_TIME, more);
    BallPhysics same = BallPhysics.ideal(-3.6, -0.36, 0.7, 0.75, 0.9, 0.5);
    for (double seconds : new double[] {0.2, 2}) {
      assertThat(after(braked, 4, 0, seconds).x())
          .isCloseTo(after(same, 4, 0, seconds).x(), within(1e-6));
    }
    Table ice = Table.curve(new double[] {0}, new double[] {-3}, 0);
    BallBody free = after(with(Quantity.FRICTION, Variable.SESSION_TIME, ice), 4, 0, 2);
    assertThat(free.vx()).as("friction never pushes").isCloseTo(4, within(1e-9));
  }

  @Test
  void rollingFromATableIsAFactorOfRollingAlone() {
    Table more = Table.curve(new double[] {0}, new double[] {0.2}, 0);
    BallPhysics braked = with(Quantity.ROLLING, Variable.SESSION_TIME, more);
    BallPhysics same = BallPhysics.ideal(-3, -0.36, 0.7, 0.75, 0.9, 0.5);
    for (double seconds : new double[] {0.2, 2}) {
      assertThat(after(braked, 4, 0, seconds).x())
          .isCloseTo(after(same, 4, 0, seconds).x(), within(1e-6));
    }
  }

  @Test
  void aBallThatATablePushesStillStops() {
    Table push = Table.curve(new double[] {0}, new double[] {2}, 0);
    BallBody ball = after(with(Quantity.ACCELERATION_ALONG, Variable.SPEED, push), 1, 0, 120);
    assertThat(ball.phase()).isEqualTo(MotionPhase.RESTING);
  }

  @Test
  void accelerationAcrossTurnsTheBallToItsLeft() {
    Table pull = Table.curve(new double[] {0}, new double[] {0.1}, 0);
    BallBody ball = new BallBody();
    ball.kick(4, 0, 0, 1, 0, Ball.GOLF_BALL.radius());
    new BallIntegrator(with(Quantity.ACCELERATION_ACROSS, Variable.SPEED, pull))
        .advance(ball, 0, 1, new BallHistory());
    assertThat(ball.y()).isCloseTo(0.05, within(0.002));
  }

  /** Both integrators know the law, each in its own form. */
  @Test
  void slidingFrictionByTheDirectionOfTheSlipIsTheLearnedTermsFriction() {
    LearnedTerm term =
        new LearnedFamily(
                fieldcal.effect.learned.Quantity.SLIDING,
                List.of(fieldcal.effect.learned.Variable.HEADING),
                new Harmonics(1, 0.5 * Math.PI),
                OptionalInt.empty())
            .term(-0.15, 0.05, 0.1, -0.4);
    double[] angles = IntStream.rangeClosed(0, 720).mapToDouble(i -> Math.PI * i / 360).toArray();
    BallPhysics box = PLAIN;
    Quantity[] parts = {Quantity.SLIDING_ALONG, Quantity.SLIDING_ACROSS};
    for (int c = 0; c < parts.length; c++) {
      int component = c;
      double[] values = Arrays.stream(angles).map(a -> term.valueAt(component, a, 0)).toArray();
      Table table = Table.curve(angles, values, 2 * Math.PI);
      box = box.withExtra(new TabulatedLaw(parts[c], Variable.HEADING, table));
    }
    ExtendedTrajectory path =
        ExtendedTrajectory.flat(
            new FlatModel(-3, -0.3, 0.7),
            MotionEffects.of(List.of((MotionEffect) term)),
            0,
            0,
            0,
            0,
            4 * Math.cos(0.2),
            4 * Math.sin(0.2));
    BallBody ball = new BallBody();
    ball.launch(4 * Math.cos(0.2), 4 * Math.sin(0.2), 0, 0, 0, 0);
    new BallIntegrator(box).advance(ball, 0, 1.5, new BallHistory());
    assertThat(path.stateAt(1.5).x()).isCloseTo(ball.x(), within(1e-3));
    assertThat(path.stateAt(1.5).y()).isCloseTo(ball.y(), within(1e-3));
    // Friction has no moment about the contact point: the ball rolls on in the direction of the
    // kick,
    // on another line.
    assertThat(Math.atan2(ball.vy(), ball.vx())).isCloseTo(0.2, within(1e-6));
    double aside = ball.y() * Math.cos(0.2) - ball.x() * Math.sin(0.2);
    assertThat(Math.abs(aside)).isGreaterThan(0.01);
  }

  @Test
  void impactsAreChangedHopByHop() {
    double[] hops = {1, 2, 3};
    Table second = Table.curve(hops, new double[] {0, 0.1, 0}, 0);
    BallBody plain = after(PLAIN, 2, 4, 1.0);
    BallBody first = after(with(Quantity.VERTICAL_RESTITUTION, Variable.HOP, second), 2, 4, 1.0);
    // One impact so far: nothing differs. After the second one, the ball flies faster upwards.
    assertThat(first.state).containsExactly(plain.state);
    BallBody later = after(with(Quantity.VERTICAL_RESTITUTION, Variable.HOP, second), 2, 4, 1.25);
    assertThat(later.vz() - after(PLAIN, 2, 4, 1.25).vz()).isCloseTo(0.2, within(1e-6));
    Table loss = Table.curve(new double[] {0}, new double[] {-0.25}, 0);
    BallBody slower =
        after(with(Quantity.TANGENTIAL_RESTITUTION, Variable.VERTICAL_SPEED, loss), 2, 4, 1.0);
    assertThat(slower.vx()).isCloseTo(2 * 0.5, within(1e-9));
    Table turn = Table.curve(new double[] {0}, new double[] {0.3}, 0);
    BallBody turned = after(with(Quantity.TURN, Variable.GROUND_SPEED, turn), 2, 4, 1.0);
    assertThat(Math.atan2(turned.vy(), turned.vx())).isCloseTo(0.3, within(1e-9));
  }

  /** A rolling ball takes 1/(1 + β) of a force, which is kSwitch; later friction turns with it. */
  @Test
  void aPushActsOnTheCarpetOnly() {
    Table push = Table.curve(new double[] {0}, new double[] {0.02}, 0);
    double rolls = 0.5;
    BallPhysics pushed = with(Quantity.PUSH_Y, Variable.SESSION_TIME, push);
    BallBody ball = new BallBody();
    ball.kick(2, 0, 0, 1, 0, Ball.GOLF_BALL.radius());
    new BallIntegrator(pushed).advance(ball, 0, rolls, new BallHistory());
    assertThat(ball.y()).isCloseTo(0.5 * 0.7 * 0.02 * rolls * rolls, within(1e-4));
    assertThat(after(pushed, 2, 4, 0.5).y()).isZero();
  }

  /** A curve over x and one over y, as the learned terms over the place have them. */
  private static LearnedTerm overThePlace(fieldcal.effect.learned.Quantity quantity, double scale) {
    Stripes stripes = new Stripes(new Spline(-2, 6, 9, true), new Spline(-2, 6, 9, true));
    LearnedFamily family =
        LearnedFamily.of(quantity, fieldcal.effect.learned.Variable.PLACE, stripes);
    double[] coefficients =
        IntStream.range(0, family.size()).mapToDouble(i -> scale * Math.sin(2.0 * i)).toArray();
    return family.term(coefficients);
  }

  private static BallPhysics with(BallPhysics physics, LearnedTerm term, Quantity... parts) {
    double[] places = grid(-2, 6, 161);
    BallPhysics all = physics;
    for (int c = 0; c < parts.length; c++) {
      int component = c;
      double[] values =
          Arrays.stream(places)
              .flatMap(y -> Arrays.stream(places).map(x -> term.valueAt(component, x, y)))
              .toArray();
      Table table = Table.surface(places, places, values);
      all = all.withExtra(new TabulatedLaw(parts[c], Variable.PLACE, table));
    }
    return all;
  }

  /** Both integrators know the law, each in its own form. */
  private static void isTheSame(BallPhysics physics, List<MotionEffect> effects) {
    double vx = 4 * Math.cos(0.6);
    double vy = 4 * Math.sin(0.6);
    ExtendedTrajectory path =
        ExtendedTrajectory.flat(
            new FlatModel(-3, -0.3, SOLID), MotionEffects.of(effects), 0, 0, 0, 0, vx, vy);
    BallBody ball = new BallBody();
    ball.launch(vx, vy, 0, 0, 0, 0);
    new BallIntegrator(physics).advance(ball, 0, 1.5, new BallHistory());
    BallBody plain = new BallBody();
    plain.launch(vx, vy, 0, 0, 0, 0);
    new BallIntegrator(SOLID_BALL).advance(plain, 0, 1.5, new BallHistory());
    assertThat(path.stateAt(1.5).x()).isCloseTo(ball.x(), within(5e-4));
    assertThat(path.stateAt(1.5).y()).isCloseTo(ball.y(), within(5e-4));
    assertThat(Math.hypot(ball.x() - plain.x(), ball.y() - plain.y())).isGreaterThan(0.01);
  }

  @Test
  void aNapThatDependsOnThePlaceIsTheLearnedTermsNap() {
    LearnedTerm nap = overThePlace(fieldcal.effect.learned.Quantity.NAP, 0.3);
    isTheSame(with(SOLID_BALL, nap, Quantity.NAP_X, Quantity.NAP_Y), List.of((MotionEffect) nap));
  }

  @Test
  void airThatDependsOnThePlaceIsTheLearnedTermsAir() {
    LearnedTerm air = overThePlace(fieldcal.effect.learned.Quantity.AIR, 2);
    BallPhysics draught = SOLID_BALL.withAir(AirLaw.NONE.withDrag(AirDrag.USUAL.cd()));
    isTheSame(
        with(draught, air, Quantity.AIR_X, Quantity.AIR_Y),
        List.of(AirDrag.USUAL, (MotionEffect) air));
  }

  @Test
  void heightsOfTheFloorAreTheLearnedTermsFloor() {
    Spline axis = new Spline(-2, 6, 11, false);
    LearnedFamily family =
        LearnedFamily.of(
            fieldcal.effect.learned.Quantity.FLOOR,
            fieldcal.effect.learned.Variable.PLACE,
            new Surface(axis, axis, false));
    LearnedTerm floor =
        family.term(IntStream.range(0, family.size()).mapToDouble(i -> 8 * Math.sin(i)).toArray());
    isTheSame(with(SOLID_BALL, floor, Quantity.FLOOR), List.of((MotionEffect) floor));
  }
}
