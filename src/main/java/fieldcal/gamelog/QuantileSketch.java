package fieldcal.gamelog;

/**
 * Quantiles of positive numbers in constant memory: counts in bins of equal ratio, interpolated within a bin.
 *
 * <p>The relative error is below the bin's width (1 %); values out of range count at its ends.
 */
final class QuantileSketch {
  private static final int BINS_PER_E = 100;

  private final double min;
  private final long[] counts;
  private long total;

  QuantileSketch(double min, double max) {
    this.min = min;
    counts = new long[(int) Math.ceil(BINS_PER_E * Math.log(max / min)) + 1];
  }

  void add(double value) {
    double bin = value <= min ? 0 : BINS_PER_E * Math.log(value / min);
    counts[(int) Math.min(bin, counts.length - 1)]++;
    total++;
  }

  long total() {
    return total;
  }

  /** NaN without values. */
  double quantile(double fraction) {
    if (total == 0) {
      return Double.NaN;
    }
    double wanted = fraction * total;
    long below = 0;
    int bin = 0;
    while (bin < counts.length - 1 && below + counts[bin] < wanted) {
      below += counts[bin++];
    }
    double within = counts[bin] == 0 ? 0 : (wanted - below) / counts[bin];
    return min * Math.exp((bin + within) / BINS_PER_E);
  }
}
