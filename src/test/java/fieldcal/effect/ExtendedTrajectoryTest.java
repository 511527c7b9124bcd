package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.ball.Phase;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.WornRegion;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ExtendedTrajectoryTest {
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.95, 0.52, -0.28);

  /** The design's limit is 0.05 mm; a millionth of it remains of exact steps. */
  private static final double SAME = 1e-9;

  /** Effects too weak to be seen that force the integrator to make its many small steps. */
  private static final MotionEffects FAINT =
      MotionEffects.of(List.of(new AirDrag(1e-9), new FieldSlope(1e-10, 1)));

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void withoutEffectsItIsTheClosedForm(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < 100; i++) {
      double t0 = 10 * random.nextDouble();
      double vx = 12 * (random.nextDouble() - 0.5);
      double vy = 12 * (random.nextDouble() - 0.5);
      double vz = 5 * random.nextDouble();
      FlatTrajectory flat = FlatTrajectory.fromKick(FLAT, t0, 1, 2, vx, vy);
      ChipTrajectory chip = ChipTrajectory.fromKick(CHIP, t0, 1, 2, vx, vy, vz);
      for (MotionEffects effects : List.of(MotionEffects.NONE, FAINT)) {
        double limit = effects == FAINT ? 1e-6 : SAME;
        same(flat, ExtendedTrajectory.flat(FLAT, effects, 0, t0, 1, 2, vx, vy), limit);
        ExtendedTrajectory extended =
            ExtendedTrajectory.chip(CHIP, FLAT, effects, 0, t0, 1, 2, vx, vy, vz);
        assertThat(extended.flights()).isEqualTo(chip.hops());
        same(chip, extended, limit);
        same(
            ChipTrajectory.fromKickWithHops(CHIP, t0, 1, 2, vx, vy, vz, 3),
            ExtendedTrajectory.chipWithHops(CHIP, FLAT, effects, 0, t0, 1, 2, vx, vy, vz, 3),
            limit);
      }
    }
  }

  @Test
  void spinAtTheKickIsTheClosedFormsToo() {
    MotionEffects spun = MotionEffects.of(List.of(new KickSpin(-0.4), new SideSpin(0.3)));
    double vx = 3;
    double vy = 2;
    same(
        FlatTrajectory.fromKickWithSpin(
            FLAT, 5, 1, 2, vx, vy, -0.4 * vx + 0.3 * vy, -0.4 * vy - 0.3 * vx),
        ExtendedTrajectory.flat(FLAT, spun, 0, 5, 1, 2, vx, vy),
        1e-7);
  }

  @Test
  void backspinThatPullsTheBallBackIsFollowed() {
    MotionEffects spun = MotionEffects.of(List.of(new KickSpin(-4)));
    BallTrajectory exact = FlatTrajectory.fromKickWithSpin(FLAT, 0, 0, 0, 2, 0, -8, 0);
    BallTrajectory path = ExtendedTrajectory.flat(FLAT, spun, 0, 0, 0, 0, 2, 0);
    assertThat(path.stateAt(path.restTime()).x()).isLessThan(0);
    assertThat(path.restDistance()).isEqualTo(exact.restDistance(), within(1e-3));
  }

  @Test
  void timesAndDistancesAnswerEachOther() {
    MotionEffects effects =
        MotionEffects.of(
            List.of(new AirDrag(0.5), new FieldSlope(0.4, 2), new WornRegion(0.5, 1, 2, -9, 9)));
    ExtendedTrajectory path = ExtendedTrajectory.flat(FLAT, effects, 0, 3, 0, 0, 5, 2);
    for (double d = 0; d < path.restDistance(); d += 0.05) {
      double t = path.timeAtDistance(d).orElseThrow();
      assertThat(path.distanceAt(t)).isEqualTo(d, within(1e-8));
    }
    assertThat(path.timeAtDistance(path.restDistance() + 1e-6)).isEmpty();
    assertThat(path.speedAtDistance(0).orElseThrow()).isEqualTo(Math.hypot(5, 2), within(1e-9));
  }

  @Test
  void restsBeforeAndAfter() {
    ExtendedTrajectory path = ExtendedTrajectory.flat(FLAT, FAINT, 0, 3, 1, 2, 1, 0);
    assertThat(path.phaseAt(2.999)).isEqualTo(Phase.RESTING_BEFORE_KICK);
    assertThat(path.phaseAt(3)).isEqualTo(Phase.SLIDING);
    assertThat(path.phaseAt(path.restTime())).isEqualTo(Phase.STOPPED);
    assertThat(path.stateAt(Double.NEGATIVE_INFINITY).x()).isEqualTo(1);
    assertThat(path.stateAt(Double.POSITIVE_INFINITY).x())
        .isEqualTo(path.stateAt(path.restTime()).x());
    assertThat(ExtendedTrajectory.flat(FLAT, FAINT, 0, 3, 1, 2, 0, 0).restTime()).isEqualTo(3);
  }

  @Test
  void aSlopeTooSteepToHoldEndsInTime() {
    MotionEffects steep = MotionEffects.of(List.of(new FieldSlope(6, 0), new CarpetNap(0.1, 0)));
    ExtendedTrajectory path = ExtendedTrajectory.flat(FLAT, steep, 0, 0, 0, 0, -2, 0);
    assertThat(path.restTime()).isEqualTo(ExtendedTrajectory.MAX_DURATION, within(1e-6));
    assertThat(path.stateAt(path.restTime()).x()).isGreaterThan(1);
  }

  @Test
  void asFarAsItIsWantedAPathIsTheWhole() {
    MotionEffects effects = MotionEffects.of(List.of(new AirDrag(0.5), new FieldSlope(0.4, 2)));
    ExtendedTrajectory flat = ExtendedTrajectory.flat(FLAT, effects, 0, 3, 0, 0, 5, 2);
    ExtendedTrajectory chip =
        ExtendedTrajectory.chipWithHops(CHIP, FLAT, effects, 0, 3, 0, 0, 3, 2, 3, 4);
    for (double until : new double[] {2, 3, 3.1, 3.8, 4.7, 6, 1e3}) {
      isPartOf(flat, ExtendedTrajectory.flat(FLAT, effects, 0, 3, 0, 0, 5, 2, until), until);
      isPartOf(
          chip,
          ExtendedTrajectory.chipWithHops(CHIP, FLAT, effects, 0, 3, 0, 0, 3, 2, 3, 4, until),
          until);
    }
    assertThat(ExtendedTrajectory.flat(FLAT, effects, 0, 3, 0, 0, 5, 2, 3.5).restTime())
        .isLessThan(flat.restTime());
  }

  private static void isPartOf(BallTrajectory whole, BallTrajectory part, double until) {
    for (double t = 2.5; t <= Math.min(until, whole.restTime()); t += 0.01) {
      assertThat(part.stateAt(t)).isEqualTo(whole.stateAt(t));
    }
  }

  @Test
  void flightsAreCountedWithoutTheRestOfTheWay() {
    for (double vz = 0; vz < 6; vz += 0.1) {
      assertThat(ExtendedTrajectory.flightsByRule(CHIP, FAINT, 0, 3, 1, 2, 2, 1, vz))
          .isEqualTo(ExtendedTrajectory.chip(CHIP, FLAT, FAINT, 0, 3, 1, 2, 2, 1, vz).flights());
    }
  }

  @Test
  void nonsenseIsRefused() {
    assertThatThrownBy(() -> ExtendedTrajectory.flat(FLAT, FAINT, 0, Double.NaN, 0, 0, 1, 0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> ExtendedTrajectory.chip(CHIP, FLAT, FAINT, 0, 0, 0, 0, 1, 0, -1))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(
            () -> ExtendedTrajectory.flat(FLAT, FAINT, 0, 0, 0, 0, 1, 0).stateAt(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> ExtendedTrajectory.flat(FLAT, FAINT, 0, 0, 0, 0, 1, 0, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private static void same(BallTrajectory exact, BallTrajectory path, double limit) {
    assertThat(path.restTime()).isEqualTo(exact.restTime(), within(100 * limit));
    assertThat(path.restDistance()).isEqualTo(exact.restDistance(), within(1e-6 + limit));
    double[] a = new double[3];
    double[] b = new double[3];
    double end = exact.restTime() + 0.3;
    for (double t = exact.kickTime() - 0.1; t < end; t += 0.0317) {
      exact.positionAt(t, a);
      path.positionAt(t, b);
      assertThat(b).containsExactly(a, within(limit));
    }
  }
}
