package fieldcal.diagnosis.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.decision.Dependence.Form;
import fieldcal.diagnosis.decision.KickValues.Kick;
import fieldcal.effect.learned.Variable;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the values of the kicks follow: synthetic values of known curves and steps, and of none. */
class DependenceSearchTest {
  private static final double SESSION = 270;
  private static final double LIMIT = 1e-4;
  private static final double SCATTER = 0.1;

  /** Of values that scatter by one: a mean that all kickers share is no law. */
  private static final double MEAN = 20;

  /** Kicks in all directions over a field, at times that are as irregular as a session's. */
  private static List<Kick> kicks(int n, Random random) {
    List<Kick> all = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      all.add(
          new Kick(
              i,
              0,
              1,
              KickKind.FLAT,
              SESSION * (i + random.nextDouble()) / n,
              2 + 4 * random.nextDouble(),
              2 * Math.PI * random.nextDouble() - Math.PI,
              9 * random.nextDouble() - 4.5,
              6 * random.nextDouble() - 3));
    }
    return all;
  }

  private static KickValues with(List<Kick> kicks, ToDoubleFunction<Kick> value) {
    return new KickValues(
        0,
        kicks.stream()
            .map(
                k ->
                    new Kick(
                        k.index(),
                        value.applyAsDouble(k),
                        k.reliability(),
                        k.kind(),
                        k.time(),
                        k.speed(),
                        k.heading(),
                        k.x(),
                        k.y()))
            .toList());
  }

  private static Optional<Dependence> search(
      int n, long seed, double noise, ToDoubleFunction<Kick> law) {
    Random random = new Random(seed);
    return DependenceSearch.of(
        with(kicks(n, random), k -> law.applyAsDouble(k) + noise * random.nextGaussian()),
        LIMIT,
        seed);
  }

  /** A carpet that warms and cools, as often in a session as the recordings that the old regression called chance. */
  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1, 1.6, 2.2})
  void aWaveOverTheSessionIsFound(double waves) {
    for (int seed = 0; seed < 6; seed++) {
      double phase = 0.7 * seed;
      ToDoubleFunction<Kick> wave =
          k -> SCATTER * Math.sin(2 * Math.PI * waves * k.time() / SESSION + phase);
      Dependence found = search(30, seed, 0.2 * SCATTER, wave).orElseThrow();
      assertThat(found.on()).as("seed %d: %s", seed, found).isEqualTo(Variable.SESSION_TIME);
      assertThat(found.form()).as("seed %d: %s", seed, found).isNotEqualTo(Form.STEP);
      assertThat(found.explained()).isGreaterThan(0.7);
      assertThat(found.chance()).isLessThanOrEqualTo(LIMIT);
      assertThat(found.highest().value()).isCloseTo(SCATTER, within(0.7 * SCATTER));
    }
  }

  @Test
  void aSteadyDriftIsALine() {
    for (int seed = 0; seed < 6; seed++) {
      Dependence found = search(24, seed, 0.02, k -> 1e-3 * k.time()).orElseThrow();
      assertThat(found.on()).isEqualTo(Variable.SESSION_TIME);
      assertThat(found.form()).as("seed %d: %s", seed, found).isEqualTo(Form.LINE);
      assertThat(found.change()).isCloseTo(1e-3, within(3e-4));
      assertThat(found.lowest().x()).isLessThan(found.highest().x());
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {60, 135, 220})
  void aStepIsFoundWhereItIs(double at) {
    for (int seed = 0; seed < 6; seed++) {
      Dependence found = search(28, seed, 0.02, k -> k.time() < at ? 0 : -0.15).orElseThrow();
      assertThat(found.form()).as("seed %d: %s", seed, found).isEqualTo(Form.STEP);
      assertThat(found.place()).isCloseTo(at, within(SESSION / 28));
      assertThat(found.change()).isCloseTo(-0.15, within(0.04));
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Variable.class,
      names = {"SPEED", "HEADING", "PLACE"})
  void otherQuantitiesAreFoundByTheirNames(Variable on) {
    for (int seed = 0; seed < 6; seed++) {
      ToDoubleFunction<Kick> law =
          k ->
              switch (on) {
                case SPEED -> 0.05 * (k.speed() - 4) * (k.speed() - 4);
                case HEADING -> SCATTER * Math.cos(2 * k.heading() - 1);
                default -> 0.03 * k.x() + 0.01 * k.x() * k.y();
              };
      Dependence found = search(36, seed, 0.02, law).orElseThrow();
      assertThat(found.on()).as("seed %d: %s", seed, found).isEqualTo(on);
      assertThat(found.form()).isEqualTo(Form.CURVE);
    }
  }

  @Test
  void aStraightLineOverTheSpeedSaysByHowMuch() {
    Dependence found = search(25, 1, 0.01, k -> -0.04 * k.speed()).orElseThrow();
    assertThat(found.on()).isEqualTo(Variable.SPEED);
    assertThat(found.form()).isEqualTo(Form.LINE);
    assertThat(found.change()).isCloseTo(-0.04, within(0.005));
  }

  /** Spins that a ball only seems to have grow with its speed; another ball has others. Neither explains much alone. */
  @Test
  void whatFollowsTheSpeedWithEitherBallIsFound() {
    for (int seed = 0; seed < 6; seed++) {
      ToDoubleFunction<Kick> law = k -> -0.02 * k.speed() - (k.time() < 90 ? 0 : 0.05);
      Dependence found = search(17, seed, 0.004, law).orElseThrow();
      assertThat(found.explained()).as("seed %d: %s", seed, found).isGreaterThan(0.9);
      if (found.on() == Variable.SPEED) {
        assertThat(found.form()).isEqualTo(Form.LINE);
        assertThat(found.change()).isCloseTo(-0.02, within(0.01));
      } else {
        assertThat(found.form()).isEqualTo(Form.STEP);
        assertThat(found.change()).isCloseTo(-0.05, within(0.02));
        assertThat(found.place()).isCloseTo(90, within(SESSION / 17));
      }
    }
  }

  /** A kick that was cut off badly, or has a wrong number of hops. */
  @Test
  void aKickFarOffDoesNotHideTheRest() {
    for (int seed = 0; seed < 6; seed++) {
      Random random = new Random(seed);
      List<Kick> kicks = kicks(36, random);
      Kick off = kicks.get(13);
      KickValues values =
          with(
              kicks,
              k ->
                  k == off
                      ? -6 * SCATTER
                      : SCATTER * Math.sin(2 * Math.PI * k.time() / SESSION + 1));
      Dependence found = DependenceSearch.of(values, LIMIT, seed).orElseThrow();
      assertThat(found.on()).as("seed %d: %s", seed, found).isEqualTo(Variable.SESSION_TIME);
      assertThat(found.lowest().value()).isBetween(-1.5 * SCATTER, -0.5 * SCATTER);
      assertThat(found.highest().value()).isBetween(0.5 * SCATTER, 1.5 * SCATTER);
    }
  }

  /** How values that follow nothing are distributed. */
  private enum Chance {
    NORMAL,
    /** A few kicks far off. */
    HEAVY_TAILS,
    /** Two balls in turns that nobody recorded. */
    TWO_VALUES,
    /** Slow kicks show their value less than fast ones, and are drawn to the mean. */
    DRAWN_TO_THE_MEAN;

    KickValues values(Random random) {
      List<Kick> kicks = kicks(18 + random.nextInt(26), random);
      if (this == DRAWN_TO_THE_MEAN) {
        List<Kick> drawn = new ArrayList<>();
        for (Kick k : kicks) {
          double r = Math.min(1, 0.03 * k.speed() * k.speed());
          double value = MEAN + r * random.nextGaussian() / Math.sqrt(r);
          drawn.add(
              new Kick(
                  k.index(), value, r, k.kind(), k.time(), k.speed(), k.heading(), k.x(), k.y()));
        }
        return new KickValues(MEAN, drawn);
      }
      return with(
          kicks,
          k ->
              switch (this) {
                case HEAVY_TAILS -> Math.pow(random.nextGaussian(), 5);
                case TWO_VALUES -> random.nextBoolean() ? 1 : -1;
                default -> random.nextGaussian();
              });
    }
  }

  /** The level holds at a limit that few enough seeds can show; the search is the same at any. */
  @ParameterizedTest
  @EnumSource(Chance.class)
  void chanceIsTakenForALawAsRarelyAsPromised(Chance chance) {
    int seeds = 2000;
    double limit = 0.01;
    int alarms = 0;
    for (int seed = 0; seed < seeds; seed++) {
      KickValues values = chance.values(new Random(seed));
      alarms += DependenceSearch.of(values, limit, seed).isPresent() ? 1 : 0;
    }
    double error = Math.sqrt(seeds * limit * (1 - limit));
    assertThat((double) alarms).isLessThan(seeds * limit + 3 * error);
    assertThat((double) alarms).as("nor is it blind").isGreaterThan(0.4 * seeds * limit);
  }

  @Test
  void atTheLimitInUseChanceStaysChance() {
    for (int seed = 0; seed < 1000; seed++) {
      for (Chance chance : Chance.values()) {
        Optional<Dependence> found =
            DependenceSearch.of(chance.values(new Random(seed)), LIMIT, seed);
        // Four thousand tries at 1e-4 give none with a chance of two thirds; these seeds do.
        assertThat(found).as("%s, seed %d", chance, seed).isEmpty();
      }
    }
  }

  @Test
  void fewKicksOrEqualOnesShowNothing() {
    assertThat(search(5, 1, 0, Kick::time)).isEmpty();
    assertThat(search(30, 1, 0, k -> 0.2)).isEmpty();
  }

  /** What a kick does not show is only what the others lead one to expect. */
  @Test
  void kicksThatDoNotShowTheirValueDoNotCount() {
    Random random = new Random(3);
    List<Kick> kicks = new ArrayList<>();
    for (Kick k : kicks(30, random)) {
      kicks.add(
          new Kick(
              k.index(),
              1e-3 * k.time(),
              1,
              k.kind(),
              k.time(),
              k.speed(),
              k.heading(),
              k.x(),
              k.y()));
      kicks.add(
          new Kick(
              k.index(), 0, 0.01, k.kind(), k.time() + 1, k.speed(), k.heading(), k.x(), k.y()));
    }
    Dependence found = DependenceSearch.of(new KickValues(0, kicks), LIMIT, 1).orElseThrow();
    assertThat(found.form()).isEqualTo(Form.LINE);
    assertThat(found.explained()).isGreaterThan(0.999);
  }
}
