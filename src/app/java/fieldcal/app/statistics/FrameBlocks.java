package fieldcal.app.statistics;

import fieldcal.gamelog.FrameStep;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Intervals, losses and delays of frames, by stretches of two seconds. */
final class FrameBlocks {
  /** Length of a stretch, s: long enough for a hundred frames, short enough for dozens of stretches of a session. */
  private static final double LENGTH = 2;

  /** Fewest frames of a stretch. */
  private static final int FEWEST = 30;

  /** A detection so far from all that belongs to the kick is another ball, m. */
  private static final double APART = 0.25;

  /** Detections of the kick that are compared with it lie within that time, s: two frames of a slow camera. */
  private static final double TOGETHER = 0.03;

  private FrameBlocks() {}

  /**
   * A stretch.
   *
   * @param camera the camera
   * @param number of the stretch since the recording's begin
   * @param interval mean time between two frames that follow each other, s
   * @param scatter standard deviation of that, s
   * @param lost share of frames that are missing by their numbers
   * @param delay mean time from capture to sending, s; NaN when not reported
   */
  record Block(
      int camera, long number, double interval, double scatter, double lost, double delay) {}

  static List<Block> of(RecordedFrames frames) {
    List<Block> blocks = new ArrayList<>();
    double begin = frames.spans().isEmpty() ? 0 : frames.spans().get(0)[0];
    for (Map.Entry<Integer, List<VisionFrame>> camera : frames.frames().entrySet()) {
      FrameStep step = FrameStep.of(camera.getValue());
      List<VisionFrame> block = new ArrayList<>();
      long number = -1;
      for (VisionFrame frame : camera.getValue()) {
        long of = (long) Math.floor((frame.captureTime() - begin) / LENGTH);
        boolean jumped =
            !block.isEmpty()
                && frame.captureTime() - block.get(block.size() - 1).captureTime() > LENGTH / 4;
        if (of != number || jumped) {
          close(camera.getKey(), number, step, block, blocks);
          number = of;
        }
        block.add(frame);
      }
      close(camera.getKey(), number, step, block, blocks);
    }
    return blocks;
  }

  private static void close(
      int camera, long number, FrameStep step, List<VisionFrame> block, List<Block> blocks) {
    if (block.size() >= FEWEST) {
      int n = 0;
      double sum = 0;
      double squares = 0;
      double delay = 0;
      long missing = 0;
      for (int i = 1; i < block.size(); i++) {
        VisionFrame frame = block.get(i);
        long lost = step.missing(block.get(i - 1).frameNumber(), frame.frameNumber());
        double interval = frame.captureTime() - block.get(i - 1).captureTime();
        missing += lost;
        if (lost == 0) {
          n++;
          sum += interval;
          squares += interval * interval;
        }
        delay += frame.sentTime() - frame.captureTime();
      }
      double mean = sum / n;
      blocks.add(
          new Block(
              camera,
              number,
              mean,
              Math.sqrt(Math.max(0, (squares - n * mean * mean) / (n - 1))),
              missing / (double) (missing + block.size()),
              delay / (block.size() - 1)));
    }
    block.clear();
  }

  /** Balls per frame, from the beginning of a kick's detections to their end, that are not the kick's. */
  static double falseBalls(RecordedFrames frames, Kick kick) {
    Observations seen = kick.observations();
    double from = seen.size() == 0 ? kick.time() : seen.time(0);
    long count = 0;
    long strange = 0;
    for (List<VisionFrame> list : frames.frames().values()) {
      for (VisionFrame frame : list) {
        if (frame.captureTime() >= from && frame.captureTime() <= kick.endTime()) {
          count++;
          strange += strangeBalls(frame, seen).size();
        }
      }
    }
    return count == 0 ? Double.NaN : strange / (double) count;
  }

  /** The balls of a frame that are not a kick's. */
  static List<BallDetection> strangeBalls(VisionFrame frame, Observations seen) {
    return frame.balls().stream().filter(b -> isStrange(b, frame, seen)).toList();
  }

  private static boolean isStrange(BallDetection ball, VisionFrame frame, Observations seen) {
    int first = firstFrom(seen, frame.captureTime() - TOGETHER);
    boolean compared = false;
    for (int i = first; i < seen.size() && seen.time(i) <= frame.captureTime() + TOGETHER; i++) {
      compared = true;
      if (Math.hypot(ball.x() - seen.x(i), ball.y() - seen.y(i)) < APART) {
        return false;
      }
    }
    return compared;
  }

  private static int firstFrom(Observations seen, double time) {
    int low = 0;
    int high = seen.size();
    while (low < high) {
      int middle = (low + high) / 2;
      if (seen.time(middle) < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
