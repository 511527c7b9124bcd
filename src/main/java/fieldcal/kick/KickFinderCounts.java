package fieldcal.kick;

/** What a {@link KickFinder} skipped, for the operator's report. */
public final class KickFinderCounts {
  int staleFrames;
  int clockJumps;
  int recordingGaps;
  int tooShort;
  int deflections;
  int carried;

  KickFinderCounts() {}

  /**
   * Frames that were duplicates, or older than an earlier frame of the same camera.
   *
   * @return count
   */
  public int staleFrames() {
    return staleFrames;
  }

  /**
   * How often a camera's clock jumped back by more than a second; tracking restarted.
   *
   * @return count
   */
  public int clockJumps() {
    return clockJumps;
  }

  /**
   * How often all cameras were silent for more than a quarter of a second.
   *
   * @return count
   */
  public int recordingGaps() {
    return recordingGaps;
  }

  /**
   * Kicks of which too little was seen.
   *
   * @return count
   */
  public int tooShort() {
    return tooShort;
  }

  /**
   * Balls that bounced off a robot without being kicked.
   *
   * @return count
   */
  public int deflections() {
    return deflections;
  }

  /**
   * Balls that gained speed but stayed at their robot: dribbled or pushed.
   *
   * @return count
   */
  public int carried() {
    return carried;
  }
}
