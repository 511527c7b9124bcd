package fieldcal.app.statistics;

import fieldcal.app.recording.LogOpener;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.LogProblem;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingStatistics;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.kick.Kick;
import fieldcal.vision.BallDetection;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;

/**
 * The frames of one recording, by camera, in order of their capture.
 *
 * @param log the recording
 * @param frames by camera id, in the order of the ids
 * @param cameras how well each camera works
 * @param spans stretches without a silence of all cameras, start and end, s since the epoch
 * @param duplicates frames that came twice
 */
public record RecordedFrames(
    Path log,
    Map<Integer, List<VisionFrame>> frames,
    List<CameraStatistics> cameras,
    List<double[]> spans,
    long duplicates) {
  /** A longer silence of all cameras divides a recording, s; as the search for kicks does. */
  private static final double SILENCE = 0.25;

  /** Copies the collections. {@inheritDoc} */
  public RecordedFrames {
    frames = Collections.unmodifiableMap(new TreeMap<>(frames));
    cameras = List.copyOf(cameras);
    spans = List.copyOf(spans);
  }

  /**
   * Reads a recording.
   *
   * @param log from where
   * @param epoch from which its times are to count
   * @param opener opens it
   * @return its frames
   * @throws IOException when it cannot be read; one line for the operator
   */
  public static RecordedFrames read(Path log, Epoch epoch, LogOpener opener) throws IOException {
    Map<Integer, List<VisionFrame>> frames = new TreeMap<>();
    RecordingStatistics statistics = new RecordingStatistics();
    List<double[]> spans = new ArrayList<>();
    try (RecordingReader reader = opener.recording(log, epoch)) {
      RecordingSummary summary =
          reader.read(
              new RecordingListener() {
                @Override
                public void onFrame(VisionFrame frame, double receivedTime) {
                  statistics.onFrame(frame, receivedTime);
                  frames.computeIfAbsent(frame.cameraId(), id -> new ArrayList<>()).add(frame);
                  extend(spans, frame.captureTime());
                }

                @Override
                public void onClockJump(int cameraId, double jump) {
                  statistics.onClockJump(cameraId, jump);
                }
              });
      return new RecordedFrames(
          log,
          frames,
          statistics.cameras(),
          spans,
          summary.problems().count(LogProblem.DUPLICATE_FRAME));
    }
  }

  private static void extend(List<double[]> spans, double time) {
    double[] last = spans.isEmpty() ? null : spans.get(spans.size() - 1);
    if (last == null || time > last[1] + SILENCE || time < last[0]) {
      spans.add(new double[] {time, time});
    } else {
      last[1] = Math.max(last[1], time);
    }
  }

  /**
   * How well a camera works.
   *
   * @param id the camera
   * @return empty when it sent no frame
   */
  public Optional<CameraStatistics> camera(int id) {
    return cameras.stream().filter(c -> c.id() == id).findFirst();
  }

  /**
   * Since when the ball had been lying where it was kicked from.
   *
   * @param time of the kick, s
   * @param x place, m
   * @param y place, m
   * @return the first detection of it there, s; empty when it did not lie there
   */
  public OptionalDouble restingSince(double time, double x, double y) {
    List<Double> there = new ArrayList<>();
    for (List<VisionFrame> list : frames.values()) {
      for (VisionFrame frame : list) {
        if (frame.captureTime() < time && RestStretches.near(frame, x, y).isPresent()) {
          there.add(frame.captureTime());
        }
      }
    }
    there.sort(null);
    double since = Double.NaN;
    for (int i = there.size() - 1; i >= 0; i--) {
      double after = Double.isNaN(since) ? time : since;
      if (after - there.get(i) > SILENCE) {
        break;
      }
      since = there.get(i);
    }
    return Double.isNaN(since) ? OptionalDouble.empty() : OptionalDouble.of(since);
  }

  /**
   * The balls of a frame, taken while a kick was observed, that are not the kick's.
   *
   * @param frame one of these
   * @param kick of this recording
   * @return false balls, and others
   */
  public List<BallDetection> strangeBalls(VisionFrame frame, Kick kick) {
    return FrameBlocks.strangeBalls(frame, kick.observations());
  }
}
