package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.calibration.CalibratedKick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The fits of a play whose cameras disagree: the first kicks, too, and judged as calibrate judges them. */
class LiveFitsTest {
  @TempDir Path directory;

  @Test
  void kicksUnderDisagreeingCamerasAreJudgedAsCalibrateDoes() throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 5).withChoice(false, 8).into(directory);
    SimulationSettings settings =
        VisionCharacter.apply(
            Set.of(VisionCharacter.SIMULTANEOUS, VisionCharacter.DISAGREEING),
            SimulationSettings.DEFAULT.withSeed(8));
    InteractiveField field =
        InteractiveField.of(settings, request.first(), request.second(), List.of());
    PlaySession session =
        new PlaySession(request, new EmbeddedPlayField(field, Double.POSITIVE_INFINITY), s -> {});
    PlayRun.Result result = PlayRun.run(session, directory, CalibrationSession.Progress.UNSEEN);

    List<KickResult> live = result.session().last().kicks();
    CalibrationOutcome calibrated = result.calibration().orElseThrow();
    assertThat(live).hasSameSizeAs(calibrated.calibration().kicks());
    for (KickResult kick : live) {
      // As published, kicks that cross from one camera to another fit to 10 mm and more.
      assertThat(kick.rmsMm()).isLessThan(4);
      CalibratedKick same =
          calibrated.calibration().kicks().stream()
              .filter(k -> Math.abs(k.fit().kick().time() - kick.played().time()) < 0.4)
              .findFirst()
              .orElseThrow();
      boolean determines =
          same.fit().modelEstimates().stream().allMatch(fieldcal.fit.Estimate::usable);
      assertThat(kick.good()).isEqualTo(same.selected() && determines);
      assertThat(kick.used()).isEqualTo(same.selected());
    }
  }
}
