package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** A recording with a camera that hangs higher than published, so that the simple model leaves 14 mm, compared with itself. */
class AlikeFitsTest {
  /** So much the noise of a camera differs between two recordings that show it at rest for some seconds. */
  private static final double NOISIER = 1.1;

  private static final Path LOG =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."),
          "test-data",
          "world-chip-camera-height-error.log.gz");

  private static FieldRecording recorded;

  @BeforeAll
  static void calibrate() throws IOException {
    CalibrationOutcome outcome =
        new CalibrationSession(FitSettings.defaults())
            .run(
                CalibrationRequest.of(List.of(LOG), HandSelection.none(), List.of()),
                CalibrationSession.Progress.UNSEEN);
    recorded = FieldRecording.of(outcome, LogOpener.USUAL);
  }

  /** The same kicks, fitted with other weights of the cameras. */
  private static FieldRecording weighedOtherwise() {
    CalibrationOutcome o = recorded.calibration();
    Calibration c = o.calibration();
    CameraViews cameras = c.cameras();
    CameraViews other =
        cameras.map(v -> v.withNoise(v.id() == 1 ? NOISIER * v.noise() : v.noise() / NOISIER));
    List<KickFit> fits = AlikeFits.of(c.fitted(), cameras, other);
    CalibrationOutcome changed =
        new CalibrationOutcome(
            o.logs(),
            o.data(),
            o.initial(),
            o.selection(),
            o.commands(),
            Calibrator.judged(fits, other, c.seed()),
            o.extended(),
            o.surroundings(),
            o.forced(),
            o.finding());
    return new FieldRecording(changed, recorded.frames());
  }

  @Test
  void whatTheCamerasWeighIsNoDifferenceOfTheFields() {
    TwinCheck check = TwinCheck.of(recorded, weighedOtherwise());
    assertThat(check.found()).isEqualTo(check.kicks());
    assertThat(check.comparisons()).hasSizeGreaterThan(30);
    assertThat(check.sentences()).isEmpty();
  }

  @Test
  void fitsWithTheSameWeightsStayWhereTheyAre() {
    Calibration c = recorded.calibration().calibration();
    List<KickFit> again = AlikeFits.of(c.fitted(), c.cameras(), c.cameras());
    assertThat(again).hasSameSizeAs(c.fitted());
    for (int i = 0; i < again.size(); i++) {
      double before = c.fitted().get(i).rmsMm();
      assertThat(again.get(i).rmsMm()).isEqualTo(before, within(0.01 * before));
    }
  }
}
