package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

/** Times of a session in words. A session lasts minutes, and the recordings of one carpet days. */
final class SessionTime {
  private static final double MINUTE = 60;
  private static final double HOUR = 3600;
  private static final double DAY = 86400;

  /** In a session's first minutes a tenth of one matters, s. */
  private static final double SHORT_SESSION = 1200;

  /** From two of a unit on, people say no smaller one: 90 minutes, but two hours. */
  private static final double OF_NEXT = 2;

  private SessionTime() {}

  /**
   * An instant from which on something holds.
   *
   * @param at s since the session's begin
   * @return for example "from 12.5 minutes into the session on"
   */
  static String from(double at) {
    return text("from %s into the session on", since(at));
  }

  /**
   * An instant.
   *
   * @param at s since the session's begin
   * @return for example "minute 12" or "3.5 hours into the session"
   */
  static String at(double at) {
    return at < OF_NEXT * HOUR ? "minute " + minute(at) : text("%s into the session", since(at));
  }

  /** A time in minutes, as precisely as it matters. */
  private static String minute(double at) {
    return Amount.decimals(at / MINUTE, at < SHORT_SESSION ? 1 : 0);
  }

  private static String since(double at) {
    if (at < MINUTE) {
      return Amount.decimals(at, 0) + " s";
    }
    if (at < OF_NEXT * HOUR) {
      return Amount.decimals(at / MINUTE, 1) + " minutes";
    }
    return at < OF_NEXT * DAY
        ? Amount.decimals(at / HOUR, 1) + " hours"
        : Amount.decimals(at / DAY, 1) + " days";
  }
}
