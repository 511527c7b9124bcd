package fieldcal.movement;

/** What the referee lets the robots do, as far as it matters for counting their movements. */
public enum PlayPhase {
  /** No message of a referee has come yet: everything counts. */
  UNKNOWN,
  /** The ball is in play: movements count. */
  RUNNING,
  /** The game is stopped; robots drive slowly: nothing counts. */
  STOPPED,
  /** Robots stand still: the noise of their detections shows. */
  HALTED,
  /** Half time, a timeout, or the end: people move the robots, nothing counts. */
  BREAK;

  /**
   * Whether movements count.
   *
   * @return true in play, and as long as no referee was heard
   */
  public boolean counts() {
    return this == UNKNOWN || this == RUNNING;
  }
}
