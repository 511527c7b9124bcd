package fieldcal.live;

/**
 * Keeps out frames whose time does not fit to that of others, and recognises when time begins again: a vision that was off, a clock that was set, a recording that starts again.
 */
final class FrameGuard {
  /** Cameras and the network are never that far apart; a longer silence is a new beginning, s. */
  private static final double APART = 1;

  /** So many frames in a row that agree with each other but not with those before are a new time; a stray one is alone. */
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
