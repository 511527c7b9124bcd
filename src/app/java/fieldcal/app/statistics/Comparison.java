package fieldcal.app.statistics;

import fieldcal.app.statistics.Statistic.How;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.inference.WilcoxonSignedRankTest;

/**
 * One statistic of two recordings.
 *
 * @param statistic which
 * @param first its value in the first recording: the median of the samples, of a scatter 1.4826 times the median distance from it; the mean where both recordings have the same median, as of lost frames, which most stretches have none of
 * @param second its value in the second
 * @param difference second minus first; of paired samples the median of the differences
 * @param error standard error of the difference
 * @param samples how many of the first recording, or pairs
 * @param p probability of such a difference, or a larger one, between two recordings of one field
 * @param pHolm the same, corrected for all statistics that were compared together (Holm 1979)
 */
public record Comparison(
    Statistic statistic,
    double first,
    double second,
    double difference,
    double error,
    int samples,
    double p,
    double pHolm) {
  /** Fewest samples of each recording, or pairs, that are compared: below, ranks cannot show a difference beyond a correction for some dozens of statistics. */
  private static final int FEWEST = 8;

  /** Median of the distance from the median to the standard deviation, of normal samples. */
  private static final double MAD = 1.4826;

  /** Standard error of a median to that of a mean, of normal samples: √(π/2). */
  private static final double MEDIAN_ERROR = Math.sqrt(Math.PI / 2);

  /** Values of a pair that differ by less than this share of them are the same: so far apart may two fits of the same detections end. */
  private static final double SAME = 1e-5;

  /** Largest probability at which two recordings are said to differ; over all statistics together. */
  public static final double ALPHA = 0.05;

  /**
   * Whether the recordings differ in it.
   *
   * @return true when chance is too unlikely, all statistics considered
   */
  public boolean differs() {
    return differs(ALPHA);
  }

  /**
   * Whether the recordings differ in it.
   *
   * @param alpha largest probability at which any difference is named between two recordings of one field
   * @return true when chance is too unlikely, all statistics considered
   */
  public boolean differs(double alpha) {
    return pHolm < alpha;
  }

  /**
   * Compares two recordings in everything that both have.
   *
   * @param first statistics of one
   * @param second statistics of the other
   * @return in the order of the first, with the correction for their number
   */
  public static List<Comparison> of(List<Statistic> first, List<Statistic> second) {
    List<Comparison> all = new ArrayList<>();
    for (Statistic a : first) {
      second.stream()
          .filter(b -> b.id().equals(a.id()))
          .findFirst()
          .flatMap(b -> compare(a, b))
          .ifPresent(all::add);
    }
    return corrected(all);
  }

  private static List<Comparison> corrected(List<Comparison> all) {
    double[] holm = Holm.corrected(all.stream().mapToDouble(Comparison::p).toArray());
    List<Comparison> result = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      Comparison c = all.get(i);
      result.add(c.withCorrected(holm[i]));
    }
    return result;
  }

  /**
   * The same, corrected together with others.
   *
   * @param corrected probability, corrected for the number of all tests, 0 … 1
   * @return the changed comparison
   */
  public Comparison withCorrected(double corrected) {
    return new Comparison(statistic, first, second, difference, error, samples, p, corrected);
  }

  private static Optional<Comparison> compare(Statistic a, Statistic b) {
    return a.comparison() == How.PAIRED ? paired(a, b) : unpaired(a, b);
  }

  private static Optional<Comparison> paired(Statistic a, Statistic b) {
    Map<String, Double> both = new TreeMap<>(a.samples());
    both.keySet().retainAll(b.samples().keySet());
    if (both.size() < FEWEST) {
      return Optional.empty();
    }
    double[] first = both.values().stream().mapToDouble(v -> v).toArray();
    double[] second = both.keySet().stream().mapToDouble(b.samples()::get).toArray();
    double[] differences = new double[first.length];
    for (int i = 0; i < first.length; i++) {
      differences[i] = second[i] - first[i];
    }
    // Pairs without a difference have no sign (Wilcoxon 1945).
    double[] signed =
        IntStream.range(0, first.length)
            .mapToDouble(i -> difference(first[i], second[i]))
            .filter(d -> d != 0)
            .toArray();
    double p =
        signed.length == 0
            ? 1
            : new WilcoxonSignedRankTest()
                .wilcoxonSignedRankTest(signed, new double[signed.length], false);
    return Optional.of(
        new Comparison(
            a,
            median(first),
            median(second),
            median(differences),
            MEDIAN_ERROR * scatter(differences) / Math.sqrt(first.length),
            first.length,
            p,
            p));
  }

  private static double difference(double first, double second) {
    double difference = second - first;
    boolean same = Math.abs(difference) < SAME * Math.max(Math.abs(first), Math.abs(second));
    return same ? 0 : difference;
  }

  private static Optional<Comparison> unpaired(Statistic a, Statistic b) {
    double[] first = a.values();
    double[] second = b.values();
    if (first.length < FEWEST || second.length < FEWEST) {
      return Optional.empty();
    }
    boolean scatter = a.comparison() == How.SCATTER;
    boolean mean = !scatter && median(first) == median(second);
    double error =
        mean
            ? Math.hypot(meanError(first), meanError(second))
            : MEDIAN_ERROR
                * Math.hypot(
                    scatter(first) / Math.sqrt(first.length),
                    scatter(second) / Math.sqrt(second.length));
    double[] ranksOf = scatter ? distances(first) : first;
    double[] against = scatter ? distances(second) : second;
    double from = scatter ? scatter(first) : mean ? StatUtils.mean(first) : median(first);
    double to = scatter ? scatter(second) : mean ? StatUtils.mean(second) : median(second);
    double p = RankSum.p(ranksOf, against);
    return Optional.of(new Comparison(a, from, to, to - from, error, first.length, p, p));
  }

  private static double meanError(double[] values) {
    return Math.sqrt(StatUtils.variance(values) / values.length);
  }

  private static double median(double[] values) {
    return StatUtils.percentile(values, 50);
  }

  private static double[] distances(double[] values) {
    double middle = median(values);
    return Arrays.stream(values).map(v -> Math.abs(v - middle)).toArray();
  }

  private static double scatter(double[] values) {
    return MAD * median(distances(values));
  }
}
