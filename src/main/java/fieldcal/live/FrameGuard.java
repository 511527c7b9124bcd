package fieldcal.live;

/**
 * Rejects frames whose time does not fit those of the others, and recognises when the clock has restarted: after vision was off, a clock was set, or a recording started again.
 */
final class FrameGuard {
  /** The times of two cameras never differ by more through delays, s; after a longer silence time is taken to restart. */
  private static final double APART = 1;

  /** Number of frames in a row that agree with each other but not with those before, after which the clock has restarted; a stray frame stands alone. */
  private static final int AGREE = 3;

  private double now = Double.NaN;
  private double suspect;
  private int agreeing;

  /** What to do with a frame. */
  enum Verdict {
    /** Take it. */
    TAKE,
    /** Leave it out. */
    LEAVE,
    /** Take it, and conclude nothing from what was before. */
    RESTART
  }

  Verdict judge(double time) {
    if (!Double.isFinite(time)) {
      return Verdict.LEAVE;
    }
    if (Double.isNaN(now) || Math.abs(time - now) < APART) {
      now = Double.isNaN(now) ? time : Math.max(now, time);
      agreeing = 0;
      return Verdict.TAKE;
    }
    agreeing = agreeing > 0 && Math.abs(time - suspect) < APART ? agreeing + 1 : 1;
    suspect = time;
    if (agreeing < AGREE) {
      return Verdict.LEAVE;
    }
    now = time;
    agreeing = 0;
    return Verdict.RESTART;
  }

  /** Time of the newest frame, s; NaN before the first. */
  double now() {
    return now;
  }
}
