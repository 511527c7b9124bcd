package fieldcal.gamelog;

/** Watches the frames of one tracker. Memory is constant. */
final class TrackerObserver {
  /** Kicks whose starts differ by less are the same one, reported again with a better estimate, s: no ball is kicked twice within this time. */
  static final double SAME_KICK = 0.15;

  /** Delays that are distinguished, s: from an instant 1 s after the reception to one 4 s before it. */
  private static final double BIN = 0.0005;

  private static final int BINS = 10_000;
  private static final double LEAST = -1;

  private final String source;
  private final String uuid;
  private final long[] delays = new long[BINS];
  private long frames;
  private long balls;
  private long kicks;
  private double first = Double.NaN;
  private double last = Double.NaN;
  private double lastKick = Double.NEGATIVE_INFINITY;

  TrackerObserver(String source, String uuid) {
    this.source = source;
    this.uuid = uuid;
  }

  void add(TrackerFrame frame, double received) {
    frames++;
    first = frames == 1 ? received : first;
    last = received;
    balls += frame.ball().isPresent() ? 1 : 0;
    double bin = (received - frame.time() - LEAST) / BIN;
    delays[(int) Math.max(0, Math.min(BINS - 1, bin))]++;
    frame
        .kick()
        .ifPresent(
            kick -> {
              kicks += Math.abs(kick.start() - lastKick) > SAME_KICK ? 1 : 0;
              lastKick = kick.start();
            });
  }

  TrackerStatistics statistics() {
    double span = last - first;
    return new TrackerStatistics(
        source,
        uuid,
        frames,
        frames > 1 && span > 0 ? (frames - 1) / span : Double.NaN,
        delay(),
        (double) balls / frames,
        kicks);
  }

  private double delay() {
    long below = 0;
    int bin = 0;
    while (bin < BINS - 1 && 2 * (below + delays[bin]) < frames) {
      below += delays[bin++];
    }
    // The outermost bins also count all values beyond them: these are no delays, but clocks that
    // differ.
    return bin == 0 || bin == BINS - 1 ? Double.NaN : LEAST + (bin + 0.5) * BIN;
  }
}
