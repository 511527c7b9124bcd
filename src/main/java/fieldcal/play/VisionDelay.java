package fieldcal.play;

/**
 * How late vision's frames arrive, and for how long none has arrived. The two are told apart: a vision that is late by a constant time is not silent. Both are measured on the receiver's own clock, from tick to tick. Not thread-safe.
 */
public final class VisionDelay {
  /** Weight of a frame's delay, once so many are known: half a second at 100 ticks per second. */
  private static final int REMEMBERED = 50;

  /** Whatever is later is as bad, s; a clock that was set may show any delay. */
  private static final double WORST = 1;

  private double newest = Double.NaN;
  private double silent = Double.POSITIVE_INFINITY;
  private double delay;
  private int heard;

  /** No frame has arrived yet. */
  public VisionDelay() {}

  /**
   * Takes the next tick.
   *
   * @param time now, s
   * @param visionTime when the frame that arrived last was captured, s, on the same clock; not finite when none has arrived
   * @param span since the last tick, s
   */
  public void update(double time, double visionTime, double span) {
    if (!Double.isFinite(visionTime) || visionTime == newest) {
      silent += span;
      return;
    }
    newest = visionTime;
    silent = 0;
    heard = Math.min(REMEMBERED, heard + 1);
    delay += (Math.max(0, Math.min(WORST, time - visionTime)) - delay) / heard;
  }

  /**
   * Mean time from the capture of a frame to its arrival.
   *
   * @return s; 0 before any frame
   */
  public double delay() {
    return delay;
  }

  /**
   * For how long no frame has arrived.
   *
   * @return s; infinite before any frame
   */
  public double silent() {
    return silent;
  }
}
