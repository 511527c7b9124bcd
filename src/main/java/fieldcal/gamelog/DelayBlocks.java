package fieldcal.gamelog;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The least delay from capture to reception in each of many short blocks of time, and how it changes, in constant memory.
 *
 * <p>Blocks grow with the recording. A stretch ends where a clock jumps; blocks of different stretches are not compared.
 */
final class DelayBlocks {
  /** Length of the first blocks, s: of 17 frames at 70 Hz, most of which are read in time. */
  private static final double FIRST_LENGTH = 0.25;

  /** Most blocks; chosen, because 32 to 64 remain after each doubling of their length. */
  private static final int CAPACITY = 64;

  /** Blocks are compared with those that are this part of all blocks away, so that a single step of a clock is in an eighth of the slopes. */
  private static final int PARTS = 8;

  /** From the distance between the quartiles to the standard deviation of a normal distribution. */
  private static final double QUARTILES_TO_SIGMA = 1 / 1.349;

  /** Standard error of a median by that of a mean, for a normal distribution: √(π/2). */
  private static final double MEDIAN_BY_MEAN = Math.sqrt(Math.PI / 2);

  private final List<Block> blocks = new ArrayList<>();
  private double length = FIRST_LENGTH;
  private long stretch;
  private boolean begun;
  private double begin;
  private double span;
  private double pastSpan;

  /** The frame of least delay within a block. */
  private record Block(long stretch, long number, double capture, double delay) {
    boolean isSame(Block other) {
      return stretch == other.stretch && number == other.number;
    }
  }

  void add(double capture, double delay) {
    if (!begun) {
      begun = true;
      begin = capture;
    }
    span = capture - begin;
    int last = blocks.size() - 1;
    long number = (long) Math.floor(span / length);
    if (last >= 0 && blocks.get(last).stretch == stretch) {
      // A frame that overtook others counts for the newest block.
      number = Math.max(number, blocks.get(last).number);
    }
    put(new Block(stretch, number, capture, delay));
    while (blocks.size() > CAPACITY) {
      shorten();
    }
  }

  void jumped() {
    pastSpan += span;
    span = 0;
    begun = false;
    stretch++;
  }

  /** Of all stretches together, s. */
  double span() {
    return pastSpan + span;
  }

  /** Median change of the least delay per second of capture time; NaN with less than two blocks. */
  double slope() {
    return quantile(slopes(), 0.5);
  }

  /** Standard error of the slope by the scatter of the single ones; NaN with less than two blocks. */
  double slopeError() {
    double[] slopes = slopes();
    double sigma = QUARTILES_TO_SIGMA * (quantile(slopes, 0.75) - quantile(slopes, 0.25));
    // Slopes that span the same time depend on each other.
    double independent = Math.max(1, slopes.length / (double) distance());
    return MEDIAN_BY_MEAN * sigma / Math.sqrt(independent);
  }

  private void put(Block block) {
    int last = blocks.size() - 1;
    if (last < 0 || !blocks.get(last).isSame(block)) {
      blocks.add(block);
    } else if (block.delay < blocks.get(last).delay) {
      blocks.set(last, block);
    }
  }

  /** Doubles the length of the blocks; where jumps alone make too many, the oldest one goes. */
  private void shorten() {
    length *= 2;
    List<Block> before = List.copyOf(blocks);
    blocks.clear();
    for (Block b : before) {
      put(new Block(b.stretch, Math.floorDiv(b.number, 2L), b.capture, b.delay));
    }
    if (blocks.size() == before.size()) {
      blocks.remove(0);
    }
  }

  private int distance() {
    return Math.max(1, blocks.size() / PARTS);
  }

  private double[] slopes() {
    int distance = distance();
    double[] slopes = new double[Math.max(0, blocks.size() - distance)];
    int count = 0;
    for (int i = 0; i + distance < blocks.size(); i++) {
      Block from = blocks.get(i);
      Block to = blocks.get(i + distance);
      if (from.stretch == to.stretch && to.capture > from.capture) {
        slopes[count++] = (to.delay - from.delay) / (to.capture - from.capture);
      }
    }
    double[] sorted = Arrays.copyOf(slopes, count);
    Arrays.sort(sorted);
    return sorted;
  }

  private static double quantile(double[] sorted, double share) {
    if (sorted.length == 0) {
      return Double.NaN;
    }
    double place = share * (sorted.length - 1);
    int below = (int) place;
    int above = Math.min(below + 1, sorted.length - 1);
    return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
  }
}
