package fieldcal.app.cli;

import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.wording.LensWords;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.GameLogException;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingStatistics;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeState;
import fieldcal.gamelog.RefereeStatistics;
import fieldcal.gamelog.TrackerFrame;
import fieldcal.gamelog.TrackerStatistics;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * What {@code info} tells of a recording.
 *
 * @param file the log
 * @param summary what was read
 * @param cameras the cameras that sent frames
 * @param referee what the referee did
 * @param marked whether the recording says that its field was simulated
 * @param unseenShares by camera whose published lens is not usable, the share of its detections that the lens does not see
 * @param trackers teams and automatic referees that sent tracked frames
 */
record RecordingInfo(
    Path file,
    RecordingSummary summary,
    boolean marked,
    List<CameraStatistics> cameras,
    Optional<RefereeStatistics> referee,
    Map<Integer, Double> unseenShares,
    List<TrackerStatistics> trackers) {

  /** Reads the whole log. */
  static RecordingInfo of(Path file, LogOpener opener, TerminalProgress progress)
      throws IOException {
    try (RecordingReader reader = opener.recording(file)) {
      RecordingStatistics statistics = new RecordingStatistics();
      AtomicBoolean marked = new AtomicBoolean();
      LensWatch lenses = new LensWatch();
      RecordingSummary summary = read(reader, statistics, marked, lenses, progress);
      return new RecordingInfo(
          file,
          summary,
          marked.get(),
          statistics.cameras(),
          statistics.referee(),
          lenses.unusable(),
          statistics.trackers());
    }
  }

  private static RecordingSummary read(
      RecordingReader reader,
      RecordingStatistics statistics,
      AtomicBoolean marked,
      LensWatch lenses,
      TerminalProgress progress)
      throws GameLogException {
    return reader.read(
        new RecordingListener() {
          @Override
          public void onFrame(VisionFrame frame, double receivedTime) {
            statistics.onFrame(frame, receivedTime);
            lenses.accept(frame);
          }

          @Override
          public void onGeometry(FieldGeometry geometry) {
            lenses.geometry(geometry);
          }

          @Override
          public void onClockJump(int cameraId, double jump) {
            statistics.onClockJump(cameraId, jump);
          }

          @Override
          public void onSimulationMark() {
            marked.set(true);
          }

          @Override
          public void onReferee(RefereeState state, double receivedTime) {
            statistics.onReferee(state, receivedTime);
          }

          @Override
          public boolean wantsTrackers() {
            return true;
          }

          @Override
          public void onTracker(TrackerFrame frame, double receivedTime) {
            statistics.onTracker(frame, receivedTime);
          }

          @Override
          public void onProgress(long bytesRead, long totalBytes) {
            progress.at(bytesRead, totalBytes);
          }
        });
  }

  /** Whether the field counts as simulated, by the rule of the verdict. */
  boolean simulated() {
    return marked || Files.exists(truth());
  }

  /** Where the truth of a simulated field would be. */
  Path truth() {
    return RecordingFacts.truthOf(file);
  }

  /** What the operator should know of a camera's published geometry. */
  String note(CameraCalibration calibration) {
    Double unseen = unseenShares.get(calibration.id());
    return unseen != null
        ? LensWords.unseen(calibration.distortion(), unseen) + "; only its position is used"
        : Camera.faultOf(calibration).orElseGet(() -> Camera.of(calibration).consistency());
  }
}
