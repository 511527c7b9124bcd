package fieldcal.app.net;

/**
 * How late frames come after their capture, by vision's clock and this machine's, and whether vision's clock has jumped. Frames can be held up on their way, but none comes before it was sent, and they keep their order. So the clock jumped back
 * where capture times go back, and forward where a frame comes sooner after its capture than all before it. What is only late may have been held up; if all that follow are as late, the clock was set back. Not thread-safe.
 */
final class FrameLateness {
  /** A clock whose distance from this machine's changes by more has jumped, s; frames that wait for each other in a computer or a network differ by less. */
  private static final double JUMP = 0.2;

  /** Frames that keep coming later for so long were not held up, s; networks that lose their route for that long are rare. */
  private static final double LASTS = 1;

  /** Frames are compared with those of one to two such spans before, s: long enough for {@link #LASTS}, and short enough that a clock with a wrong rate of 2 % does not jump. */
  private static final double REMEMBERED = 2 * LASTS;

  private Least before = Least.NONE;
  private Least now = Least.NONE;
  private double begin = Double.NEGATIVE_INFINITY;
  private double lastCaptured = Double.NEGATIVE_INFINITY;
  private double lastLow = Double.POSITIVE_INFINITY;
  private double lateSince = Double.NaN;
  private double leastLate;

  /**
   * The least lateness in some time lies between these.
   *
   * @param low s; of frames of which the arrival is known well enough
   * @param high s
   */
  private record Least(double low, double high) {
    static final Least NONE = new Least(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

    Least and(double otherLow, double otherHigh) {
      return new Least(Math.min(low, otherLow), Math.min(high, otherHigh));
    }
  }

  /** Whether a frame comes sooner after its capture than is possible unless the clock has jumped forward. */
  boolean isTooEarly(double captured, Arrival arrived) {
    double low = Math.min(lastLow, Math.min(before.low, now.low));
    return low < Double.POSITIVE_INFINITY && arrived.latest() - captured < low - JUMP;
  }

  /**
   * Takes the next frame.
   *
   * @param captured when it says it was captured, s
   * @param arrived when it came
   * @return by how much the clock has jumped, forward, s; 0 when it has not
   */
  double take(double captured, Arrival arrived) {
    double low = arrived.earliest() - captured;
    double high = arrived.latest() - captured;
    double least = Math.min(before.high, now.high);
    double jump = 0;
    if (captured < lastCaptured - JUMP || isTooEarly(captured, arrived)) {
      jump = least - high;
    } else if (low > least + JUMP) {
      boolean first = Double.isNaN(lateSince);
      lateSince = first ? arrived.latest() : lateSince;
      leastLate = first ? high : Math.min(leastLate, high);
      jump = arrived.latest() - lateSince > LASTS ? least - leastLate : 0;
    } else {
      lateSince = Double.NaN;
    }
    if (jump != 0) {
      before = Least.NONE;
      now = Least.NONE;
      lateSince = Double.NaN;
    } else if (arrived.latest() - begin > REMEMBERED) {
      before = now;
      now = Least.NONE;
      begin = arrived.latest();
    }
    // When a reader that paused found it, says little about when it came.
    now = now.and(high - low < JUMP ? low : Double.POSITIVE_INFINITY, high);
    lastCaptured = captured;
    lastLow = low;
    return jump;
  }
}
