package fieldcal.app.statistics;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Corrects probabilities for how many there are: whatever is true, an error among all of them is no likelier than the limit they are held against (Holm 1979, Scand. J. Statist. 6, 65). */
public final class Holm {
  private Holm() {}

  /**
   * Corrected probabilities.
   *
   * @param p probabilities, 0 … 1; NaN for what was not tested, and does not count
   * @return in the same order; NaN where it was
   */
  public static double[] corrected(double... p) {
    List<Integer> order =
        IntStream.range(0, p.length)
            .filter(i -> !Double.isNaN(p[i]))
            .boxed()
            .sorted(Comparator.comparingDouble(i -> p[i]))
            .toList();
    double[] corrected = p.clone();
    double largest = 0;
    for (int rank = 0; rank < order.size(); rank++) {
      int i = order.get(rank);
      largest = Math.max(largest, Math.min(1, (order.size() - rank) * p[i]));
      corrected[i] = largest;
    }
    return corrected;
  }

  /**
   * Corrected probabilities of several families that are read together, corrected for the number of all of them.
   *
   * @param families probabilities of each, 0 … 1; NaN for what was not tested
   * @return families in the same order and of the same lengths
   */
  public static double[][] together(double[]... families) {
    double[] all = corrected(Arrays.stream(families).flatMapToDouble(Arrays::stream).toArray());
    double[][] parts = new double[families.length][];
    int from = 0;
    for (int f = 0; f < families.length; f++) {
      parts[f] = Arrays.copyOfRange(all, from, from + families[f].length);
      from += families[f].length;
    }
    return parts;
  }
}
