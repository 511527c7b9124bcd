package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SensitivitiesTest {
  private static final int CASES = 200;

  /** Truncation of the fourth-order difference over a step of 7e-4 and rounding both stay far below. */
  private static final double TOLERANCE = 1e-7;

  /** Observations nearer to a change of phase than this would have steps of the difference on both sides of the kink, s. */
  private static final double CLEAR_OF_KINKS = 0.02;

  private final double[] xyz = new double[3];
  private final double[][] rows = new double[3][];

  private static boolean clearOfKinks(double t, double... kinks) {
    for (double kink : kinks) {
      if (Math.abs(t - kink) < CLEAR_OF_KINKS) {
        return false;
      }
    }
    return true;
  }

  /** Around the rest, which a difference's steps shift by up to 0.1 s, the second derivative jumps: the difference is of first order. */
  private static double tolerance(BallTrajectory path, double t) {
    return Math.abs(t - path.restTime()) < 0.1 ? 1e-2 : TOLERANCE;
  }

  private double[] column(int index) {
    return new double[] {rows[0][index], rows[1][index], rows[2][index]};
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void ofAFlatKickAreThoseOfCentralDifferences(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      double[] numbers = kicks.flatNumbers();
      FlatTrajectory path = RandomKicks.flat(numbers);
      // A third of the observations each while sliding, while rolling and around the rest.
      double[] from = {path.kickTime() - 0.1, path.tSwitch(), path.restTime() - 0.2};
      double[] to = {path.tSwitch(), path.restTime(), path.restTime() + 1};
      double t = kicks.uniform(from[i % 3], to[i % 3]);
      if (!clearOfKinks(t, path.kickTime(), path.tSwitch())) {
        continue;
      }
      rows[0] = new double[FlatTrajectory.SENSITIVITIES];
      rows[1] = new double[FlatTrajectory.SENSITIVITIES];
      rows[2] = new double[FlatTrajectory.SENSITIVITIES];
      path.sensitivitiesAt(t, xyz, rows[0], rows[1]);
      // Near the rest, the fourth derivative is not continuous: the difference is of second order
      // only.
      double tolerance = tolerance(path, t);
      for (int k = 0; k < numbers.length; k++) {
        String label = "seed " + seed + " case " + i;
        FiniteDifferences.check(RandomKicks::flat, numbers, k, t, column(k), tolerance, label);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void ofAChipAreThoseOfCentralDifferences(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      double[] numbers = kicks.chipNumbers();
      int flights = kicks.integer(1, 5);
      ChipTrajectory path = RandomKicks.chip(numbers, flights);
      double rollStart = path.landings().get(flights - 1).time();
      double t =
          i % 2 == 0
              ? kicks.uniform(path.kickTime() - 0.1, rollStart)
              : kicks.uniform(rollStart, path.restTime() + 0.5);
      double[] kinks = path.landings().stream().mapToDouble(Landing::time).toArray();
      if (!clearOfKinks(t, kinks) || !clearOfKinks(t, path.kickTime())) {
        continue;
      }
      for (int axis = 0; axis < 3; axis++) {
        rows[axis] = new double[ChipTrajectory.SENSITIVITIES];
      }
      path.sensitivitiesAt(t, xyz, rows[0], rows[1], rows[2]);
      double tolerance = tolerance(path, t);
      for (int k = 0; k < numbers.length; k++) {
        String label = "seed " + seed + " case " + i + " flights " + flights;
        FiniteDifferences.check(
            n -> RandomKicks.chip(n, flights), numbers, k, t, column(k), tolerance, label);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void bySingleImpactsAddUpToThoseByTheModelsDampings(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      double[] numbers = kicks.chipNumbers();
      int flights = kicks.integer(1, 5);
      ChipTrajectory path = RandomKicks.chip(numbers, flights);
      double t = kicks.uniform(path.kickTime() - 0.1, path.restTime() + 0.5);
      double[] dx = new double[ChipTrajectory.SENSITIVITIES];
      double[] dy = new double[ChipTrajectory.SENSITIVITIES];
      path.sensitivitiesAt(t, xyz, dx, dy, new double[ChipTrajectory.SENSITIVITIES]);
      double[] byImpact = new double[7];
      path.dampingSensitivitiesAt(t, byImpact);
      double others = Arrays.stream(byImpact).skip(1).sum();
      String label = "seed " + seed + " case " + i + " flights " + flights;
      double first =
          Math.hypot(
              dx[ChipTrajectory.DAMPING_XY_FIRST_HOP], dy[ChipTrajectory.DAMPING_XY_FIRST_HOP]);
      double later =
          Math.hypot(
              dx[ChipTrajectory.DAMPING_XY_OTHER_HOPS], dy[ChipTrajectory.DAMPING_XY_OTHER_HOPS]);
      assertThat(byImpact[0]).as(label).isEqualTo(first, within(1e-12));
      assertThat(others).as(label).isEqualTo(later, within(1e-12));
    }
  }

  @Test
  void alsoGiveThePosition() {
    FlatTrajectory flat = FlatTrajectory.fromKick(FlatModel.typical(), 0.5, 1, 2, 3, 4);
    ChipTrajectory chip = ChipTrajectory.fromKick(ChipModel.typical(), 0.5, 1, 2, 3, 4, 3);
    double[] row = new double[ChipTrajectory.SENSITIVITIES];
    double[] expected = new double[3];
    for (double t = 0; t < 20; t += 0.1) {
      flat.positionAt(t, expected);
      flat.sensitivitiesAt(t, xyz, row, row.clone());
      assertThat(xyz).containsExactly(expected);
      chip.positionAt(t, expected);
      chip.sensitivitiesAt(t, xyz, row, row.clone(), row.clone());
      assertThat(xyz).containsExactly(expected);
    }
  }

  @Test
  void beforeTheKickOnlyThePlaceOfTheKickMatters() {
    FlatTrajectory path = FlatTrajectory.fromKick(FlatModel.typical(), 0.5, 1, 2, 3, 4);
    double[] dx = new double[FlatTrajectory.SENSITIVITIES];
    double[] dy = new double[FlatTrajectory.SENSITIVITIES];
    path.sensitivitiesAt(0.4999, xyz, dx, dy);
    assertThat(xyz).containsExactly(1, 2, 0);
    assertThat(dx).containsExactly(1, 0, 0, 0, 0, 0, 0, 0);
    assertThat(dy).containsExactly(0, 1, 0, 0, 0, 0, 0, 0);
  }

  @Test
  void byTheKickTimeIsTheVelocityBackwards() {
    ChipTrajectory path = ChipTrajectory.fromKick(ChipModel.typical(), 0, 1, 2, 3, 4, 3);
    double[][] d = new double[3][ChipTrajectory.SENSITIVITIES];
    for (double t = 0; t < path.restTime() + 1; t += 0.05) {
      path.sensitivitiesAt(t, xyz, d[0], d[1], d[2]);
      BallState state = path.stateAt(t);
      int t0 = ChipTrajectory.T0;
      assertThat(Math.abs(d[0][t0] + state.vx())).isLessThan(1e-12);
      assertThat(Math.abs(d[1][t0] + state.vy())).isLessThan(1e-12);
      assertThat(Math.abs(d[2][t0] + state.vz())).isLessThan(1e-12);
    }
  }

  @Test
  void ofAKickWithoutSpeedAreFinite() {
    double[] dx = new double[ChipTrajectory.SENSITIVITIES];
    double[] dy = new double[ChipTrajectory.SENSITIVITIES];
    double[] dz = new double[ChipTrajectory.SENSITIVITIES];
    for (double t : new double[] {-1, 0, 0.1, 0.4, 10}) {
      FlatTrajectory.fromKick(FlatModel.typical(), 0, 1, 2, 0, 0).sensitivitiesAt(t, xyz, dx, dy);
      assertThat(dx).startsWith(1, 0, 0, 0, 0, 0, 0, 0);
      ChipTrajectory.fromKick(ChipModel.typical(), 0, 1, 2, 0, 0, 2)
          .sensitivitiesAt(t, xyz, dx, dy, dz);
      assertThat(dx).doesNotContain(Double.NaN);
      assertThat(dy).doesNotContain(Double.NaN);
      assertThat(dz).doesNotContain(Double.NaN);
    }
  }

  @Test
  void areRefusedForPathsThatDependOnOtherNumbers() {
    FlatTrajectory spinning =
        FlatTrajectory.fromKickWithSpin(FlatModel.typical(), 0, 0, 0, 3, 0, -1, 0);
    double[] d = new double[ChipTrajectory.SENSITIVITIES];
    assertThatThrownBy(() -> spinning.sensitivitiesAt(1, xyz, d, d))
        .isInstanceOf(IllegalStateException.class);
    ChipTrajectory continued =
        ChipTrajectory.fromState(ChipModel.typical(), 0, new BallState(0, 0, 1, 1, 0, 0), 1);
    assertThatThrownBy(() -> continued.sensitivitiesAt(1, xyz, d, d, d))
        .isInstanceOf(IllegalStateException.class);
  }
}
