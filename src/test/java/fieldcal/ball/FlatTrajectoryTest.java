package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class FlatTrajectoryTest {
  /** Round numbers for hand calculation: slides 4 → 2 m/s within 0.5 s and 1.5 m, rolls 4 s and 4 m. */
  private static final FlatModel ROUND = new FlatModel(-4, -0.5, 0.5);

  /** Fourth-order steps of 1 ms over sliding and rolling, events located to 1e-13 s: errors of rounding only. */
  private static final double INTEGRATION = 1e-9;

  /** Same path, computed from different numbers. */
  private static final double SAME = 1e-10;

  private static double[] turned(double[] n, double angle) {
    double[] result = n.clone();
    for (int i = 0; i < 4; i += 2) {
      result[i] = Math.cos(angle) * n[i] - Math.sin(angle) * n[i + 1];
      result[i + 1] = Math.sin(angle) * n[i] + Math.cos(angle) * n[i + 1];
    }
    return result;
  }

  private static List<Double> changes(BallTrajectory path) {
    return List.of(path.kickTime(), ((FlatTrajectory) path).tSwitch(), path.restTime());
  }

  @Nested
  class OfAKickWithoutSpin extends BallTrajectoryContract {
    @Override
    BallTrajectory random(RandomKicks kicks, double rotation, double delay) {
      double[] numbers = turned(kicks.flatNumbers(), rotation);
      numbers[4] += delay;
      return RandomKicks.flat(numbers);
    }

    @Override
    List<Double> phaseChanges(BallTrajectory path) {
      return changes(path);
    }
  }

  @Nested
  class OfAKickWithSpin extends BallTrajectoryContract {
    @Override
    BallTrajectory random(RandomKicks kicks, double rotation, double delay) {
      double[] n = turned(kicks.flatNumbers(), rotation);
      double[] spin = {0, 0, kicks.uniform(-5, 5), kicks.uniform(-5, 5)};
      double[] s = turned(spin, rotation);
      FlatModel model = new FlatModel(n[5], n[6], n[7]);
      return FlatTrajectory.fromKickWithSpin(
          model, n[4] + delay, n[0], n[1], n[2], n[3], s[2], s[3]);
    }

    @Override
    List<Double> phaseChanges(BallTrajectory path) {
      return changes(path);
    }
  }

  @Test
  void calculatedByHand() {
    FlatTrajectory path = FlatTrajectory.fromKick(ROUND, 10, 1, 2, 0, 4);
    assertThat(path.tSwitch()).isEqualTo(10.5);
    assertThat(path.restTime()).isEqualTo(14.5);
    assertThat(path.restDistance()).isEqualTo(5.5);
    assertThat(path.stateAt(10)).isEqualTo(new BallState(1, 2, 0, 0, 4, 0));
    assertThat(path.stateAt(10.25)).isEqualTo(new BallState(1, 2.875, 0, 0, 3, 0));
    assertThat(path.stateAt(10.5)).isEqualTo(new BallState(1, 3.5, 0, 0, 2, 0));
    assertThat(path.stateAt(12.5)).isEqualTo(new BallState(1, 6.5, 0, 0, 1, 0));
    assertThat(path.stateAt(14.5)).isEqualTo(new BallState(1, 7.5, 0, 0, 0, 0));
    assertThat(path.timeAtDistance(4.5)).hasValue(12.5);
    assertThat(path.speedAtDistance(0.875)).hasValue(3);
    assertThat(path.phaseAt(10.4)).isEqualTo(Phase.SLIDING);
    assertThat(path.phaseAt(10.5)).isEqualTo(Phase.ROLLING);
    assertThat(path.model()).isEqualTo(ROUND);
  }

  @Test
  void ofABallThatRollsFromTheStartHasNoSliding() {
    FlatTrajectory path = FlatTrajectory.fromKickWithSpin(ROUND, 0, 0, 0, 2, 0, 2, 0);
    assertThat(path.tSwitch()).isZero();
    assertThat(path.phaseAt(0)).isEqualTo(Phase.ROLLING);
    assertThat(path.restDistance()).isEqualTo(4);
  }

  @Test
  void withBackspinCanComeBack() {
    // Slip 2 + 6 = 8: rolls with 2 − 0.5·8 = −2 after 1 s; turns around after 0.5 s and 0.5 m.
    FlatTrajectory path = FlatTrajectory.fromKickWithSpin(ROUND, 0, 0, 0, 2, 0, -6, 0);
    assertThat(path.tSwitch()).isEqualTo(1);
    assertThat(path.stateAt(0.5)).isEqualTo(new BallState(0.5, 0, 0, 0, 0, 0));
    assertThat(path.stateAt(1)).isEqualTo(new BallState(0, 0, 0, -2, 0, 0));
    assertThat(path.distanceAt(1)).isEqualTo(1);
    assertThat(path.restDistance()).isEqualTo(5);
    assertThat(path.timeAtDistance(0.5).orElseThrow()).isCloseTo(0.5, within(1e-7));
    assertThat(path.timeAtDistance(0.875).orElseThrow())
        .isCloseTo(0.75 + 0.5 * (Math.sqrt(0.75) - 0.5), within(1e-7));
    assertThat(path.stateAt(5).x()).isEqualTo(-4);
  }

  @Test
  void withTopspinSpeedsUp() {
    FlatTrajectory path = FlatTrajectory.fromKickWithSpin(ROUND, 0, 0, 0, 1, 0, 3, 0);
    assertThat(path.stateAt(path.tSwitch()).vx()).isEqualTo(2);
    assertThat(path.stateAt(0.1).vx()).isCloseTo(1.4, within(1e-15));
  }

  @Test
  void withSideSpinCurvesWhileSliding() {
    FlatTrajectory path = FlatTrajectory.fromKickWithSpin(ROUND, 0, 0, 0, 3, 0, 0, 4);
    // Slip (3, −4): friction pushes along (−3, 4)/5 with 4 m/s², rolls with (3, 0) − 0.5·(3, −4).
    BallState atSwitch = path.stateAt(path.tSwitch());
    assertThat(path.tSwitch()).isCloseTo(0.625, within(1e-15));
    assertThat(atSwitch.vx()).isCloseTo(1.5, within(1e-12));
    assertThat(atSwitch.vy()).isCloseTo(2, within(1e-12));
    double[] spin = new double[2];
    path.spinAt(0, spin);
    assertThat(spin).containsExactly(0, 4);
    path.spinAt(path.tSwitch() + 0.1, spin);
    BallState rolling = path.stateAt(path.tSwitch() + 0.1);
    assertThat(spin).containsExactly(rolling.vx(), rolling.vy());
  }

  @ParameterizedTest
  @ValueSource(longs = {21, 22, 23, 24})
  void agreesWithTheIntegratedSpinningBall(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < 10; i++) {
      double[] n = kicks.flatNumbers();
      boolean spinning = i % 2 == 1;
      double spinX = spinning ? kicks.uniform(-8, 8) : 0;
      double spinY = spinning ? kicks.uniform(-8, 8) : 0;
      FlatModel model = new FlatModel(n[5], n[6], n[7]);
      FlatTrajectory path =
          FlatTrajectory.fromKickWithSpin(model, n[4], n[0], n[1], n[2], n[3], spinX, spinY);
      NumericBall ball = NumericBall.flat(model, n[4], n, spinX, spinY, 1e-3);
      double step = 1.1 * (path.restTime() - path.kickTime()) / 40;
      for (int k = 0; k <= 40; k++) {
        double t = path.kickTime() + k * step;
        double[] expected = ball.advanceTo(t);
        BallState actual = path.stateAt(t);
        assertThat(new double[] {actual.x(), actual.y(), actual.vx(), actual.vy()})
            .as("seed %d case %d t %s", seed, i, t)
            .containsExactly(
                new double[] {expected[0], expected[1], expected[3], expected[4]},
                within(INTEGRATION));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {31, 32, 33})
  void continuedFromAnyOfItsStatesIsTheSamePath(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < 100; i++) {
      double[] n = kicks.flatNumbers();
      FlatTrajectory path = RandomKicks.flat(n);
      double t = kicks.uniform(path.kickTime(), path.restTime());
      double switchSpeed = path.model().kSwitch() * Math.hypot(n[2], n[3]);
      FlatTrajectory same = FlatTrajectory.fromState(path.model(), t, path.stateAt(t), switchSpeed);
      assertThat(same.kickTime()).isEqualTo(t);
      assertSameFrom(t, path, same, "seed " + seed + " case " + i);
      if (path.phaseAt(t) == Phase.ROLLING) {
        FlatTrajectory rolling = FlatTrajectory.fromRolling(path.model(), t, path.stateAt(t));
        assertSameFrom(t, path, rolling, "rolling, seed " + seed + " case " + i);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {31, 32, 33})
  void continuedFromAStateWithSpinIsTheSamePath(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    double[] spin = new double[2];
    for (int i = 0; i < 100; i++) {
      double[] n = kicks.flatNumbers();
      FlatModel model = kicks.flatModel();
      double spinX = kicks.uniform(-8, 8);
      double spinY = kicks.uniform(-8, 8);
      FlatTrajectory path =
          FlatTrajectory.fromKickWithSpin(model, n[4], n[0], n[1], n[2], n[3], spinX, spinY);
      double t = kicks.uniform(path.kickTime(), path.restTime());
      BallState s = path.stateAt(t);
      path.spinAt(t, spin);
      FlatTrajectory same =
          FlatTrajectory.fromKickWithSpin(model, t, s.x(), s.y(), s.vx(), s.vy(), spin[0], spin[1]);
      assertSameFrom(t, path, same, "seed " + seed + " case " + i);
    }
  }

  private static void assertSameFrom(
      double start, FlatTrajectory path, FlatTrajectory same, String label) {
    for (int k = 0; k <= 20; k++) {
      double t = start + (path.restTime() + 0.2 - start) * k / 20;
      BallState expected = path.stateAt(t);
      BallState actual = same.stateAt(t);
      assertThat(new double[] {actual.x(), actual.y(), actual.vx(), actual.vy()})
          .as(label)
          .containsExactly(
              new double[] {expected.x(), expected.y(), expected.vx(), expected.vy()},
              within(SAME));
    }
  }

  @Test
  void withoutSpeedStaysWhereItIs() {
    FlatTrajectory path = FlatTrajectory.fromKick(ROUND, 3, 1, 2, 0, 0);
    assertThat(path.restTime()).isEqualTo(3);
    assertThat(path.phaseAt(3)).isEqualTo(Phase.STOPPED);
    assertThat(path.restDistance()).isZero();
    assertThat(path.timeAtDistance(0)).hasValue(3);
    assertThat(path.timeAtDistance(1e-12)).isEmpty();
    assertThat(path.stateAt(4)).isEqualTo(new BallState(1, 2, 0, 0, 0, 0));
    assertThat(FlatTrajectory.fromState(ROUND, 3, path.stateAt(3), 1).restTime()).isEqualTo(3);
  }

  @Test
  void canStandStillWhenTheSpinIsUsedUp() {
    // Rolls with 2 − 0.5·4 = 0: forward motion and backspin are gone at the same time.
    FlatTrajectory path = FlatTrajectory.fromKickWithSpin(ROUND, 0, 0, 0, 2, 0, -2, 0);
    assertThat(path.restTime()).isEqualTo(0.5);
    assertThat(path.restDistance()).isEqualTo(0.5);
    assertThat(path.stateAt(1)).isEqualTo(new BallState(0.5, 0, 0, 0, 0, 0));
  }

  static Stream<Arguments> badNumbers() {
    return Stream.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)
        .flatMap(bad -> Stream.of(0, 1, 2, 3, 4, 5, 6).map(index -> Arguments.of(bad, index)));
  }

  @ParameterizedTest
  @MethodSource("badNumbers")
  void refusesNumbersThatAreNone(double bad, int index) {
    double[] n = new double[7];
    n[index] = bad;
    assertThatThrownBy(
            () -> FlatTrajectory.fromKickWithSpin(ROUND, n[0], n[1], n[2], n[3], n[4], n[5], n[6]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("" + bad);
  }

  @Test
  void refusesASwitchSpeedBelowZero() {
    BallState state = new BallState(0, 0, 0, 1, 0, 0);
    assertThatThrownBy(() -> FlatTrajectory.fromState(ROUND, 0, state, -0.1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-0.1");
    assertThatThrownBy(() -> FlatTrajectory.fromState(ROUND, 0, state, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
