package fieldcal.app.statistics;

import java.util.Arrays;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.stat.ranking.NaturalRanking;
import org.apache.commons.math3.stat.ranking.TiesStrategy;

/**
 * The rank-sum test of Wilcoxon, Mann and Whitney, two-sided, with equal samples: shares of lost frames and missed balls are zero in most stretches, and the test of Commons Math, which takes samples to be different, hardly
 * sees a camera that misses one ball in twenty.
 */
final class RankSum {
  /** Up to so many samples the probability is that of all ways to divide them; beyond, at 1 in 10 000, a normal distribution is right to a tenth of it. */
  private static final int EXACT = 30;

  private RankSum() {}

  /** Probability that two samples of one distribution lie as far apart as these, or farther; 1 when all are equal. */
  static double p(double[] a, double[] b) {
    double[] all = Arrays.copyOf(a, a.length + b.length);
    System.arraycopy(b, 0, all, a.length, b.length);
    double[] ranks = new NaturalRanking(TiesStrategy.AVERAGE).rank(all);
    double sum = Arrays.stream(ranks, 0, a.length).sum();
    return all.length <= EXACT ? exact(ranks, a.length, sum) : normal(ranks, a.length, sum);
  }

  /** All ways to choose the first sample's ranks, by their sum (the shift algorithm of Streitberg and Röhmel 1986); twice the ranks are whole numbers. */
  private static double exact(double[] ranks, int first, double sum) {
    int n = ranks.length;
    int[] doubled = Arrays.stream(ranks).mapToInt(r -> (int) Math.round(2 * r)).toArray();
    int largest = Arrays.stream(doubled).sum();
    double[][] ways = new double[first + 1][largest + 1];
    ways[0][0] = 1;
    for (int r : doubled) {
      for (int chosen = first; chosen > 0; chosen--) {
        for (int s = largest; s >= r; s--) {
          ways[chosen][s] += ways[chosen - 1][s - r];
        }
      }
    }
    double mean = first * (n + 1.0);
    double distance = Math.abs(2 * sum - mean);
    double total = 0;
    double asFar = 0;
    for (int s = 0; s <= largest; s++) {
      total += ways[first][s];
      asFar += Math.abs(s - mean) >= distance - 0.5 ? ways[first][s] : 0;
    }
    return asFar / total;
  }

  /** With the variance that the ranks have, equal ones included, and half a step for their being whole. */
  private static double normal(double[] ranks, int first, double sum) {
    double n = ranks.length;
    double middle = (n + 1) / 2;
    double squares = Arrays.stream(ranks).map(r -> (r - middle) * (r - middle)).sum();
    double variance = first * (n - first) / (n * (n - 1)) * squares;
    if (variance == 0) {
      return 1;
    }
    double distance = Math.max(0, Math.abs(sum - first * middle) - 0.5);
    return 2 * new NormalDistribution().cumulativeProbability(-distance / Math.sqrt(variance));
  }
}
