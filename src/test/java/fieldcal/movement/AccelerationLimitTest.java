package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The limit from manoeuvres that are drawn, not driven. */
class AccelerationLimitTest {
  private static final double SPEED = 3;

  /** Manoeuvres of a team: a share of them at its limit, the others anywhere below. */
  private static ManoeuvreTable table(
      double limit, double torque, double directional, double share, int n, Random random) {
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < n; i++) {
      double speed = SPEED * random.nextDouble();
      double direction = 2 * Math.PI * random.nextDouble();
      double sine = Math.abs(Math.sin(direction));
      double most = limit * (1 - torque * speed / SPEED) * (1 - directional * sine);
      double a = random.nextDouble() < share ? most : most * random.nextDouble();
      double error = a * 0.1 * random.nextDouble();
      table.add(a + error * random.nextGaussian(), error, speed, direction);
    }
    return table;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void uniformTeamsHaveALimitAndNoEffect(long seed) {
    Random random = new Random(seed);
    double limit = 1.5 + 6 * random.nextDouble();
    AccelerationLimit found =
        new AccelerationLimit(
            table(limit, 0, 0, 0.6, 800, random), AccelerationLimit.Kind.ACCELERATION, SPEED, 6);
    assertThat(found.deviations()).isEmpty();
    LimitEstimate e = found.estimate();
    assertThat(e.reached()).isTrue();
    assertThat(e.samples()).isBetween(700L, 800L);
    assertThat(e.value()).isEqualTo(limit, within(0.01 * limit));
    assertThat(e.standardError()).isBetween(0.005 * limit, 0.01 * limit);
  }

  @Test
  void errorsCoverTheTruth() {
    int covered = 0;
    int trials = 100;
    for (int seed = 0; seed < trials; seed++) {
      LimitEstimate e =
          new AccelerationLimit(
                  table(4, 0, 0, 0.7, 400, new Random(seed)),
                  AccelerationLimit.Kind.BRAKING,
                  SPEED,
                  6)
              .estimate();
      covered += Math.abs(e.value() - 4) < 2 * e.standardError() ? 1 : 0;
    }
    assertThat(covered).isBetween(85, 100);
  }

  /** Robots end turns with 80 % of what they have, and use all of it when they turn back: with errors of 9 % the two heaps are one, somewhere between. */
  @Test
  void theErrorCoversALimitThatIsSeldomUsedAndBadlyMeasured() {
    int covered = 0;
    int trials = 60;
    for (int seed = 0; seed < trials; seed++) {
      LimitEstimate e = turns(0.15, new Random(seed));
      covered += Math.abs(e.value() - 40) < 2.5 * e.standardError() ? 1 : 0;
    }
    assertThat(covered).isGreaterThan(55);
  }

  /** Where all are as strong, nothing stronger is seen however large the errors are: the error stays what the mode's is. */
  @Test
  void onlyWhatIsSeenAboveTheLimitIsInItsError() {
    double sum = 0;
    int trials = 60;
    for (int seed = 0; seed < trials; seed++) {
      sum += turns(1, new Random(seed)).standardError();
    }
    assertThat(sum / trials).isLessThan(0.6);
  }

  /** The limit of 30 turns, of which that share is as strong as can be. */
  private static LimitEstimate turns(double share, Random random) {
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.TURNING);
    for (int i = 0; i < 30; i++) {
      boolean strong = i < share * 30;
      double error = (strong ? 0.035 : 0.09) * (0.8 + 0.4 * random.nextDouble()) * 40;
      double turn = (strong ? 40 : 32) + error * random.nextGaussian();
      table.add(turn, error, 5, Double.NaN);
    }
    return new AccelerationLimit(table, AccelerationLimit.Kind.TURN_BRAKING, Double.NaN, 6)
        .estimate();
  }

  /** The larger the errors of the manoeuvres and the fewer there are, the farther above may a part of them lie unnoticed. */
  @Test
  void theErrorGrowsWithThatOfTheManoeuvres() {
    assertThat(errorPart(2000, 0.002)).isBetween(0.006, 0.0065);
    assertThat(errorPart(2000, 0.012)).isBetween(0.006, 0.0065);
    assertThat(errorPart(150, 0.025)).isBetween(0.009, 0.012);
    assertThat(errorPart(600, 0.025)).isBetween(errorPart(2000, 0.025), errorPart(150, 0.025));
  }

  /** The standard error of a limit that so many manoeuvres of that error show, both in parts of the limit. */
  private static double errorPart(int manoeuvres, double ofManoeuvres) {
    LimitEstimate e = planned(manoeuvres, 1, ofManoeuvres, 13);
    assertThat(e.value()).isEqualTo(4, within(0.025));
    return e.standardError() / e.value();
  }

  /** A limit of 4 m/s² that half of the manoeuvres use, and the other half plan with a part of. */
  private static LimitEstimate planned(int manoeuvres, double part, double noise, long seed) {
    Random random = new Random(seed);
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < manoeuvres; i++) {
      double error = 4 * noise;
      double a = 4 * (i % 2 == 0 ? part : 1);
      table.add(a + error * random.nextGaussian(), error, 1.5, 0);
    }
    return new AccelerationLimit(table, AccelerationLimit.Kind.BRAKING, SPEED, 16).estimate();
  }

  /** Where noise hides that there are two heaps 3 % apart, the estimate lies between them, and its error reaches up to the limit. */
  @ParameterizedTest
  @CsvSource({
    "150, 0.008",
    "150, 0.02",
    "150, 0.025",
    "600, 0.015",
    "600, 0.02",
    "600, 0.025",
    "2000, 0.02"
  })
  void theErrorCoversAPlanThatNoiseHides(int manoeuvres, double noise) {
    int covered = 0;
    int trials = 20;
    for (int seed = 0; seed < trials; seed++) {
      LimitEstimate e = planned(manoeuvres, 0.97, noise, seed);
      covered += Math.abs(e.value() - 4) < 2 * e.standardError() ? 1 : 0;
      assertThat(e.standardError()).isLessThan(0.025 * e.value());
    }
    assertThat(covered).isGreaterThanOrEqualTo(18);
  }

  /** The limit of robots that brake less to the side, and that mostly plan with 97 % of it. */
  @ParameterizedTest
  @ValueSource(doubles = {0.15, 0.3, 0.5})
  void aPlanBelowTheLimitDoesNotMoveThatOfDirectionalRobots(double coefficient) {
    Random random = new Random(21);
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < 1500; i++) {
      double direction = 2 * Math.PI * random.nextDouble();
      double sine = Math.abs(Math.sin(direction));
      double a = 5 * (1 - coefficient * sine) * (i % 5 < 3 ? 0.97 : 1);
      double error = a * (0.004 + 0.01 * random.nextDouble());
      table.add(a + error * random.nextGaussian(), error, 1.5, direction);
    }
    AccelerationLimit found =
        new AccelerationLimit(table, AccelerationLimit.Kind.BRAKING, SPEED, 6);
    assertThat(found.deviations()).hasSize(1);
    LimitEstimate e = found.estimate();
    assertThat(e.value()).isEqualTo(5, within(0.006 * 5));
    assertThat(Math.abs(e.value() - 5)).isLessThan(2 * e.standardError());
  }

  /** A controller that plans with a part of what the robots can do, and uses all of it only when it is surprised. */
  @ParameterizedTest
  @ValueSource(doubles = {0.8, 0.85, 0.9, 0.94})
  void theLimitIsFoundBesideAPlanBelowIt(double planned) {
    Random random = new Random(11);
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < 800; i++) {
      double drawn = random.nextDouble();
      double a = 5 * (drawn < 0.2 ? 1 : drawn < 0.7 ? planned : random.nextDouble() * planned);
      double error = a * (0.005 + 0.015 * random.nextDouble());
      table.add(a + error * random.nextGaussian(), error, 1.5, 0);
    }
    LimitEstimate e =
        new AccelerationLimit(table, AccelerationLimit.Kind.BRAKING, SPEED, 6).estimate();
    assertThat(e.value()).isEqualTo(5, within(0.03));
    assertThat(e.reached()).isTrue();
    assertThat(Math.abs(e.value() - 5)).isLessThan(3 * e.standardError());
  }

  @Test
  void aLimitThatFewReachIsALowerBoundThatIsNotFalse() {
    Random random = new Random(12);
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < 800; i++) {
      double drawn = random.nextDouble();
      double a = 5 * (drawn < 0.07 ? 1 : drawn < 0.7 ? 0.85 : random.nextDouble() * 0.85);
      double error = a * (0.005 + 0.015 * random.nextDouble());
      table.add(a + error * random.nextGaussian(), error, 1.5, 0);
    }
    LimitEstimate e =
        new AccelerationLimit(table, AccelerationLimit.Kind.BRAKING, SPEED, 6).estimate();
    assertThat(e.reached()).isFalse();
    assertThat(e.value()).isEqualTo(5, within(0.1));
    assertThat(e.value() - 2 * e.standardError()).isLessThan(5);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.15, 0.3, 0.6})
  void torqueIsNamedAndSized(double coefficient) {
    AccelerationLimit found =
        new AccelerationLimit(
            table(4, coefficient, 0, 0.6, 800, new Random(7)),
            AccelerationLimit.Kind.ACCELERATION,
            SPEED,
            6);
    assertThat(found.deviations()).hasSize(1);
    LimitDeviation d = found.deviations().get(0);
    assertThat(d.effect()).isEqualTo(MovementEffect.TORQUE_LIMITED);
    assertThat(d.coefficient()).isEqualTo(coefficient, within(0.03));
    assertThat(d.shareAfter()).isGreaterThan(d.shareBefore());
    assertThat(found.estimate().value()).isEqualTo(4, within(0.06));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.15, 0.3, 0.6})
  void directionIsNamedAndSized(double coefficient) {
    AccelerationLimit found =
        new AccelerationLimit(
            table(4, 0, coefficient, 0.6, 800, new Random(8)),
            AccelerationLimit.Kind.BRAKING,
            SPEED,
            6);
    assertThat(found.deviations()).hasSize(1);
    LimitDeviation d = found.deviations().get(0);
    assertThat(d.effect()).isEqualTo(MovementEffect.DIRECTIONAL);
    assertThat(d.coefficient()).isEqualTo(coefficient, within(0.03));
    assertThat(d.seenIn()).isEqualTo("braking");
    assertThat(found.estimate().value()).isEqualTo(4, within(0.06));
  }

  @Test
  void bothTogetherMultiply() {
    AccelerationLimit found =
        new AccelerationLimit(
            table(4, 0.4, 0.4, 0.6, 1500, new Random(9)),
            AccelerationLimit.Kind.ACCELERATION,
            SPEED,
            6);
    assertThat(found.deviations()).hasSize(2);
    assertThat(found.deviations().get(0).coefficient()).isEqualTo(0.4, within(0.03));
    assertThat(found.deviations().get(1).coefficient()).isEqualTo(0.4, within(0.03));
    assertThat(found.estimate().value()).isEqualTo(4, within(0.08));
  }

  @Test
  void tooFewManoeuvresSayNothing() {
    AccelerationLimit found =
        new AccelerationLimit(
            table(4, 0, 0, 0.6, 8, new Random(1)), AccelerationLimit.Kind.ACCELERATION, SPEED, 6);
    assertThat(found.estimate().known()).isFalse();
    assertThat(found.estimate().note()).contains("15");
    assertThat(found.deviations()).isEmpty();
  }

  @Test
  void weakAndUncertainManoeuvresAreRefused() {
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    assertThat(table.add(0.1, 0.001, 1, 0)).isFalse();
    assertThat(table.add(2, 1, 1, 0)).isFalse();
    assertThat(table.add(Double.NaN, 0.1, 1, 0)).isFalse();
    assertThat(table.add(2, Double.NaN, 1, 0)).isFalse();
    assertThat(table.add(2, 0.1, 1, Double.NaN)).isTrue();
    assertThat(table.samples()).isEqualTo(1);
  }
}
