package fieldcal.vision;

import java.util.List;

/** Frames in which something else was seen than in others. */
public final class ChangedFrame {
  private ChangedFrame() {}

  /** The same with these balls. */
  public static VisionFrame withBalls(VisionFrame frame, List<BallDetection> balls) {
    return with(frame, balls, frame.robots());
  }

  /** The same with these balls and robots. */
  public static VisionFrame with(
      VisionFrame frame, List<BallDetection> balls, List<RobotDetection> robots) {
    return new VisionFrame(
        frame.cameraId(),
        frame.frameNumber(),
        frame.captureTime(),
        frame.sentTime(),
        frame.cameraClockTime(),
        balls,
        robots);
  }
}
