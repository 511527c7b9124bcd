package fieldcal.movement;

/** What the referee lets the robots do, as far as it matters for counting their movements. */
public enum PlayPhase {
  /** Nobody has said anything yet: everything counts. */
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
   * @return true in play, and as long as nobody has told
   */
  public boolean counts() {
    return this == UNKNOWN || this == RUNNING;
  }
}
