package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.kick.KickKind;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Errors of what the model explains, of what it does not, and of data without noise. */
class VarianceFactorTest {
  private static final int KICKS = 20;

  private static KickFit[] fits(IdealKicks source, KickKind kind, double noise) {
    SplittableRandom random = new SplittableRandom(4);
    KickFit[] fits = new KickFit[KICKS];
    for (int i = 0; i < KICKS; i++) {
      IdealKicks.Conditions conditions = new IdealKicks.Conditions(noise, 0, 0);
      IdealKicks.Sample s = source.draw(kind, i + 1, conditions, random.split());
      fits[i] = FitSupport.fit(FitSupport.problem(s, source.views(), random.split()), kind);
    }
    return fits;
  }

  private static double median(KickFit[] fits) {
    return Arrays.stream(fits)
        .mapToDouble(f -> f.statistics().varianceFactor())
        .sorted()
        .skip(KICKS / 2)
        .findFirst()
        .orElseThrow();
  }

  /** Of several lengths the largest is taken, so a little above one. */
  @ParameterizedTest
  @EnumSource(KickKind.class)
  void noiseLeavesErrorsAsTheyAre(KickKind kind) {
    IdealKicks source = new IdealKicks(FitSupport.CLEAN.noise());
    assertThat(median(fits(source, kind, FitSupport.CLEAN.noise()))).isBetween(0.9, 1.3);
  }

  /** Residuals of a bent path are alike for many frames: an error by their mean square would be far too small. */
  @ParameterizedTest
  @EnumSource(KickKind.class)
  void whatIsNotExplainedCountsMoreThanItsMeanSquare(KickKind kind) {
    IdealKicks source = new IdealKicks(FitSupport.CLEAN.noise());
    source.sideSpin(0.08);
    KickFit[] fits = fits(source, kind, FitSupport.CLEAN.noise());
    double meanSquare =
        Arrays.stream(fits)
            .mapToDouble(f -> f.statistics().reducedChiSquare())
            .sorted()
            .skip(KICKS / 2)
            .findFirst()
            .orElseThrow();
    assertThat(median(fits)).isGreaterThan(2 * meanSquare);
  }

  @Test
  void errorsFollowTheFloorOfTheNoiseNotTheResidual() {
    IdealKicks source = new IdealKicks(CameraNoise.FLOOR);
    KickFit[] floor = fits(source, KickKind.FLAT, CameraNoise.FLOOR);
    KickFit[] none = fits(source, KickKind.FLAT, 1e-5);
    for (int i = 0; i < KICKS; i++) {
      for (String name : List.of("accSlide", "accRoll", "kSwitch")) {
        Estimate e = none[i].estimate(name);
        if (e.usable()) {
          assertThat(e.standardError() / floor[i].estimate(name).standardError())
              .as("%s of %s", name, none[i])
              .isBetween(0.6, 1.2);
        }
      }
    }
  }
}
