package fieldcal.gamelog;

import fieldcal.vision.VisionFrame;

/**
 * Judges the capture times of one camera against the recorder's clock.
 *
 * <p>A busy computer reads frames late, but none early, and never changes their order. So a clock jumped back where capture times go back, and it jumped forward where a frame comes sooner after its capture than
 * all before it. Either counts when it is more than {@link #MAX_STEP}. Such a frame waits for the next: if that agrees with it, the clock jumped; if not, the frame's time was damaged.
 */
final class CameraClock {
  /** A larger step is a jump of a clock, s: packets overtake each other, and their least delay changes, by tens of milliseconds. */
  static final double MAX_STEP = 0.5;

  /** Number of frames remembered to recognise duplicates, which follow the original closely. */
  private static final int REMEMBERED = 16;

  private final double[] captures = new double[REMEMBERED];
  private int remembered;
  private double lastCapture = Double.NEGATIVE_INFINITY;
  private double delay;

  /** Since the clock jumped last. */
  private double leastDelay = Double.POSITIVE_INFINITY;

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
    if (isSteady(lastCapture, leastDelay, frame.captureTime(), newDelay)) {
      remember(frame.captureTime(), newDelay);
      return Verdict.GOOD;
    }
    if (suspect != null
        && isSteady(suspect.captureTime(), suspectDelay(), frame.captureTime(), newDelay)) {
      return Verdict.JUMPED;
    }
    return Verdict.WAIT;
  }

  private static boolean isSteady(double before, double least, double capture, double newDelay) {
    // Before the first frame of all, the least delay is infinite.
    return capture >= before - MAX_STEP
        && (newDelay >= least - MAX_STEP || least == Double.POSITIVE_INFINITY);
  }

  private double suspectDelay() {
    return suspectReceived - suspect.captureTime();
  }

  /** How far the clock jumps with this frame, s. */
  double jump(VisionFrame frame, double received) {
    return delay - (received - frame.captureTime());
  }

  /** Accepts the frame that waited, and the one that agreed with it: later frames are compared with these. */
  void accept(VisionFrame waited, double waitedReceived, VisionFrame frame, double received) {
    leastDelay = Double.POSITIVE_INFINITY;
    remember(waited.captureTime(), waitedReceived - waited.captureTime());
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
    lastCapture = capture;
    delay = newDelay;
    leastDelay = Math.min(leastDelay, newDelay);
  }
}
