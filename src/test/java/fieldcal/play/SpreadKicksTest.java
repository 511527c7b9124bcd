package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which kicks are made again, and how fast. */
class SpreadKicksTest {
  private static final double SLOWEST = 2;
  private static final double FASTEST = 6.5;

  /** The speeds of all kicks until there are twelve good ones, or forty kicks. */
  private static List<Double> speeds(DoublePredicate good) {
    SpreadKicks kicks = new SpreadKicks(12, SLOWEST, FASTEST, 0, 5);
    List<Double> made = new ArrayList<>();
    for (int counted = 0; counted < 12 && made.size() < 40; ) {
      PlannedKick kick = kicks.next();
      boolean counts = good.test(kick.speed());
      counted += counts ? 1 : 0;
      made.add(kick.speed());
      kicks.done(kick, counts);
    }
    return made;
  }

  /** On grSim only kicks above some 4.4 m/s slide for long enough, and the middle of the range, 4.25 m/s, is none. */
  @ParameterizedTest
  @CsvSource({"4.4, 9", "5, 9", "2, 4.1", "3, 5"})
  void theyMoveToTheSpeedsThatCount(double from, double to) {
    List<Double> made = speeds(v -> v >= from && v <= to);
    assertThat(made.stream().filter(v -> v >= from && v <= to)).hasSize(12);
    // A play gives up after 2 · 12 + 10 kicks that do not count.
    assertThat(made).hasSizeLessThan(34);
    assertThat(made).allMatch(v -> v >= SLOWEST && v <= FASTEST);
  }

  @Test
  void whileNoneIsGoodTheyMoveToTheMiddle() {
    SpreadKicks kicks = new SpreadKicks(1, SLOWEST, FASTEST, 0, 5);
    PlannedKick middle = kicks.next();
    kicks.done(new PlannedKick(2, 0, false), false);
    assertThat(kicks.next()).isEqualTo(new PlannedKick(2 + 0.3 * 2.25, 0, false));
    assertThat(middle).isEqualTo(new PlannedKick(4.25, 0, false));
  }

  @Test
  void whatTurnsOutBadLaterIsNoGoodSpeed() {
    SpreadKicks kicks = new SpreadKicks(1, SLOWEST, FASTEST, 0, 5);
    kicks.next();
    kicks.done(new PlannedKick(6, 0, false), true);
    kicks.done(new PlannedKick(3, 0, true), true);
    kicks.done(new PlannedKick(6, 0, false), false);
    assertThat(kicks.next()).isEqualTo(new PlannedKick(4.5, 0, false));
  }

  /** A kicker that gives some kicks a fifth less, as in grSim: one slow kick counts by chance, and the others must not stay beside it. */
  @Test
  void oneLuckySlowKickDoesNotHoldTheOthers() {
    Random random = new Random(6);
    List<Double> made = speeds(v -> v * (random.nextBoolean() ? 1 : 0.8) > 4.4);
    assertThat(made).hasSizeLessThan(34);
  }

  /** A ball that somebody touched says nothing of the speed: the range stays covered. */
  @Test
  void chanceDoesNotNarrowTheRange() {
    Random random = new Random(3);
    List<Double> good = new ArrayList<>();
    speeds(
        v -> {
          boolean counts = random.nextDouble() < 0.7;
          if (counts) {
            good.add(v);
          }
          return counts;
        });
    assertThat(good).hasSize(12);
    assertThat(good.stream().filter(v -> v < 3.5)).hasSizeGreaterThanOrEqualTo(2);
    assertThat(good.stream().filter(v -> v > 5)).hasSizeGreaterThanOrEqualTo(2);
  }

  @Test
  void afterABallLeftTheImagesKicksAreSlower() {
    SpreadKicks kicks = new SpreadKicks(12, SLOWEST, FASTEST, 0.8, 5);
    kicks.outOfView(new PlannedKick(4.5, 0.8, false));
    // A slow kick that turns out bad goes to the middle of the range, or as near to it as is in
    // view.
    kicks.done(new PlannedKick(4.4, 0.8, false), false);
    for (int i = 0; i < 14; i++) {
      PlannedKick kick = kicks.next();
      assertThat(kick.speed()).isBetween(SLOWEST, 4.49);
      assertThat(kick.elevation()).isEqualTo(0.8);
    }
  }

  /** Nothing of the range is of use then. */
  @Test
  void whereEvenTheSlowestLeavesTheImagesKicksAreSlowerThanTheRange() {
    SpreadKicks kicks = new SpreadKicks(3, SLOWEST, FASTEST, 0.8, 5);
    kicks.outOfView(new PlannedKick(SLOWEST, 0.8, false));
    assertThat(kicks.next().speed()).isEqualTo(0.7 * SLOWEST);
  }
}
