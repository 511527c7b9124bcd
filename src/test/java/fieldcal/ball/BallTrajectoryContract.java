package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What must hold for every path; each implementation's test inherits it. */
abstract class BallTrajectoryContract {
  private static final int CASES = 50;

  /** Rounding over a path of some ten metres, with room for a dozen operations. */
  private static final double ROUNDING = 1e-11;

  /** Near the rest, distances say little about time: v = sqrt(2·a·left) turns 1e-16 m into 1e-8 s. */
  private static final double TIME_NEAR_REST = 1e-6;

  /** A path drawn at random, then turned about the origin and moved in time. */
  abstract BallTrajectory random(RandomKicks kicks, double rotation, double delay);

  /** Times between which the acceleration is constant. */
  abstract List<Double> phaseChanges(BallTrajectory path);

  private BallTrajectory random(RandomKicks kicks) {
    return random(kicks, 0, 0);
  }

  private static double[] position(BallTrajectory path, double t) {
    double[] xyz = new double[3];
    path.positionAt(t, xyz);
    return xyz;
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void restsBeforeTheKickAndAfterTheEnd(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      BallTrajectory path = random(kicks);
      double t0 = path.kickTime();
      double rest = path.restTime();
      assertThat(path.phaseAt(Math.nextDown(t0))).isEqualTo(Phase.RESTING_BEFORE_KICK);
      assertThat(path.phaseAt(t0)).isIn(Phase.SLIDING, Phase.FLYING, Phase.ROLLING);
      assertThat(path.phaseAt(Math.nextDown(rest))).isEqualTo(Phase.ROLLING);
      assertThat(path.phaseAt(rest)).isEqualTo(Phase.STOPPED);
      for (double t : new double[] {Double.NEGATIVE_INFINITY, t0 - 1, Math.nextDown(t0)}) {
        assertThat(position(path, t)).containsExactly(position(path, t0));
        assertThat(path.stateAt(t).groundSpeed()).isZero();
        assertThat(path.distanceAt(t)).isZero();
      }
      for (double t : new double[] {rest, rest + 1, Double.POSITIVE_INFINITY}) {
        assertThat(position(path, t)).containsExactly(position(path, rest));
        assertThat(path.stateAt(t).groundSpeed()).isZero();
        assertThat(path.distanceAt(t)).isEqualTo(path.restDistance());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void positionIsContinuousAndItsDerivativeIsTheVelocity(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      BallTrajectory path = random(kicks);
      for (double change : phaseChanges(path)) {
        double[] before = position(path, Math.nextDown(change));
        assertThat(position(path, change)).containsExactly(before, within(ROUNDING));
      }
      double t = kicks.uniform(path.kickTime(), path.restTime());
      double h = 1e-4;
      if (phaseChanges(path).stream().anyMatch(change -> Math.abs(change - t) < h)) {
        continue;
      }
      // Exact for a parabola, up to rounding over the step.
      BallState state = path.stateAt(t);
      double[] before = position(path, t - h);
      double[] after = position(path, t + h);
      double[] velocity = {state.vx(), state.vy(), state.vz()};
      for (int axis = 0; axis < 3; axis++) {
        double difference = (after[axis] - before[axis]) / (2 * h);
        assertThat(difference)
            .as("seed %d case %d axis %d", seed, i, axis)
            .isCloseTo(velocity[axis], within(1e-9));
      }
      assertThat(position(path, t)).containsExactly(state.x(), state.y(), state.z());
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void distanceIsTheIntegralOfTheSpeed(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < 10; i++) {
      BallTrajectory path = random(kicks);
      double sum = 0;
      List<Double> changes = phaseChanges(path);
      for (int k = 0; k + 1 < changes.size(); k++) {
        int steps = 4000;
        double h = (changes.get(k + 1) - changes.get(k)) / steps;
        for (int j = 0; j < steps; j++) {
          sum += h * path.stateAt(changes.get(k) + (j + 0.5) * h).groundSpeed();
        }
        assertThat(path.distanceAt(changes.get(k + 1)))
            .as("seed %d case %d phase %d", seed, i, k)
            .isCloseTo(sum, within(1e-6));
      }
      assertThat(path.restDistance()).isEqualTo(path.distanceAt(path.restTime()));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void timeAtDistanceUndoesDistanceAt(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      BallTrajectory path = random(kicks);
      double duration = path.restTime() - path.kickTime();
      double t = path.kickTime() + kicks.uniform(0, 0.95) * duration;
      double distance = path.distanceAt(t);
      assertThat(path.timeAtDistance(distance).orElseThrow())
          .as("seed %d case %d", seed, i)
          .isCloseTo(t, within(TIME_NEAR_REST));
      double reached = path.distanceAt(path.timeAtDistance(distance).orElseThrow());
      assertThat(reached).isCloseTo(distance, within(ROUNDING));
      assertThat(path.speedAtDistance(distance).orElseThrow())
          .isCloseTo(path.stateAt(t).groundSpeed(), within(1e-5));
    }
  }

  @Test
  void answersAtTheEndsOfThePath() {
    BallTrajectory path = random(new RandomKicks(1));
    assertThat(path.timeAtDistance(0)).hasValue(path.kickTime());
    assertThat(path.speedAtDistance(0)).hasValue(path.stateAt(path.kickTime()).groundSpeed());
    assertThat(path.timeAtDistance(path.restDistance()).orElseThrow())
        .isCloseTo(path.restTime(), within(TIME_NEAR_REST));
    assertThat(path.speedAtDistance(path.restDistance()).orElseThrow())
        .isCloseTo(0, within(TIME_NEAR_REST));
    assertThat(path.timeAtDistance(path.restDistance() + 1e-9)).isEmpty();
    assertThat(path.speedAtDistance(path.restDistance() + 1e-9)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13})
  void turnsAndMovesInTimeWithItsKick(long seed) {
    RandomKicks angles = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      double angle = angles.direction();
      double delay = angles.uniform(-10, 10);
      BallTrajectory path = random(new RandomKicks(seed + i));
      BallTrajectory turned = random(new RandomKicks(seed + i), angle, delay);
      double t = angles.uniform(path.kickTime() - 0.5, path.restTime() + 0.5);
      BallState state = path.stateAt(t);
      BallState other = turned.stateAt(t + delay);
      double c = Math.cos(angle);
      double s = Math.sin(angle);
      String label = "seed " + seed + " case " + i;
      double[] expected = {
        c * state.x() - s * state.y(),
        s * state.x() + c * state.y(),
        state.z(),
        c * state.vx() - s * state.vy(),
        s * state.vx() + c * state.vy()
      };
      double[] actual = {other.x(), other.y(), other.z(), other.vx(), other.vy()};
      assertThat(actual).as(label).containsExactly(expected, within(1e-10));
      assertThat(turned.restDistance()).isCloseTo(path.restDistance(), within(1e-10));
    }
  }

  @Test
  void refusesTimesAndDistancesThatAreNone() {
    BallTrajectory path = random(new RandomKicks(1));
    assertThatThrownBy(() -> path.stateAt(Double.NaN)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> path.positionAt(Double.NaN, new double[3]))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> path.phaseAt(Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> path.distanceAt(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    for (double distance : new double[] {Double.NaN, -1e-9, Double.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> path.timeAtDistance(distance))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("" + distance);
      assertThatThrownBy(() -> path.speedAtDistance(distance))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("" + distance);
    }
  }
}
