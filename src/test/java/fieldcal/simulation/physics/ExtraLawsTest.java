package fieldcal.simulation.physics;

import static fieldcal.simulation.physics.BallIntegratorTest.kick;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.physics.BallEvent.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Slope in flight, wind, seams, another ball and causes without a name, against solutions that are written out here. */
class ExtraLawsTest {
  private static final double EXACT = 1e-9;
  private static final double POSITION = 1e-6;
  private static final double ROLL = 0.28;
  private static final BallPhysics PLAIN = BallPhysics.contact(0.32, ROLL, 0.52);

  private static RecordedTrace roll(BallPhysics physics, double speed, double angle) {
    return kick(physics, speed, angle, 0, 1, 0, 60);
  }

  private static double way(BallEvent stop) {
    return Math.hypot(stop.x(), stop.y());
  }

  @Test
  void aTiltedFieldPullsInFlight() {
    BallPhysics tilted = PLAIN.withGround(PLAIN.ground().withSlope(1, 2));
    BallEvent impact = kick(tilted, 3, 0, 3.5, 0, 0, 2).first(Kind.BOUNCE);
    double t = 2 * 3.5 / 9.81;
    double fall = 0.5 * 0.0981 * t * t;
    assertThat(impact.time()).isEqualTo(t, within(EXACT));
    assertThat(impact.x()).isEqualTo(3 * t + fall * Math.cos(2), within(EXACT));
    assertThat(impact.y()).isEqualTo(fall * Math.sin(2), within(EXACT));
    assertThat(impact.vyBefore()).isEqualTo(0.0981 * t * Math.sin(2), within(EXACT));
  }

  @Test
  void dragActsOnTheVelocityRelativeToTheAir() {
    AirLaw air = AirLaw.NONE.withDrag(0.45);
    double k = 0.5 * 1.2 * 0.45 * Math.PI * 0.0215 * 0.0215 / 0.046;
    // Nothing drags a ball that flies with the wind but its fall.
    BallPhysics with = PLAIN.withAir(air.withWind(3, 0));
    RecordedTrace carried = kick(with, 3, 0, 1e-6, 0, 0, 1e-7);
    assertThat(carried.last()[4]).isEqualTo(3, within(1e-12));
    // Slow sliding in a head wind of 4 m/s: a = −μg − k·(v + 4)², solved as for no wind.
    BallPhysics against = PLAIN.withAir(air.withWind(-4, 0));
    double a = 0.32 * 9.81;
    double root = Math.sqrt(a / k);
    double expected = root * Math.tan(Math.atan(9 / root) - 0.3 * Math.sqrt(a * k)) - 4;
    assertThat(kick(against, 5, 0, 0, 0, 0, 0.3).last()[4]).isEqualTo(expected, within(EXACT));
    assertThat(PLAIN.withAir(AirLaw.NONE.withWind(5, 5)).air().windY()).isEqualTo(5);
    assertThat(kick(PLAIN.withAir(AirLaw.NONE.withWind(5, 5)), 5, 0, 0, 0, 0, 2).last())
        .containsExactly(kick(PLAIN, 5, 0, 0, 0, 0, 2).last());
  }

  @Test
  void aSeamTakesSpeedAcrossItAndTurnsThePath() {
    double turn = 0.01;
    BallPhysics seam = PLAIN.withSeam(new Seam(0.1, turn, 0, 1.2));
    RecordedTrace trace = roll(seam, 2, 0);
    BallEvent crossing = trace.first(Kind.SEAM);
    double speed = Math.sqrt(4 - 2 * ROLL * 1.2);
    assertThat(crossing.x()).isEqualTo(1.2, within(EXACT));
    assertThat(Math.hypot(crossing.vxAfter(), crossing.vyAfter()))
        .isEqualTo(0.9 * speed, within(POSITION));
    double rest = 0.81 * speed * speed / (2 * ROLL);
    BallEvent stop = trace.first(Kind.STOP);
    assertThat(stop.x()).isEqualTo(1.2 + rest * Math.cos(turn), within(POSITION));
    assertThat(stop.y()).isEqualTo(rest * Math.sin(turn), within(POSITION));
    assertThat(trace.count(Kind.SEAM)).isEqualTo(1);
    assertThat(trace.count(Kind.SLIDE_TO_ROLL)).isEqualTo(1);
  }

  @Test
  void aSeamIsCrossedAtAnAngleAndWhileSliding() {
    // Only the part across the line, which lies along x at y = 0.5, is reduced.
    BallPhysics seam = PLAIN.withSeam(new Seam(0.2, 0, Math.PI / 2, 0.5));
    BallEvent crossing = kick(seam, 4, 0.6, 0, 0, 0, 2).first(Kind.SEAM);
    assertThat(crossing.y()).isEqualTo(0.5, within(EXACT));
    assertThat(crossing.vxAfter()).isEqualTo(crossing.vxBefore(), within(EXACT));
    assertThat(crossing.vyAfter()).isEqualTo(0.8 * crossing.vyBefore(), within(EXACT));
    // A ball that flies over it does not notice.
    assertThat(kick(seam, 4, 0.6, 3, 0, 0, 0.55).count(Kind.SEAM)).isZero();
  }

  @Test
  void anotherBallRollsDifferentlyFromTheNextKickOn() {
    BallPhysics later = PLAIN.withExtra(new BallChange(0.5, 0.2, 2));
    assertThat(way(roll(later, 3, 0.4).first(Kind.STOP))).isEqualTo(9 / (2 * ROLL), within(EXACT));
    BallPhysics before = PLAIN.withExtra(new BallChange(0.5, 0.2, -1));
    assertThat(way(roll(before, 3, 0.4).first(Kind.STOP)))
        .isEqualTo(9 / (2 * 1.5 * ROLL), within(EXACT));
    double speed = kick(before, 5, 0, 0, 0, 0, 0.2).last()[4];
    assertThat(speed).isEqualTo(5 - 1.2 * 0.32 * 9.81 * 0.2, within(EXACT));
  }

  @Test
  void slidingFrictionDependsOnTheSlipAboutTwoMetresPerSecond() {
    BallPhysics slope = PLAIN.withGround(PLAIN.ground().withSlipSlope(0.15));
    double a = 0.32 * 9.81;
    // du/dt = −a·(1+1/β)·(1 + k(u − 2)), so 1 + k(u − 2) decays exponentially.
    double rate = a * 3.5 * 0.15;
    double factor = (1 + 0.15 * 3) * Math.exp(-rate * 0.2);
    double slip = 2 + (factor - 1) / 0.15;
    assertThat(kick(slope, 5, 0, 0, 0, 0, 0.2).last()[4])
        .isEqualTo(5 - (5 - slip) / 3.5, within(1e-7));
  }

  @Test
  void restitutionByPlace() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.RestitutionByPlace(0.1, 0));
    BallEvent impact = kick(p, 3, 0, 3, 0, 0, 2).first(Kind.BOUNCE);
    assertThat(impact.vzAfter())
        .isEqualTo(0.52 * 3 * (1 + 0.1 * Math.tanh(impact.x())), within(EXACT));
  }

  @Test
  void aBumpInRollingResistance() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.RollBump(0.5, 2, 0.3));
    double[] at = kick(p, 2, 0, 0, 1, 0, 1e-4).last();
    assertThat((2 - at[4]) / 1e-4).isEqualTo(1.5 * ROLL, within(1e-6));
    double[] slow = kick(p, 0.3, 0, 0, 1, 0, 1e-4).last();
    assertThat((0.3 - slow[4]) / 1e-4).isEqualTo(ROLL, within(1e-6));
  }

  @Test
  void frictionThatFadesAfterTheKick() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.FadingFriction(0.3, 0.2));
    double lost = 0.32 * 9.81 * (0.3 + 0.3 * 0.2 * (1 - Math.exp(-1.5)));
    assertThat(kick(p, 6, 0, 0, 0, 0, 0.3).last()[4]).isEqualTo(6 - lost, within(EXACT));
  }

  @Test
  void aRoughRingTakesEnergyByItsWidth() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.Ring(0.4, 1, 1.5));
    double way = 9 / (2 * ROLL) - 0.4 * 0.5;
    assertThat(way(roll(p, 3, 1).first(Kind.STOP))).isEqualTo(way, within(POSITION));
  }

  @Test
  void resistanceOncePerTurn() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.OncePerTurn(0.9, 0.0215));
    for (double[] n : kick(p, 3, 0, 0, 1, 0, 2).nodes) {
      double work = n[1] + 0.9 * 0.0215 * Math.sin(n[1] / 0.0215);
      assertThat(n[4] * n[4]).isEqualTo(9 - 2 * ROLL * work, within(1e-6));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Math.PI / 2, -Math.PI / 4, 2})
  void friction4Fold(double heading) {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.FourWays(0.2, 0));
    double factor = 1 + 0.2 * Math.cos(4 * heading);
    assertThat(way(roll(p, 2, heading).first(Kind.STOP)))
        .isEqualTo(4 / (2 * ROLL * factor), within(POSITION));
  }

  @Test
  void hardImpactsCostMoreAlongTheCarpet() {
    BallPhysics fixed = BallPhysics.ideal(-3, -ROLL, 0.65, 0.75, 0.95, 0.52);
    BallPhysics p = fixed.withExtra(new UnnamedCause.LossByImpactSpeed(0.05));
    BallEvent impact = kick(p, 3, 0, 4, 0, 0, 2).first(Kind.BOUNCE);
    assertThat(impact.vxAfter()).isEqualTo(3 * 0.75 * (1 - 0.05 * 2), within(EXACT));
  }

  @Test
  void aSideForceTurnsTheVelocity() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.SideForce(0.1));
    double[] flying = kick(p, 3, 0, 4, 0, 0, 0.5).last();
    assertThat(Math.atan2(flying[5], flying[4])).isEqualTo(0.05, within(EXACT));
    assertThat(Math.hypot(flying[4], flying[5])).isEqualTo(3, within(EXACT));
    double[] rolling = kick(p, 3, 0, 0, 1, 0, 0.5).last();
    assertThat(Math.atan2(rolling[5], rolling[4])).isEqualTo(0.05 / 1.4, within(EXACT));
  }

  @Test
  void patchesOnlyHoldBack() {
    BallPhysics p = PLAIN.withExtra(new UnnamedCause.Patches(2, 0.8));
    assertThat(way(roll(p, 2, 0).first(Kind.STOP))).isLessThan(4 / (2 * ROLL) - 0.5);
  }
}
