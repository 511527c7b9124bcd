package fieldcal.ball;

/** What a ball is doing. A phase begins at its first instant: at the time of an impact the ball has already bounced. */
public enum Phase {
  /** Lies where it will be kicked. */
  RESTING_BEFORE_KICK,
  /** In the air, between two contacts with the carpet. */
  FLYING,
  /** On the carpet, its surface slipping over it. */
  SLIDING,
  /** On the carpet, without slip. */
  ROLLING,
  /** Lies where it came to rest. */
  STOPPED
}
