package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Data without noise: the closed forms are not right to less than the floor of the noise. */
class CleanDataTest {
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

  /** A ball that is seen for 0.4 s hardly rolls, however small its residuals are. */
  @Test
  void whatCleanDataDetermineIsJudgedByTheFloor() {
    IdealKicks source = new IdealKicks(CameraNoise.FLOOR);
    SplittableRandom random = new SplittableRandom(4);
    int undetermined = 0;
    for (int i = 0; i < KICKS; i++) {
      IdealKicks.Conditions clean = new IdealKicks.Conditions(1e-5, 0, 0);
      IdealKicks.Sample s = source.draw(KickKind.FLAT, i + 1, clean, random.split());
      Kick whole = s.kick();
      Kick cut =
          whole.withObservations(
              whole.observations().between(Double.NEGATIVE_INFINITY, whole.time() + 0.4));
      KickFit fit =
          FitSupport.fit(FitSupport.problem(s, cut, source.views(), random.split()), KickKind.FLAT);
      for (Estimate e : fit.estimates()) {
        undetermined += e.undetermined().isPresent() ? 1 : 0;
        if (e.usable()) {
          assertThat(e.standardError())
              .as("%s of %s", e.name(), fit)
              .isLessThanOrEqualTo(0.5 * e.parameter().scale());
        }
      }
    }
    assertThat(undetermined).isPositive();
  }
}
