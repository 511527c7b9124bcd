package fieldcal.live;

import java.util.Arrays;

/** How fast balls usually are while they show a parameter: the median of some hundred kicks, which hardly depends on who plays at the moment. */
final class UsualSpeed {
  /** Number of speeds remembered: ten times as many as the samples behind a parameter's median, so that the scatter of the usual speed matters little. */
  private static final int MEMORY = 310;

  private final double[] squares = new double[MEMORY];
  private int added;

  /** Adds a ball's speed, m/s; NaN does not count. */
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
