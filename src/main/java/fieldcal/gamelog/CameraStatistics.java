package fieldcal.gamelog;

/**
 * How well one camera works, as seen in a recording.
 *
 * @param id the camera
 * @param frames how many it sent, duplicates not counted
 * @param rate frames per second outside of gaps; NaN if too few
 * @param lostFrames how many are missing by their numbers, outside of gaps
 * @param gaps how often it was silent for more than {@link RecordingStatistics#GAP}
 * @param longestGap longest gap, s; 0 without gaps
 * @param jitter standard deviation of the capture times about an even pace, robust, s; NaN if too few
 * @param latency median delay from capture to reception, s; NaN if too few, or if the clocks differ by more than a delay can be
 * @param clockDifference mean of reception, on the recorder's clock, minus capture, on the camera's, s; the latency is a part of it; NaN without frames
 * @param clockRate seconds of the recorder's clock per second of the camera's; NaN if too little was seen
 * @param ballDetections how many balls, true and false, it reported
 * @param robotDetections how many robots it reported
 * @param ballNoise standard deviation per axis of the position of a resting ball, robust, m; NaN if none rested long enough
 * @param restingBlocks number of stretches of a resting ball from which that noise was estimated
 */
public record CameraStatistics(
    int id,
    long frames,
    double rate,
    long lostFrames,
    long gaps,
    double longestGap,
    double jitter,
    double latency,
    double clockDifference,
    double clockRate,
    long ballDetections,
    long robotDetections,
    double ballNoise,
    long restingBlocks) {

  /**
   * Whether the camera's clock and the recorder's show different times, by more than frames are delayed.
   *
   * @return true when the difference is above {@link ClockComparison#MAX_DELAY} or negative
   */
  public boolean clocksDiffer() {
    return ClockComparison.isNoDelay(clockDifference);
  }

  /**
   * The share of frames that is missing.
   *
   * @return 0 … 1; 0 without frames
   */
  public double loss() {
    return frames == 0 ? 0 : lostFrames / (double) (frames + lostFrames);
  }
}
