package fieldcal.live;

import java.util.Arrays;

/** How fast balls usually are while they show a parameter: the median of some hundred kicks, which hardly depends on who plays at the moment. */
final class UsualSpeed {
  /** Ten times as many as a median of a parameter is from: its own scatter then matters little. */
  private static final int MEMORY = 310;

  private final double[] squares = new double[MEMORY];
  private int added;

  /** A ball's speed, m/s; not known when NaN. */
  void add(double speed) {
    if (!Double.isNaN(speed)) {
      squares[added++ % MEMORY] = speed * speed;
    }
  }

  /** Median of the squared speeds, m²/s²; NaN before the first. */
  double square() {
    int size = Math.min(added, MEMORY);
    double[] sorted = Arrays.copyOf(squares, size);
    Arrays.sort(sorted);
    return size == 0 ? Double.NaN : 0.5 * (sorted[(size - 1) / 2] + sorted[size / 2]);
  }
}
