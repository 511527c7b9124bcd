package fieldcal.app.statistics;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.kick.Kick;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Recordings of one field: kicks, fits and all frames.
 *
 * @param calibration of these recordings
 * @param frames of each recording, in their order
 */
public record FieldRecording(CalibrationOutcome calibration, List<RecordedFrames> frames) {

  /** Copies the list. {@inheritDoc} */
  public FieldRecording {
    frames = List.copyOf(frames);
  }

  /**
   * Reads the frames of what was calibrated.
   *
   * @param calibration of some recordings
   * @param opener opens them
   * @return with their frames
   * @throws IOException when a recording cannot be read
   */
  public static FieldRecording of(CalibrationOutcome calibration, LogOpener opener)
      throws IOException {
    List<RecordedFrames> frames = new ArrayList<>();
    for (RecordingFacts used : calibration.data().recordings()) {
      frames.add(RecordedFrames.read(used.log(), calibration.data().epoch(), opener));
    }
    return new FieldRecording(calibration, frames);
  }

  /**
   * The kicks of one recording.
   *
   * @param one of {@link #frames}
   * @return in order of time
   */
  public List<Kick> kicks(RecordedFrames one) {
    return calibration.data().kicks().stream()
        .filter(k -> one.log().toString().equals(calibration.data().sources().get(k.id())))
        .toList();
  }
}
