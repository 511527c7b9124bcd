package fieldcal.gamelog;

import fieldcal.vision.VisionFrame;

/**
 * Judges the capture times of one camera against the recorder's clock.
 *
 * <p>From frame to frame the delay between capture and reception hardly changes. A frame whose delay differs by more than
 * {@link #MAX_STEP} waits for the next: if that agrees with it, the clock jumped; if not, the frame's time was damaged.
 */
final class CameraClock {
  /** A larger step of the delay is a jump of a clock, s: networks and busy computers delay packets by tens of milliseconds. */
  static final double MAX_STEP = 0.5;

  /** Number of frames remembered to recognise duplicates, which follow the original closely. */
  private static final int REMEMBERED = 16;

  private final double[] captures = new double[REMEMBERED];
  private int remembered;
  private boolean started;
  private double delay;
  private VisionFrame suspect;
  private double suspectReceived;

  /** The verdict on a frame. */
  enum Verdict {
    /** As expected. */
    GOOD,
    /** A frame of this camera with the same time was received before. */
    DUPLICATE,
    /** Its time does not fit the frames before; the next one decides. */
    WAIT,
    /** The clock jumped with the frame before, which waits in {@link #takeSuspect()}. */
    JUMPED
  }

  Verdict judge(VisionFrame frame, double received) {
    if (isRemembered(frame.captureTime())) {
      return Verdict.DUPLICATE;
    }
    double newDelay = received - frame.captureTime();
    if (!started || Math.abs(newDelay - delay) <= MAX_STEP) {
      started = true;
      remember(frame.captureTime(), newDelay);
      return Verdict.GOOD;
    }
    if (suspect != null
        && Math.abs(newDelay - (suspectReceived - suspect.captureTime())) <= MAX_STEP) {
      return Verdict.JUMPED;
    }
    return Verdict.WAIT;
  }

  /** How far the clock jumps with this frame, s. */
  double jump(VisionFrame frame, double received) {
    return delay - (received - frame.captureTime());
  }

  /** Accepts a frame that was judged JUMPED, or the one that waited before it: later frames are compared with it. */
  void accept(VisionFrame frame, double received) {
    remember(frame.captureTime(), received - frame.captureTime());
  }

  void keepSuspect(VisionFrame frame, double received) {
    suspect = frame;
    suspectReceived = received;
  }

  boolean hasSuspect() {
    return suspect != null;
  }

  double suspectReceived() {
    return suspectReceived;
  }

  VisionFrame takeSuspect() {
    VisionFrame taken = suspect;
    suspect = null;
    return taken;
  }

  private boolean isRemembered(double capture) {
    for (int i = 0; i < Math.min(remembered, REMEMBERED); i++) {
      if (captures[i] == capture) {
        return true;
      }
    }
    return false;
  }

  private void remember(double capture, double newDelay) {
    captures[remembered % REMEMBERED] = capture;
    // Counted up to twice the size only, so that it never overflows.
    remembered = remembered + 1 < 2 * REMEMBERED ? remembered + 1 : REMEMBERED;
    delay = newDelay;
  }
}
