package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.statistics.FieldStatistics;
import fieldcal.app.statistics.RecordedFrames;
import fieldcal.app.statistics.Statistic;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import fieldcal.gamelog.RecordingStatistics;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Cameras as a twin gets them. */
class CameraStudyTest {
  private static final Path LOG =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data/world-null-flat.log.gz");

  private static FieldRecording field;

  @BeforeAll
  static void read() throws IOException {
    field =
        FieldRecording.of(
            new CalibrationSession(FitSettings.defaults())
                .run(
                    CalibrationRequest.of(List.of(LOG), HandSelection.none(), List.of()),
                    CalibrationSession.Progress.UNSEEN),
            LogOpener.USUAL);
  }

  private static FieldRecording with(UnaryOperator<List<VisionFrame>> change) {
    RecordedFrames one = field.frames().get(0);
    Map<Integer, List<VisionFrame>> frames = new TreeMap<>();
    RecordingStatistics statistics = new RecordingStatistics();
    one.frames().forEach((id, list) -> frames.put(id, change.apply(list)));
    frames.values().forEach(list -> list.forEach(f -> statistics.onFrame(f, f.sentTime())));
    return new FieldRecording(
        field.calibration(),
        List.of(
            new RecordedFrames(
                one.log(), frames, statistics.cameras(), one.spans(), one.duplicates())));
  }

  private static List<VisionFrame> numbered(List<VisionFrame> frames, int step) {
    List<VisionFrame> all = new ArrayList<>();
    for (VisionFrame f : frames) {
      all.add(
          new VisionFrame(
              f.cameraId(),
              step * f.frameNumber(),
              f.captureTime(),
              f.sentTime(),
              f.cameraClockTime(),
              f.balls(),
              f.robots()));
    }
    return all;
  }

  /** Every fiftieth frame is lost, and a robot stands that is not always seen. */
  private static List<VisionFrame> imperfect(List<VisionFrame> frames) {
    Random random = new Random(3);
    List<VisionFrame> all = new ArrayList<>();
    for (int i = 0; i < frames.size(); i++) {
      VisionFrame f = frames.get(i);
      RobotDetection robot =
          new RobotDetection(
              new RobotId(Team.YELLOW, 1), 1 + 0.001 * random.nextGaussian(), 0, 0, 1, 0.15);
      if (i % 50 != 7) {
        all.add(
            new VisionFrame(
                f.cameraId(),
                f.frameNumber(),
                f.captureTime(),
                f.sentTime(),
                f.cameraClockTime(),
                f.balls(),
                i % 20 == 3 ? List.of() : List.of(robot)));
      }
    }
    return all;
  }

  private static List<InstalledCamera> cameras(FieldRecording of) {
    return new CameraStudy(of).cameras(CameraStudy.published(of));
  }

  private static List<Statistic> statistics(FieldRecording of) {
    return FieldStatistics.of(of, kick -> Optional.of("kick " + kick.id()));
  }

  /** Some systems count the frames of all cameras: of four cameras each number rises by 4. */
  @Test
  void framesThatAreCountedForAllCamerasAreNotLost() {
    FieldRecording alone = with(list -> imperfect(list));
    FieldRecording shared = with(list -> numbered(imperfect(list), 4));
    List<InstalledCamera> expected = cameras(alone);
    assertThat(expected.get(0).nuisance().frameDrop()).isBetween(0.015, 0.025);
    assertThat(expected.get(0).robotNoise()).isBetween(0.0008, 0.0012);
    assertThat(cameras(shared)).isEqualTo(expected);
    assertThat(statistics(shared)).isEqualTo(statistics(alone));
  }

  /** Of a camera that sent few frames the rate is not known; the others have theirs. */
  @Test
  void aCameraOfFewFramesIsLeftOut() {
    FieldRecording few =
        with(list -> list.get(0).cameraId() == 2 ? List.copyOf(list.subList(0, 10)) : list);
    CameraStudy study = new CameraStudy(few);
    assertThat(study.cameras(CameraStudy.published(few)))
        .extracting(InstalledCamera::id)
        .containsExactly(0, 1, 3);
    assertThat(study.notes())
        .contains("Camera 2 sent too few frames to tell its rate: the twin does not have it.");
  }
}
