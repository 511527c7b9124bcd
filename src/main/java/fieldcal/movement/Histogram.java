package fieldcal.movement;

import java.util.Arrays;

/**
 * Counts values in bins of equal width from zero on. Two histograms with the same bins merge exactly, in any order. Mutable, for one thread.
 *
 * <p>A value belongs to the bin that it lies in, not to the nearest left edge, and a percentile is interpolated within its bin, so neither is off by half a bin. Values beyond the last bin are counted as such and belong to every percentile; those below zero and NaN are refused.
 */
public final class Histogram {
  private final double width;
  private final long[] counts;
  private long beyond;
  private long samples;

  /**
   * An empty histogram over [0, width·bins).
   *
   * @param width of a bin, in the unit of the values
   * @param bins number of bins
   * @throws IllegalArgumentException when the width is not positive and finite, or there is no bin
   */
  public Histogram(double width, int bins) {
    if (!(width > 0 && width < Double.POSITIVE_INFINITY) || bins < 1) {
      throw new IllegalArgumentException(
          "bins need a positive width and number, not " + width + " and " + bins);
    }
    this.width = width;
    counts = new long[bins];
  }

  /**
   * Counts a value.
   *
   * @param value to count
   * @return false, and nothing counted, when it is negative or NaN
   */
  public boolean add(double value) {
    if (!(value >= 0)) {
      return false;
    }
    double bin = value / width;
    if (bin < counts.length) {
      counts[(int) bin]++;
    } else {
      beyond++;
    }
    samples++;
    return true;
  }

  /**
   * Adds all that another histogram has counted.
   *
   * @param other of the same bins; stays as it is
   * @throws IllegalArgumentException when its bins differ
   */
  public void merge(Histogram other) {
    if (other.width != width || other.counts.length != counts.length) {
      throw new IllegalArgumentException(
          "bins differ: %d of %s and %d of %s"
              .formatted(counts.length, width, other.counts.length, other.width));
    }
    for (int i = 0; i < counts.length; i++) {
      counts[i] += other.counts[i];
    }
    beyond += other.beyond;
    samples += other.samples;
  }

  /** Reports each bin that is not empty, and finally, with the number {@link #bins}, the count beyond the last bin. */
  void cells(MovementCells.Sink sink) {
    for (int i = 0; i < counts.length; i++) {
      if (counts[i] > 0) {
        sink.cell(i, (i + 0.5) * width, Double.NaN, counts[i]);
      }
    }
    if (beyond > 0) {
      sink.cell(counts.length, Double.NaN, Double.NaN, beyond);
    }
  }

  /** Adds what {@link #cells} reported; false when there is no such bin. */
  boolean addCell(int bin, long count) {
    if (bin < 0 || bin > counts.length || count < 0) {
      return false;
    }
    if (bin == counts.length) {
      beyond += count;
    } else {
      counts[bin] += count;
    }
    samples += count;
    return true;
  }

  /** Forgets everything. */
  public void clear() {
    Arrays.fill(counts, 0);
    beyond = 0;
    samples = 0;
  }

  /**
   * The value below which a share of all values lies, taken as evenly spread within each bin.
   *
   * @param share 0 … 1
   * @return in the unit of the values; the upper end of the last bin when the percentile lies beyond it; NaN without values
   * @throws IllegalArgumentException when the share is not in [0, 1] or NaN
   */
  public double percentile(double share) {
    if (!(share >= 0 && share <= 1)) {
      throw new IllegalArgumentException("share must lie in [0, 1], but is " + share);
    }
    if (samples == 0) {
      return Double.NaN;
    }
    double wanted = share * samples;
    double below = 0;
    for (int i = 0; i < counts.length; i++) {
      if (counts[i] > 0 && below + counts[i] >= wanted) {
        return width * (i + (wanted - below) / counts[i]);
      }
      below += counts[i];
    }
    return width * counts.length;
  }

  /**
   * How many values were counted.
   *
   * @return all of them, those beyond the last bin included
   */
  public long samples() {
    return samples;
  }

  /**
   * How many values lay beyond the last bin.
   *
   * @return their number
   */
  public long beyond() {
    return beyond;
  }

  /**
   * How many values a bin holds.
   *
   * @param bin 0 … {@link #bins} − 1
   * @return their number
   */
  public long count(int bin) {
    return counts[bin];
  }

  /**
   * Number of bins.
   *
   * @return without the one beyond
   */
  public int bins() {
    return counts.length;
  }

  /**
   * Width of a bin.
   *
   * @return in the unit of the values
   */
  public double width() {
    return width;
  }
}
