package fieldcal.gamelog;

/**
 * What one tracker sent in a recording.
 *
 * @param source what it calls itself; empty when it does not say
 * @param uuid distinguishes trackers of the same name
 * @param frames how many frames it sent
 * @param rate frames per second between its first and its last one; NaN with fewer than two
 * @param delay median time from the instant that a frame is of to its reception, s; NaN when their clocks differ by seconds
 * @param ballShare share of the frames that have a ball
 * @param kicks how many different kicks it reported
 */
public record TrackerStatistics(
    String source,
    String uuid,
    long frames,
    double rate,
    double delay,
    double ballShare,
    long kicks) {}
