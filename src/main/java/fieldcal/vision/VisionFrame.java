package fieldcal.vision;

import java.util.List;

/**
 * What one camera saw in one image. Times count from the recording's {@link Epoch}.
 *
 * @param cameraId the camera
 * @param frameNumber the camera's running number of the image, unsigned 32 bit on the wire; 0 when absent
 * @param captureTime when the image was taken, s; the time of every detection in it
 * @param sentTime when vision sent the detections, s; NaN when absent
 * @param cameraClockTime when the image was taken on the camera's own clock, s since that clock's unknown zero; NaN when absent
 * @param balls what was taken for balls, in the message's order
 * @param robots robots of both teams, yellow first, in the message's order
 */
public record VisionFrame(
    int cameraId,
    long frameNumber,
    double captureTime,
    double sentTime,
    double cameraClockTime,
    List<BallDetection> balls,
    List<RobotDetection> robots) {

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException if a list or an element is null
   */
  public VisionFrame {
    balls = List.copyOf(balls);
    robots = List.copyOf(robots);
  }
}
