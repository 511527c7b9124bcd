package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ChipTrajectoryTest extends BallTrajectoryContract {
  private static final ChipModel MODEL = new ChipModel(0.75, 0.5, 0.5, -0.5);

  /** Vertical velocity of a flight of one second. */
  private static final double ONE_SECOND = Gravity.ACCELERATION / 2;

  /** Runge-Kutta is exact for parabolas; impacts located to 1e-13 s. */
  private static final double INTEGRATION = 1e-9;

  @Override
  BallTrajectory random(RandomKicks kicks, double rotation, double delay) {
    double[] n = kicks.chipNumbers();
    double[] turned = n.clone();
    for (int i = 0; i < 4; i += 2) {
      turned[i] = Math.cos(rotation) * n[i] - Math.sin(rotation) * n[i + 1];
      turned[i + 1] = Math.sin(rotation) * n[i] + Math.cos(rotation) * n[i + 1];
    }
    turned[5] += delay;
    return RandomKicks.chip(turned);
  }

  @Override
  List<Double> phaseChanges(BallTrajectory path) {
    List<Double> changes = new ArrayList<>();
    changes.add(path.kickTime());
    ((ChipTrajectory) path).landings().forEach(landing -> changes.add(landing.time()));
    changes.add(path.restTime());
    return changes;
  }

  @Test
  void calculatedByHand() {
    // Flights of 1, 1/2 and 1/4 s at 4, 3 and 1.5 m/s; then 0.75 m/s, rolling 1.5 s and 0.5625 m.
    ChipTrajectory path = ChipTrajectory.fromKickWithHops(MODEL, 10, 1, 2, 4, 0, ONE_SECOND, 3);
    assertThat(path.landings())
        .containsExactly(
            new Landing(11, 5, 2), new Landing(11.5, 6.5, 2), new Landing(11.75, 6.875, 2));
    assertThat(path.hops()).isEqualTo(3);
    assertThat(path.restTime()).isEqualTo(13.25);
    assertThat(path.restDistance()).isEqualTo(6.4375);
    assertThat(path.stateAt(10.5)).isEqualTo(new BallState(3, 2, ONE_SECOND / 4, 4, 0, 0));
    assertThat(path.stateAt(11)).isEqualTo(new BallState(5, 2, 0, 3, 0, ONE_SECOND / 2));
    assertThat(path.phaseAt(11.74)).isEqualTo(Phase.FLYING);
    assertThat(path.phaseAt(11.75)).isEqualTo(Phase.ROLLING);
    assertThat(path.timeAtDistance(4.75)).hasValue(11.25);
    assertThat(path.speedAtDistance(5.875)).hasValue(0.75);
    assertThat(path.model()).isEqualTo(MODEL);
  }

  @Test
  void theNumberOfFlightsFollowsTheHopHeight() {
    double least = Math.sqrt(2 * Gravity.ACCELERATION * ChipModel.MIN_HOP_HEIGHT);
    assertThat(ChipTrajectory.flightsByRule(MODEL, 0)).isZero();
    assertThat(ChipTrajectory.flightsByRule(MODEL, least * 0.999999)).isZero();
    assertThat(ChipTrajectory.flightsByRule(MODEL, least * 1.000001)).isEqualTo(1);
    assertThat(ChipTrajectory.flightsByRule(MODEL, least * 1.999999)).isEqualTo(1);
    assertThat(ChipTrajectory.flightsByRule(MODEL, least * 2.000001)).isEqualTo(2);
    assertThat(ChipTrajectory.flightsByRule(MODEL, least * 8.000001)).isEqualTo(4);
    ChipModel bouncy = new ChipModel(1, 1, 1 - 1e-12, -1);
    assertThat(ChipTrajectory.flightsByRule(bouncy, 5)).isEqualTo(ChipModel.MAX_FLIGHTS);
  }

  @ParameterizedTest
  @ValueSource(longs = {41, 42, 43, 44})
  void agreesWithTheIntegratedBall(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < 10; i++) {
      double[] n = kicks.chipNumbers();
      ChipTrajectory path = RandomKicks.chip(n);
      NumericBall ball = NumericBall.chip(path.model(), n[5], n, 1e-3);
      double step = 1.1 * (path.restTime() - path.kickTime()) / 100;
      for (int k = 0; k <= 100; k++) {
        double t = path.kickTime() + k * step;
        double[] expected = ball.advanceTo(t);
        BallState s = path.stateAt(t);
        assertThat(new double[] {s.x(), s.y(), s.z(), s.vx(), s.vy(), s.vz()})
            .as("seed %d case %d t %s", seed, i, t)
            .containsExactly(Arrays.copyOf(expected, 6), within(INTEGRATION));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {51, 52, 53})
  void continuedFromAnyOfItsStatesIsTheSamePath(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < 100; i++) {
      ChipTrajectory path = RandomKicks.chip(kicks.chipNumbers());
      double start = kicks.uniform(path.kickTime(), path.restTime());
      int impacts = 0;
      for (Landing landing : path.landings()) {
        impacts += landing.time() <= start ? 1 : 0;
      }
      BallState state = path.stateAt(start);
      ChipTrajectory same = ChipTrajectory.fromState(path.model(), start, state, impacts);
      assertThat(same.hops()).isEqualTo(path.hops() - impacts);
      assertThat(same.kickTime()).isEqualTo(start);
      for (int k = 0; k <= 20; k++) {
        double t = start + (path.restTime() + 0.2 - start) * k / 20;
        BallState expected = path.stateAt(t);
        BallState actual = same.stateAt(t);
        assertThat(new double[] {actual.x(), actual.y(), actual.z()})
            .as("seed %d case %d t %s", seed, i, t)
            .containsExactly(
                new double[] {expected.x(), expected.y(), expected.z()}, within(1e-10));
      }
    }
  }

  @Test
  void withoutLiftRollsAtOnce() {
    ChipTrajectory path = ChipTrajectory.fromKick(MODEL, 1, 0, 0, 2, 0, 0);
    assertThat(path.hops()).isZero();
    assertThat(path.landings()).isEmpty();
    assertThat(path.phaseAt(1)).isEqualTo(Phase.ROLLING);
    assertThat(path.restTime()).isEqualTo(5);
    assertThat(path.restDistance()).isEqualTo(4);
  }

  @Test
  void withTooLittleLiftForAHopRollsAtOnce() {
    ChipTrajectory path = ChipTrajectory.fromKick(MODEL, 1, 0, 0, 2, 0, 0.4);
    assertThat(path.hops()).isZero();
    assertThat(path.stateAt(1)).isEqualTo(new BallState(0, 0, 0, 2, 0, 0));
  }

  @Test
  void straightUpComesDownInPlace() {
    ChipTrajectory path = ChipTrajectory.fromKickWithHops(MODEL, 0, 1, 2, 0, 0, ONE_SECOND, 2);
    assertThat(path.restTime()).isEqualTo(1.5);
    assertThat(path.restDistance()).isZero();
    assertThat(path.stateAt(0.5)).isEqualTo(new BallState(1, 2, ONE_SECOND / 4, 0, 0, 0));
    assertThat(path.timeAtDistance(0)).hasValue(0);
    assertThat(path.timeAtDistance(0.1)).isEmpty();
    assertThat(path.phaseAt(1.5)).isEqualTo(Phase.STOPPED);
  }

  @Test
  void withNoHeightInAGivenFlightLosesSpeedAtItsImpact() {
    // The limit of lower and lower flights, which the fit approaches with a fixed number of
    // flights.
    ChipTrajectory path = ChipTrajectory.fromKickWithHops(MODEL, 0, 0, 0, 2, 0, 0, 1);
    assertThat(path.stateAt(0)).isEqualTo(new BallState(0, 0, 0, 1.5, 0, 0));
    assertThat(path.landings()).containsExactly(new Landing(0, 0, 0));
  }

  @Test
  void ofABallSeenInTheAirBeginsThere() {
    double height = ONE_SECOND / 4;
    BallState apex = new BallState(1, 2, height, 4, 0, 0);
    ChipTrajectory path = ChipTrajectory.fromState(MODEL, 7, apex, 0);
    assertThat(path.landings().get(0).time()).isCloseTo(7.5, within(1e-12));
    assertThat(path.landings().get(0).x()).isCloseTo(3, within(1e-12));
    assertThat(path.stateAt(7.6).vx()).isCloseTo(3, within(1e-12));
    assertThat(path.stateAt(6).z()).isEqualTo(height);
    // Behind the first impact the damping is the other one.
    ChipTrajectory later = ChipTrajectory.fromState(MODEL, 7, apex, 1);
    assertThat(later.stateAt(7.6).vx()).isCloseTo(2, within(1e-12));
    // However low it is: what is in the air comes down.
    BallState low = new BallState(0, 0, 0.001, 1, 0, 0);
    assertThat(ChipTrajectory.fromState(MODEL, 0, low, 3).hops()).isEqualTo(1);
    BallState rolling = new BallState(0, 0, 0, 1, 0, 0);
    assertThat(ChipTrajectory.fromState(MODEL, 0, rolling, 3).phaseAt(0)).isEqualTo(Phase.ROLLING);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesNumbersThatAreNone(double bad) {
    for (int index = 0; index < 6; index++) {
      double[] n = {0, 0, 0, 1, 1, 1};
      n[index] = bad;
      assertThatThrownBy(() -> ChipTrajectory.fromKick(MODEL, n[0], n[1], n[2], n[3], n[4], n[5]))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("" + bad);
      assertThatThrownBy(
              () -> {
                BallState state = new BallState(n[0], n[1], 1 + n[2], n[3], n[4], n[5]);
                ChipTrajectory.fromState(MODEL, 0, state, 0);
              })
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("" + bad);
    }
  }

  @Test
  void refusesWhatCannotBe() {
    assertThatThrownBy(() -> ChipTrajectory.fromKick(MODEL, 0, 0, 0, 1, 0, -0.5))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-0.5");
    assertThatThrownBy(() -> ChipTrajectory.fromKickWithHops(MODEL, 0, 0, 0, 1, 0, 1, -1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1");
    assertThatThrownBy(() -> ChipTrajectory.fromKickWithHops(MODEL, 0, 0, 0, 1, 0, 1, 101))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("101");
    BallState below = new BallState(0, 0, -0.25, 1, 0, 0);
    assertThatThrownBy(() -> ChipTrajectory.fromState(MODEL, 0, below, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-0.25");
    BallState falling = new BallState(0, 0, 0, 1, 0, -0.25);
    assertThatThrownBy(() -> ChipTrajectory.fromState(MODEL, 0, falling, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-0.25");
    BallState fine = new BallState(0, 0, 0, 1, 0, 0);
    assertThatThrownBy(() -> ChipTrajectory.fromState(MODEL, 0, fine, -2))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-2");
  }
}
