package fieldcal.live;

import fieldcal.vision.VisionFrame;
import java.util.OptionalInt;

/** Counts the frames of one camera and measures its rate, in constant memory. */
final class CameraWatch {
  /** Longer silence is a gap: eighteen frames at 75 Hz, s. */
  private static final double GAP = 0.25;

  /** The rate is a mean over some 64 frames, somewhat less than a second. */
  private static final double GAIN = 1.0 / 64;

  private final int id;
  private long frames;
  private long repeated;
  private long intervals;
  private double interval = Double.NaN;
  private double last = Double.NaN;
  private long gaps;
  private double longestGap;
  private final BallNoise noise = new BallNoise();
  private long balls;
  private long robots;

  CameraWatch(int id) {
    this.id = id;
  }

  void accept(VisionFrame frame) {
    double step = frame.captureTime() - last;
    if (step <= 0) {
      repeated++;
      return;
    }
    frames++;
    noise.accept(frame);
    balls += frame.balls().size();
    robots += frame.robots().size();
    last = frame.captureTime();
    if (step > GAP) {
      gaps++;
      longestGap = Math.max(longestGap, step);
    } else if (step > 0) {
      // The arithmetic mean until there are enough frames for the running one.
      intervals++;
      double gain = Math.max(GAIN, 1.0 / intervals);
      interval = intervals == 1 ? step : interval + gain * (step - interval);
    }
  }

  /** The clock has restarted: the next frame is on the new clock. */
  void restart() {
    last = Double.NaN;
    noise.restart();
  }

  CameraHealth health(
      double now, CameraAlignment.Known known, double apart, OptionalInt apartFrom) {
    return new CameraHealth(
        id,
        frames,
        repeated,
        1 / interval,
        Double.isNaN(last) ? Double.NaN : Math.max(0, now - last),
        gaps,
        longestGap,
        balls,
        robots,
        1000 * noise.noise(),
        1000 * known.offsetX(),
        1000 * known.offsetY(),
        1000 * apart,
        apartFrom,
        known.calibrated());
  }
}
