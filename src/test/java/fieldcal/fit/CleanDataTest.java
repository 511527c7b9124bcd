package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

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
}
