package fieldcal.simulation.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.physics.BallEvent.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The integrated ball against formulas that are written out here, and against conservation laws. */
class BallIntegratorTest {
  /** Half a micrometre: a hundredth of what the design allows. */
  private static final double POSITION = 5e-7;

  private static final double RADIUS = Ball.GOLF_BALL.radius();

  @ParameterizedTest
  @CsvSource({
    "6.5, 0.3, -3.1, -0.28, 0.65",
    "2.0, -2.4, -3.6, -0.22, 0.58",
    "0.5, 3.1, -2.5, -0.40, 0.7143"
  })
  void withoutEffectsAFlatKickObeysTheTwoPhaseLaw(
      double speed, double angle, double accSlide, double accRoll, double kSwitch) {
    BallPhysics physics = BallPhysics.ideal(accSlide, accRoll, kSwitch, 0.75, 0.95, 0.5);
    RecordedTrace trace = kick(physics, speed, angle, 0, 0, 0, 40);

    double switchTime = speed * (kSwitch - 1) / accSlide;
    double switchDistance = speed * switchTime + 0.5 * accSlide * switchTime * switchTime;
    double switchSpeed = kSwitch * speed;
    double restTime = switchTime - switchSpeed / accRoll;
    for (double[] node : trace.nodes) {
      double t = Math.min(node[0], restTime);
      double tau = t - switchTime;
      double expected =
          t < switchTime
              ? speed * t + 0.5 * accSlide * t * t
              : switchDistance + switchSpeed * tau + 0.5 * accRoll * tau * tau;
      assertThat(node[1]).isEqualTo(expected * Math.cos(angle), within(POSITION));
      assertThat(node[2]).isEqualTo(expected * Math.sin(angle), within(POSITION));
    }
    assertThat(trace.first(Kind.SLIDE_TO_ROLL).time()).isEqualTo(switchTime, within(1e-9));
    assertThat(trace.first(Kind.STOP).time()).isEqualTo(restTime, within(1e-8));
    assertThat(trace.events).hasSize(2);
  }

  @ParameterizedTest
  @CsvSource({"2.5, 2.6, 0.75, 0.95, 0.52", "4.6, 4.6, 0.7, 0.87, 0.42", "1.5, 1.9, 0.8, 0.9, 0.6"})
  void withoutEffectsAChipObeysTheFixedLossLaw(
      double speed, double up, double first, double other, double dampingZ) {
    RecordedTrace trace =
        kick(BallPhysics.ideal(-3, -0.28, 0.65, first, other, dampingZ), speed, 0.7, up, 0, 0, 30);

    double t = 0;
    double distance = 0;
    double along = speed;
    double vz = up;
    int n = 0;
    while (n == 0 || vz * vz / (2 * 9.81) >= 0.01) {
      double flight = 2 * vz / 9.81;
      t += flight;
      distance += along * flight;
      BallEvent impact = trace.events.get(n);
      assertThat(impact.time()).isEqualTo(t, within(1e-9));
      assertThat(Math.hypot(impact.x(), impact.y())).isEqualTo(distance, within(POSITION));
      along *= n == 0 ? first : other;
      vz *= dampingZ;
      n++;
    }
    assertThat(trace.count(Kind.BOUNCE)).isEqualTo(n - 1);
    assertThat(trace.count(Kind.LAND)).isEqualTo(1);
    assertThat(trace.count(Kind.SLIDE_TO_ROLL)).isZero();
    BallEvent stop = trace.first(Kind.STOP);
    assertThat(stop.time()).isEqualTo(t + along / 0.28, within(1e-8));
    assertThat(Math.hypot(stop.x(), stop.y()))
        .isEqualTo(distance + along * along / (2 * 0.28), within(POSITION));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.4, 0.55, 2.0 / 3})
  void rollingBeginsWhenMomentumAboutTheContactPointSays(double inertiaFactor) {
    BallPhysics physics =
        BallPhysics.contact(0.32, 0.28, 0.5)
            .withBall(Ball.GOLF_BALL.withInertiaFactor(inertiaFactor));
    BallEvent rolls = kick(physics, 5, 0, 0, 0, 0, 3).first(Kind.SLIDE_TO_ROLL);
    assertThat(rolls.vxAfter()).isEqualTo(5 / (1 + inertiaFactor), within(1e-9));
    assertThat(rolls.time())
        .isEqualTo(5 * inertiaFactor / (1 + inertiaFactor) / (0.32 * 9.81), within(1e-9));
  }

  /** The carpet decides when it rolls; whatever else turns it finds the golf ball that a diagnosis reckons with. Else spin was diagnosed beside contacts on a field where nothing spins. */
  @Test
  void anIdealBallHasTheInertiaOfAGolfBallWheneverItBeginsToRoll() {
    Ball ball = BallPhysics.ideal(-3.1, -0.28, 0.65, 0.75, 0.95, 0.52).ball();
    assertThat(ball.inertiaFactor()).isEqualTo(Ball.GOLF_BALL.inertiaFactor());
    assertThat(ball.kSwitch()).isCloseTo(0.65, within(1e-15));
  }

  @Test
  void aSolidSphereRollsAtFiveSevenths() {
    BallEvent rolls =
        kick(BallPhysics.contact(0.3, 0.28, 0.5), 4.2, 0, 0, 0, 0, 3).first(Kind.SLIDE_TO_ROLL);
    assertThat(rolls.vxAfter() / 4.2).isEqualTo(5.0 / 7, within(1e-10));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, 0.3, 0.9})
  void spinAtTheKickMovesTheSwitchByMomentum(double fraction) {
    BallEvent rolls =
        kick(BallPhysics.contact(0.3, 0.28, 0.5), 4, 0, 0, fraction, 0, 3)
            .first(Kind.SLIDE_TO_ROLL);
    assertThat(rolls.vxAfter()).isEqualTo(4 * (1 + 0.4 * fraction) / 1.4, within(1e-9));
  }

  @Test
  void rollingSpinNeverSlides() {
    RecordedTrace trace = kick(BallPhysics.contact(0.3, 0.28, 0.5), 3, 0.4, 0, 1, 0, 20);
    assertThat(trace.first(Kind.SLIDE_TO_ROLL).time()).isLessThan(1e-9);
    assertThat(trace.first(Kind.STOP).time()).isEqualTo(3 / 0.28, within(1e-6));
  }

  @Test
  void sideSpinCurvesTheSlidingPathOnly() {
    // ω along +x means the contact point slips towards +y, so friction pushes towards −y.
    double fraction = 0.5;
    RecordedTrace trace = kick(BallPhysics.contact(0.3, 0.28, 0.5), 4, 0, 0, 0, fraction, 6);
    BallEvent rolls = trace.first(Kind.SLIDE_TO_ROLL);
    assertThat(rolls.vyAfter()).isEqualTo(-4 * fraction * 0.4 / 1.4, within(1e-9));
    assertThat(rolls.vxAfter()).isEqualTo(4 / 1.4, within(1e-9));
    double slope = rolls.vyAfter() / rolls.vxAfter();
    for (double[] node : trace.nodes) {
      if (node[0] > rolls.time()) {
        assertThat(node[2] - rolls.y()).isEqualTo(slope * (node[1] - rolls.x()), within(POSITION));
      }
    }
  }

  @Test
  void dragOnAFlyingBallApproachesTerminalSpeed() {
    BallPhysics physics = BallPhysics.IDEAL.withAir(AirLaw.NONE.withDrag(0.47));
    BallBody ball = new BallBody();
    ball.launch(0, 0, 1e-3, 0, 0, 0);
    ball.state[2] = 3000;
    new BallIntegrator(physics).advance(ball, 0, 20, BallTrace.NONE);
    double k = 0.5 * 1.2 * 0.47 * Math.PI * RADIUS * RADIUS / 0.046;
    double terminal = Math.sqrt(9.81 / k);
    // From rest: v = v_t·tanh(g·t/v_t); 1 mm/s of upward start speed is 0.1 ms.
    assertThat(-ball.vz())
        .isEqualTo(terminal * Math.tanh(9.81 * (20 - 1e-3 / 9.81) / terminal), within(1e-5));
  }

  @Test
  void dragOnASlidingBallAddsToFriction() {
    double mu = 0.3;
    BallPhysics physics = BallPhysics.contact(mu, 0.28, 0.5).withAir(AirLaw.NONE.withDrag(0.5));
    RecordedTrace trace = kick(physics, 6, 0, 0, 0, 0, 0.3);
    double k = 0.5 * 1.2 * 0.5 * Math.PI * RADIUS * RADIUS / 0.046;
    double a = mu * 9.81;
    // dv/dt = −a − k·v²  →  v = √(a/k)·tan(atan(v0·√(k/a)) − t·√(a·k))
    double expected =
        Math.sqrt(a / k) * Math.tan(Math.atan(6 * Math.sqrt(k / a)) - 0.3 * Math.sqrt(a * k));
    assertThat(trace.last()[4]).isEqualTo(expected, within(1e-9));
  }

  @Test
  void backspinLiftsAndTopspinSinks() {
    BallPhysics physics = BallPhysics.IDEAL.withAir(AirLaw.NONE.withLift(1));
    double plain = firstLanding(BallPhysics.IDEAL, -1);
    assertThat(firstLanding(physics, -1)).isGreaterThan(plain + 1e-3);
    assertThat(firstLanding(physics, 1)).isLessThan(plain - 1e-3);
    assertThat(firstLanding(physics, 0)).isEqualTo(plain);
  }

  @Test
  void aSlopeAcceleratesARollingSphereByFiveSevenths() {
    BallPhysics level = BallPhysics.contact(0.3, 0.28, 0.5);
    BallPhysics tilted = level.withGround(level.ground().withSlope(0.5, Math.PI / 2));
    RecordedTrace trace = kick(tilted, 1e-3, 0, 0, 1, 0, 1e-2);
    RecordedTrace downhill = kick(tilted, 2, Math.PI / 2, 0, 1, 0, 1);
    assertThat(downhill.last()[5]).isEqualTo(2 - 0.28 + 0.005 * 9.81 * 5 / 7, within(1e-9));
    assertThat(trace.first(Kind.STOP).time()).isLessThan(0.01);
  }

  @Test
  void aSteepSlopeSetsARestingBallInMotion() {
    BallPhysics level = BallPhysics.contact(0.3, 0.28, 0.5);
    BallBody ball = new BallBody();
    new BallIntegrator(level.withGround(level.ground().withSlope(10, 0)))
        .advance(ball, 0, 1, BallTrace.NONE);
    assertThat(ball.vx()).isEqualTo(0.981 * 5 / 7 - 0.28, within(1e-9));
    ball.place(0, 0);
    new BallIntegrator(level.withGround(level.ground().withSlope(1, 0)))
        .advance(ball, 0, 1, BallTrace.NONE);
    assertThat(ball.x()).isZero();
    assertThat(ball.phase()).isEqualTo(MotionPhase.RESTING);
  }

  @Test
  void carpetEffectsChangeTheRollingDecelerationAsNamed() {
    GroundLaw base = GroundLaw.uniform(0.3, 0.3);
    assertThat(base.withNap(0.1, 0).rollingDecelerationAt(2, 0, 0)).isEqualTo(0.33, within(1e-12));
    assertThat(base.withNap(0.1, 0).rollingDecelerationAt(-2, 0, 0)).isEqualTo(0.27, within(1e-12));
    assertThat(base.withNap(0.1, 0).rollingDecelerationAt(0, 2, 0)).isEqualTo(0.3, within(1e-12));
    assertThat(base.withSpeedDependentRoll(0.02, 0.01).rollingDecelerationAt(0, 2, 0))
        .isEqualTo(0.3 + 0.04 + 0.04, within(1e-12));
    assertThat(base.withDrift(0.1 / 600).rollingDecelerationAt(1, 0, 600))
        .isEqualTo(0.33, within(1e-12));
  }

  @Test
  void theEdgeOfAWornRegionIsMetExactly() {
    BallPhysics plain = BallPhysics.contact(0.3, 0.28, 0.5);
    BallPhysics worn =
        plain.withGround(plain.ground().withWornRegion(0.5, new Region(1.0003, 90, -1, 1)));
    double v = 3;
    BallEvent stop = kick(worn, v, 0, 0, 1, 0, 60).first(Kind.STOP);
    double edgeSpeedSquared = v * v - 2 * 0.28 * 1.0003;
    assertThat(stop.x()).isEqualTo(1.0003 + edgeSpeedSquared / (2 * 0.42), within(POSITION));
  }

  @Test
  void restitutionFallsWithImpactSpeedAboutTheReference() {
    ImpactLaw law = ImpactLaw.fixedLoss(0.75, 0.95, 0.5).withSpeedSlope(0.1);
    assertThat(law.dampingZ(true, 1.5)).isEqualTo(0.5, within(1e-12));
    assertThat(law.dampingZ(true, 3.5)).isEqualTo(0.4, within(1e-12));
    assertThat(law.dampingZ(true, 0.5)).isEqualTo(0.55, within(1e-12));
  }

  @Test
  void aContactThatSticksSharesMomentumBetweenSpeedAndSpin() {
    BallPhysics physics =
        BallPhysics.contact(0.3, 0.28, 0.5)
            .withImpact(
                ImpactLaw.fixedLoss(1, 1, 0.5).withTangential(new ImpactLaw.Contact(0, 5, 0)));
    BallEvent bounce = kick(physics, 3, 0, 3, 0, 0, 2).first(Kind.BOUNCE);
    assertThat(bounce.vxAfter()).isEqualTo(3 * 5.0 / 7, within(1e-9));
  }

  @Test
  void aSlipperyContactIsLimitedByCoulombFriction() {
    BallPhysics physics =
        BallPhysics.contact(0.3, 0.28, 0.5)
            .withImpact(
                ImpactLaw.fixedLoss(1, 1, 0.5).withTangential(new ImpactLaw.Contact(0, 0.1, 0)));
    BallEvent bounce = kick(physics, 3, 0, 3, 0, 0, 2).first(Kind.BOUNCE);
    assertThat(bounce.vxAfter()).isEqualTo(3 - 0.1 * 1.5 * 3, within(1e-9));
  }

  @Test
  void spinCouplingTakesFromARollingBounce() {
    for (BallPhysics physics :
        new BallPhysics[] {BallPhysics.IDEAL, BallPhysics.contact(0.3, 0.28, 0.5)}) {
      BallPhysics coupled = physics.withImpact(physics.impact().withSpinCoupling(0.2));
      double plain = kick(physics, 3, 0, 3, 0.5, 0, 2).first(Kind.BOUNCE).vxAfter();
      double changed = kick(coupled, 3, 0, 3, 0.5, 0, 2).first(Kind.BOUNCE).vxAfter();
      double without = kick(coupled, 3, 0, 3, 0, 0, 2).first(Kind.BOUNCE).vxAfter();
      assertThat(without).isEqualTo(kick(physics, 3, 0, 3, 0, 0, 2).first(Kind.BOUNCE).vxAfter());
      assertThat(Math.abs(changed - plain)).isGreaterThan(0.01);
    }
    BallPhysics coupled =
        BallPhysics.IDEAL.withImpact(BallPhysics.IDEAL.impact().withSpinCoupling(0.2));
    assertThat(kick(coupled, 3, 0, 3, 0.5, 0, 2).first(Kind.BOUNCE).vxAfter())
        .isEqualTo(3 * (0.75 - 0.2 * 0.5 + 0.25 * 0.5), within(1e-9));
  }

  @Test
  void energyNeverGrows() {
    BallPhysics physics =
        BallPhysics.contact(0.3, 0.28, 0.6).withAir(new AirLaw(0.45, 0.5, 1.2, 0.05));
    for (double spin : new double[] {-1.5, -0.4, 0, 0.7, 2}) {
      RecordedTrace trace = kick(physics, 4, 0.3, 4, spin, 0.3, 20);
      double last = Double.POSITIVE_INFINITY;
      for (double[] n : trace.nodes) {
        double kinetic = n[4] * n[4] + n[5] * n[5] + n[6] * n[6];
        double turning = 0.4 * RADIUS * RADIUS * (n[7] * n[7] + n[8] * n[8] + n[9] * n[9]);
        double energy = 0.5 * (kinetic + turning) + 9.81 * n[3];
        assertThat(energy).as("t=%s spin=%s", n[0], spin).isLessThanOrEqualTo(last + 1e-9);
        last = energy;
      }
      assertThat(last).isZero();
    }
  }

  @Test
  void rotatedKicksGiveRotatedPaths() {
    BallPhysics physics =
        BallPhysics.contact(0.3, 0.28, 0.6).withAir(new AirLaw(0.45, 0.5, 1.2, 0.05));
    double[] a = kick(physics, 4, 0, 3, -0.4, 0.3, 3).last();
    double[] b = kick(physics, 4, 1, 3, -0.4, 0.3, 3).last();
    assertThat(b[1]).isEqualTo(a[1] * Math.cos(1) - a[2] * Math.sin(1), within(1e-9));
    assertThat(b[2]).isEqualTo(a[1] * Math.sin(1) + a[2] * Math.cos(1), within(1e-9));
  }

  @Test
  void theResultDoesNotDependOnHowTimeIsCut() {
    BallPhysics physics =
        BallPhysics.contact(0.3, 0.28, 0.6).withAir(new AirLaw(0.45, 0.5, 1.2, 0));
    BallBody whole = new BallBody();
    whole.kick(4, 1, 3, -0.4, 0.3, RADIUS);
    BallBody cut = new BallBody();
    cut.kick(4, 1, 3, -0.4, 0.3, RADIUS);
    BallIntegrator integrator = new BallIntegrator(physics);
    integrator.advance(whole, 0, 2.1, BallTrace.NONE);
    for (int i = 0; i < 3000; i++) {
      integrator.advance(cut, i * 0.0007, (i + 1) * 0.0007, BallTrace.NONE);
    }
    assertThat(cut.x()).isEqualTo(whole.x(), within(1e-8));
    assertThat(cut.y()).isEqualTo(whole.y(), within(1e-8));
  }

  private static double firstLanding(BallPhysics physics, double fraction) {
    RecordedTrace trace = kick(physics, 4, 0, 4, fraction, 0, 2);
    return trace.first(Kind.BOUNCE).time();
  }

  static RecordedTrace kick(
      BallPhysics physics,
      double speed,
      double angle,
      double up,
      double rollFraction,
      double sideFraction,
      double duration) {
    BallBody ball = new BallBody();
    double radius = physics.ball().radius();
    ball.kick(
        speed * Math.cos(angle), speed * Math.sin(angle), up, rollFraction, sideFraction, radius);
    RecordedTrace trace = new RecordedTrace();
    new BallIntegrator(physics).advance(ball, 0, duration, trace);
    return trace;
  }
}
