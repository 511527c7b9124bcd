package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The spin of a kick is found again from its path. */
class SpinOfKickTest {
  /** Twice what the search stops at. */
  private static final double FOUND = 2e-4;

  private static ExtendedModel model(Effect... effects) {
    return new ExtendedModel(
        Optional.of(FlatModel.typical()), Optional.of(ChipModel.typical()), List.of(effects), 0);
  }

  private static FittedPath along(BallTrajectory path, KickKind kind) {
    return new FittedPath(SampleDiagnosis.adequate(1).kicks().get(0).kick(), kind, path);
  }

  /** The mean of the model is another than the kick's. */
  @ParameterizedTest
  @CsvSource({"flat, -0.45", "flat, 0.2", "chip, -0.3", "chip, 0.15"})
  void theWholeSpinOfAKick(String name, double spin) {
    boolean chip = name.equals("chip");
    ExtendedModel kicked = model(new KickSpin(spin));
    double time = SampleDiagnosis.adequate(1).kicks().get(0).after().kickTime();
    BallTrajectory path =
        chip ? kicked.chipPath(time, 0, 0, 3, 1, 2.5) : kicked.flatPath(time, 0, 0, 4, 1);
    SpinOfKick spins = new SpinOfKick(model(new KickSpin(-0.1, -0.25, true)));
    assertThat(spins.of(along(path, chip ? KickKind.CHIP : KickKind.FLAT)).orElseThrow())
        .isCloseTo(spin, within(FOUND));
  }

  @Test
  void kicksWithoutSpinHaveNone() {
    ExtendedModel sloping = model(new FieldSlope(0.3, 1));
    FittedPath kick = along(sloping.flatPath(0, 0, 0, 4, 1), KickKind.FLAT);
    assertThat(new SpinOfKick(sloping).of(kick)).isEmpty();
  }
}
