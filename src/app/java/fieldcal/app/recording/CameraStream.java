package fieldcal.app.recording;

import fieldcal.vision.VisionFrame;

/** Counts the balls of one camera and measures its frame rate, recording gaps left out. */
public final class CameraStream {
  /** Frames further apart than that have a gap between them: eight frames lost at 75 Hz. */
  private static final double GAP = 0.12;

  private long balls;
  private long intervals;
  private double sum;
  private double last = Double.NaN;

  CameraStream() {}

  void accept(VisionFrame frame) {
    balls += frame.balls().size();
    double dt = frame.captureTime() - last;
    if (dt > 0 && dt < GAP) {
      intervals++;
      sum += dt;
    }
    last = frame.captureTime();
  }

  /**
   * Balls detected, false ones included.
   *
   * @return count
   */
  public long balls() {
    return balls;
  }

  /**
   * Mean frame rate between gaps.
   *
   * @return Hz; NaN with fewer than two frames
   */
  public double rateHz() {
    return intervals > 0 ? intervals / sum : Double.NaN;
  }
}
