package fieldcal.simulation.physics;

import static fieldcal.simulation.physics.BallIntegratorTest.kick;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.physics.BallEvent.Kind;
import fieldcal.simulation.physics.ImpactLaw.Contact;
import fieldcal.simulation.physics.ImpactLaw.FixedLoss;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Spin at impacts: against recursions that are written out here, and against conservation laws. */
class ContactTest {
  private static final double RADIUS = Ball.GOLF_BALL.radius();
  private static final double EXACT = 1e-9;

  private static BallPhysics contact(double reversed, double friction, double inertiaFactor) {
    return BallPhysics.contact(0.32, 0.28, 0.52)
        .withBall(Ball.GOLF_BALL.withInertiaFactor(inertiaFactor))
        .withImpact(
            ImpactLaw.fixedLoss(0.75, 0.95, 0.52)
                .withTangential(new Contact(reversed, friction, 0)));
  }

  private static BallPhysics fixed(double first, double other) {
    return BallPhysics.ideal(-3.1, -0.28, 1 / 1.4, first, other, 0.52);
  }

  private static List<BallEvent> impacts(RecordedTrace trace) {
    return trace.events.stream()
        .filter(e -> e.kind() == Kind.BOUNCE || e.kind() == Kind.LAND)
        .toList();
  }

  private static double ratio(BallEvent e) {
    return Math.hypot(e.vxAfter(), e.vyAfter()) / Math.hypot(e.vxBefore(), e.vyBefore());
  }

  /** State before and after each impact: two nodes of one time. */
  private static List<double[][]> jumps(RecordedTrace trace) {
    List<double[][]> jumps = new ArrayList<>();
    for (int i = 1; i < trace.nodes.size(); i++) {
      double[] a = trace.nodes.get(i - 1);
      double[] b = trace.nodes.get(i);
      if (a[0] == b[0] && a[6] < 0) {
        jumps.add(new double[][] {a, b});
      }
    }
    return jumps;
  }

  /** DESIGN: 0.76, 0.91, 0.975, 0.993 in engines that integrate the contact. */
  @Test
  void dampingRisesFromHopToHop() {
    double beta = 0.505;
    double share = 0.24;
    double reversed = share * (1 + beta) / beta - 1;
    List<BallEvent> impacts = impacts(kick(contact(reversed, 5, beta), 3.6, 0.4, 3.6, 0, 0, 6));
    assertThat(ratio(impacts.get(0))).isEqualTo(0.76, within(EXACT));
    assertThat(ratio(impacts.get(1))).isEqualTo(0.91, within(0.005));
    assertThat(ratio(impacts.get(2))).isEqualTo(0.975, within(0.005));
    assertThat(ratio(impacts.get(3))).isEqualTo(0.993, within(0.005));
    double v = 1;
    double w = 0;
    for (BallEvent impact : impacts) {
      double change = share * (v - w);
      assertThat(ratio(impact)).isEqualTo(1 - change / v, within(EXACT));
      v -= change;
      w += change / beta;
    }
  }

  /** The impulse acts at the contact point, so the angular momentum about it stays. */
  @ParameterizedTest
  @CsvSource({"-0.1, 0.35, 0, 0", "0.2, 5, -0.5, 0.3", "-0.3, 0.1, 0.7, -0.4", "0, 0.2, -2, 0"})
  void angularMomentumAboutTheContactPointStays(
      double reversed, double friction, double roll, double side) {
    RecordedTrace trace = kick(contact(reversed, friction, 0.4), 3, 0.7, 3.5, roll, side, 3);
    assertThat(jumps(trace)).hasSizeGreaterThan(2);
    for (double[][] jump : jumps(trace)) {
      double[] a = jump[0];
      double[] b = jump[1];
      assertThat(b[4] + 0.4 * RADIUS * b[8]).isEqualTo(a[4] + 0.4 * RADIUS * a[8], within(EXACT));
      assertThat(b[5] - 0.4 * RADIUS * b[7]).isEqualTo(a[5] - 0.4 * RADIUS * a[7], within(EXACT));
      assertThat(b[9]).isEqualTo(a[9]);
    }
  }

  @Test
  void thePartOfTheSlipThatIsReversedIsAsNamed() {
    RecordedTrace trace = kick(contact(0.3, 5, 0.4), 3, 0, 3, -0.5, 0.2, 1);
    double[][] jump = jumps(trace).get(0);
    double before = jump[0][4] - RADIUS * jump[0][8];
    double after = jump[1][4] - RADIUS * jump[1][8];
    assertThat(after).isEqualTo(-0.3 * before, within(EXACT));
    double aside = jump[0][5] + RADIUS * jump[0][7];
    assertThat(jump[1][5] + RADIUS * jump[1][7]).isEqualTo(-0.3 * aside, within(EXACT));
  }

  /** The slip of a ball with topspin then grows until it turns no more; friction takes the same all the time. */
  @Test
  void aResistanceStrongerThanFrictionStopsTheTurning() {
    BallPhysics physics =
        BallPhysics.contact(0.32, 0.28, 0.5)
            .withImpact(
                ImpactLaw.fixedLoss(0.75, 0.95, 0.5)
                    .withTangential(new Contact(0, 0.02, 0, 0, 0.5)));
    double[][] jump = jumps(kick(physics, 3, 0, 3, 0.5, 0, 1)).get(0);
    assertThat(jump[1][4]).isEqualTo(jump[0][4] + 0.02 * 1.5 * jump[0][6], within(EXACT));
    assertThat(jump[0][8]).isGreaterThan(60);
    assertThat(RADIUS * jump[1][8]).isEqualTo(0, within(1e-6));
  }

  @Test
  void frictionLimitsTheImpulse() {
    RecordedTrace trace = kick(contact(0, 0.1, 0.4), 3, 0, 3, -3, 1, 1);
    double[][] jump = jumps(trace).get(0);
    double change = Math.hypot(jump[1][4] - jump[0][4], jump[1][5] - jump[0][5]);
    assertThat(change).isEqualTo(0.1 * 1.52 * -jump[0][6], within(EXACT));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.6, -0.1, 0.4, 1.3})
  void givenSpinMeetsAFixedDampingAsAContactOfThatDamping(double roll) {
    double first = 0.72;
    double reversed = (1 - first) * 1.4 / 0.4 - 1;
    double[][] law = jumps(kick(fixed(first, 0.9), 3, 0.3, 3, roll, 0.2, 1)).get(0);
    double[][] touch = jumps(kick(contact(reversed, 5, 0.4), 3, 0.3, 3, roll, 0.2, 1)).get(0);
    assertThat(law[1][4]).isEqualTo(touch[1][4], within(EXACT));
    assertThat(law[1][5]).isEqualTo(touch[1][5], within(EXACT));
    double along = Math.cos(0.3) * law[1][4] + Math.sin(0.3) * law[1][5];
    assertThat(along).isEqualTo(3 * (first + (1 - first) * roll), within(EXACT));
  }

  @Test
  void withoutSpinTheFixedDampingHoldsExactlyHoweverSlipperyTheCarpetIs() {
    BallPhysics physics = fixed(0.7, 0.93);
    BallPhysics ice = physics.withGround(GroundLaw.uniform(0.01, 0.28));
    for (BallPhysics p : List.of(physics, ice)) {
      List<BallEvent> impacts = impacts(kick(p, 4, 1.1, 2, 0, 0, 9));
      assertThat(ratio(impacts.get(0))).isEqualTo(0.7, within(1e-12));
      for (BallEvent later : impacts.subList(1, impacts.size())) {
        assertThat(ratio(later)).isEqualTo(0.93, within(1e-12));
      }
    }
    // With spin the carpet's friction limits what the spin adds.
    double[][] jump = jumps(kick(ice, 1, 0, 4, 3, 0, 1)).get(0);
    double lost = 0.3 * 1;
    double limit = Math.max(lost, 0.01 * 1.52 * 4);
    assertThat(jump[1][4] - jump[0][4]).isEqualTo(limit, within(EXACT));
  }

  @Test
  void givenSpinFadesFromImpactToImpact() {
    List<BallEvent> plain = impacts(kick(fixed(0.75, 0.95), 3, 0, 3.5, 0, 0, 6));
    List<BallEvent> spun = impacts(kick(fixed(0.75, 0.95), 3, 0, 3.5, -0.5, 0, 6));
    double u = 0;
    double w = -0.5 * 3;
    for (int i = 0; i < plain.size(); i++) {
      double damping = i == 0 ? 0.75 : 0.95;
      BallEvent e = spun.get(i);
      double slip = u - w;
      double without = damping * (e.vxBefore() - u);
      assertThat(without).isEqualTo(plain.get(i).vxAfter(), within(EXACT));
      u -= 0.25 * slip;
      w += 0.25 * slip / 0.4;
      assertThat(e.vxAfter()).isEqualTo(without + u, within(EXACT));
      assertThat(e.time()).isEqualTo(plain.get(i).time(), within(EXACT));
    }
  }

  @Test
  void sideSpinTurnsTheBounce() {
    // ω along +x: the contact point slips towards +y, so friction pushes towards −y.
    for (BallPhysics physics : List.of(fixed(0.75, 0.95), contact(-0.1, 5, 0.4))) {
      BallEvent bounce = kick(physics, 3, 0, 3, 0, 0.4, 1).first(Kind.BOUNCE);
      assertThat(bounce.vyBefore()).isZero();
      assertThat(bounce.vyAfter()).isLessThan(-0.2);
    }
  }

  @Test
  void aContactWithoutSpinLeftSlidesOnlyUntilItRolls() {
    RecordedTrace trace = kick(contact(-0.1, 0.35, 0.4), 3, 0, 3.5, 0, 0, 8);
    BallEvent land = trace.first(Kind.LAND);
    BallEvent rolls = trace.first(Kind.SLIDE_TO_ROLL);
    assertThat(rolls.time() - land.time()).isBetween(0.0, 0.05);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1.2, -0.4, 0, 0.6, 1})
  void energyNeverGrows(double spin) {
    for (BallPhysics physics :
        List.of(fixed(0.75, 0.95), contact(-0.1, 0.35, 0.4), contact(1, 0.2, 0.4))) {
      double last = Double.POSITIVE_INFINITY;
      for (double[] n : kick(physics, 3.5, 0.3, 3.5, spin, 0.3, 20).nodes) {
        double kinetic = n[4] * n[4] + n[5] * n[5] + n[6] * n[6];
        double turning = 0.4 * RADIUS * RADIUS * (n[7] * n[7] + n[8] * n[8] + n[9] * n[9]);
        double energy = 0.5 * (kinetic + turning) + 9.81 * n[3];
        assertThat(energy).as("t=%s of %s", n[0], physics).isLessThanOrEqualTo(last + EXACT);
        last = energy;
      }
      assertThat(last).isZero();
    }
  }

  @Test
  void magnusActsInFlightOnTheSpinThatImpactsMade() {
    BallPhysics spins = contact(-0.1, 0.35, 0.4);
    BallPhysics lifted = spins.withAir(AirLaw.NONE.withLift(1));
    List<BallEvent> plain = impacts(kick(spins, 3, 0, 3.5, 0, 0, 3));
    List<BallEvent> sunk = impacts(kick(lifted, 3, 0, 3.5, 0, 0, 3));
    assertThat(sunk.get(0).time()).isEqualTo(plain.get(0).time(), within(EXACT));
    // After it the ball has topspin, which pulls it down.
    assertThat(sunk.get(1).time()).isLessThan(plain.get(1).time() - 1e-3);
    // Backspin lifts the first hop and survives the flight.
    RecordedTrace back = kick(lifted, 3, 0, 3.5, -0.5, 0, 1);
    assertThat(impacts(back).get(0).time()).isGreaterThan(plain.get(0).time() + 1e-3);
    double[][] jump = jumps(back).get(0);
    assertThat(RADIUS * jump[0][8]).isEqualTo(-1.5, within(EXACT));
    assertThat(((Contact) lifted.impact().tangential()).loss()).isZero();
    assertThat(fixed(0.7, 0.9).impact().tangential()).isEqualTo(new FixedLoss(0.7, 0.9));
  }
}
