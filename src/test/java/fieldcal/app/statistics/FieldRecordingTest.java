package fieldcal.app.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.replay.KickReplay;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FieldRecordingTest {
  private static final Path LOG =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data/grsim-ball-chip.log.gz");

  @TempDir private Path folder;

  /** As of its kicks; else a twin would get the noise of a copy that has no kick. */
  @Test
  void theFramesOfACopyAreReadOnce() throws IOException {
    Path copy = Files.copy(LOG, folder.resolve("copy.log.gz"));
    CalibrationOutcome twice = calibrated(List.of(LOG, copy, LOG));
    FieldRecording field = FieldRecording.of(twice, LogOpener.USUAL);
    assertThat(field.frames()).extracting(RecordedFrames::log).containsExactly(LOG);
    assertThat(field.kicks(field.frames().get(0))).isNotEmpty();

    Path replay = folder.resolve("twice.mcap");
    new KickReplay(twice, LogOpener.USUAL).write(replay);
    Path once = folder.resolve("once.mcap");
    new KickReplay(calibrated(List.of(LOG)), LogOpener.USUAL).write(once);
    assertThat(replay).hasSameBinaryContentAs(once);
  }

  private static CalibrationOutcome calibrated(List<Path> logs) throws IOException {
    return new CalibrationSession(FitSettings.defaults())
        .run(
            CalibrationRequest.of(logs, HandSelection.none(), List.of()),
            CalibrationSession.Progress.UNSEEN);
  }
}
