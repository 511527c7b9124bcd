package fieldcal.archive.venue;

import java.util.Arrays;

/** The middle of some numbers; of an even count the mean of the two in the middle. */
public final class Median {
  private Median() {}

  /**
   * Of numbers.
   *
   * @param values in any order; unchanged
   * @return NaN without any
   */
  public static double of(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    return n == 0 ? Double.NaN : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
  }
}
