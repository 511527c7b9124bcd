package fieldcal.kick;

/** Why the observations of a kick end. */
public enum KickEnd {
  /** The ball came to rest. */
  STOPPED,
  /** The ball crossed a field line. */
  LEFT_FIELD,
  /** A robot caught, deflected or kicked the ball again. */
  TOUCHED_ROBOT,
  /** No camera saw the ball any more, though it should have been on the field. */
  LOST,
  /** The recording ends, or has a gap, while the ball still moves. */
  RECORDING_ENDED;

  /**
   * The name in files.
   *
   * @return lower-case name with underscores
   */
  public String id() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }
}
