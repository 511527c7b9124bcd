package fieldcal.fit;

import java.util.Arrays;

/** Picks the observations that the global search looks at: few, but from every part of the flight. */
final class SearchSubset {
  private SearchSubset() {}

  /** At most {@code most} indices: an eighth from the rest before {@code kickTime}, and more from the early flight than the late. */
  static int[] pick(FlightData data, double kickTime, int most) {
    if (data.size <= most) {
      int[] all = new int[data.size];
      Arrays.setAll(all, i -> i);
      return all;
    }
    int first = 0;
    while (first < data.size && data.time[first] < kickTime) {
      first++;
    }
    int rest = Math.min(first, most / 8);
    int flight = most - rest;
    boolean[] chosen = new boolean[data.size];
    for (int k = 0; k < rest; k++) {
      chosen[first - 1 - (int) ((long) k * first / rest)] = true;
    }
    int n = data.size - first;
    for (int k = 0; k < flight && n > 0; k++) {
      // Quadratic spacing: the sliding phase and the first hops are short and carry the most.
      double u = (k + 0.5) / flight;
      chosen[first + Math.min(n - 1, (int) (n * (0.5 * u + 0.5 * u * u)))] = true;
    }
    int[] picked = new int[data.size];
    int count = 0;
    for (int i = 0; i < data.size; i++) {
      if (chosen[i]) {
        picked[count++] = i;
      }
    }
    return Arrays.copyOf(picked, count);
  }
}
