package fieldcal.movement;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The highest value that many of a team's manoeuvres have. This is their limit, however many others stay below it.
 *
 * <p>The values that robots reach are the distribution of the measured values, deconvolved from their errors: the nonparametric maximum likelihood (Kiefer and Wolfowitz 1956) over a fine grid, by expectation maximization (Laird 1978). Controllers that plan with 85 %
 * of what a robot can do leave one cluster there, and a smaller one at the limit, where robots that had to react used all of it; a kernel wide enough for the noise would merge both. The limit is the highest window of {@link
 * #HALF_WIDTH} to either side that holds a fair part of the manoeuvres.
 *
 * @param value the mean of the manoeuvres that lie there, in the unit of the values
 * @param error its standard error from the errors of the manoeuvres
 * @param scatter how much the manoeuvres there differ beyond their errors, for example because the robots differ
 * @param hidden how far above the value the limit may lie unnoticed (rms): where the errors of the manoeuvres are larger than the distance between two clusters, both look like one between them
 * @param mass how many manoeuvres lie there
 * @param share of all that were well measured
 */
record UpperEdge(
    double value, double error, double scatter, double hidden, double mass, double share) {
  /** Distance of the grid's values, in parts: a quarter of the error of a well measured manoeuvre. */
  private static final double STEP = 0.004;

  /** Robots of one team, and one robot at different times, differ by this fraction. */
  static final double HALF_WIDTH = 0.012;

  /** Manoeuvres with a larger error cannot show how values that are some per cent apart are distributed, in parts. */
  static final double WORST = 0.03;

  /** Least number of manoeuvres in a window that holds the limit … */
  private static final double FEWEST = 8;

  /** … and least part of all manoeuvres; with fewer than 80 of them, {@link #FEWEST} decides. */
  private static final double SHARE = 0.1;

  /** Robots that plan with a margin use all they have in 6 to 10 % of their manoeuvres, in matches of another simulator. So a smaller cluster with at least this part counts as well, … */
  private static final double SMALL_SHARE = 0.04;

  /** … when it lies higher by more than this part: wrongly cut pieces make such clusters up to 6.5 % above the limit. */
  private static final double APART = 0.08;

  /** A cluster that lies above the largest one by less is the limit only if it has at least this part of its mass: wrongly cut pieces made up to 0.18 in simulated matches. */
  private static final double CLEAR = 0.25;

  /**
   * Degrees of freedom of Student's distribution, which the errors follow: wrongly cut pieces give tails that are heavier than a Gaussian's, and with a Gaussian these tails became separate clusters above the limit.
   */
  private static final double FREEDOM = 4;

  /** Reach of a manoeuvre, in its errors: it does not contribute to values farther off. */
  private static final double REACH = 8;

  /** Number of iterations after which the clusters no longer move by a tenth of a step. */
  private static final int ITERATIONS = 200;

  /** From one level above the heap to the next, the distribution of the rest hardly changes: so a few iterations adapt it. */
  private static final int ADAPTING = 25;

  /** A level whose likelihood is smaller by this factor, as a logarithm, and all above it do not matter: a thousandth. */
  private static final double UNLIKELY = Math.log(1000);

  /** The grid is one of logarithms: it ends at this part of a measured value, where the worst errors that count are {@link #REACH} of them away or more. */
  private static final double LEAST = 0.1;

  /** Rounding of values and errors to cells, in parts. */
  private static final double CELL = 0.002;

  /** If a smaller part of all manoeuvres is well measured, they are no fair sample: with 3.5 mm of noise a robot of 1.5 m/s that brakes with 8 m/s² had 2 %, nearly all of them weaker ones. */
  private static final double FAIR = 0.1;

  /** The edge of values with their standard errors, each {@code count} times; null when too few are well measured. */
  static UpperEdge of(double[] value, double[] error, double[] count) {
    int[] good = new int[value.length];
    int n = 0;
    for (int i = 0; i < value.length; i++) {
      if (error[i] <= WORST * value[i] && value[i] > 0) {
        good[n++] = i;
      }
    }
    if (n == 0 || sum(count, good, n) < FAIR * Arrays.stream(count).sum()) {
      return null;
    }
    double[] v = new double[n];
    double[] e = new double[n];
    double[] c = new double[n];
    for (int k = 0; k < n; k++) {
      v[k] = value[good[k]];
      e[k] = Math.hypot(error[good[k]], CELL * v[k]);
      c[k] = count[good[k]];
    }
    return new Search(v, e, c, STEP).find();
  }

  /**
   * How much too small a limit that was found in another way may be, as a standard error. Where the errors of the manoeuvres are as large as the distance between two clusters, both look like one between them: robots that end turns with 80 % of what they
   * can do, and use all of it when they turn back, have their limit anywhere from 80 to 100 %. After deconvolution, even a few manoeuvres show how strong the strongest are.
   *
   * @param value of manoeuvres, well measured or not; NaN does not count
   * @param error their standard errors
   * @param count how many have them
   * @param limit the limit that was found
   * @param share the part of all manoeuvres that a limit must have or exceed
   * @return in the unit of the values; 0 where no more than that part lie above
   */
  static double open(double[] value, double[] error, double[] count, double limit, double share) {
    int[] known =
        IntStream.range(0, value.length).filter(i -> value[i] > 0 && error[i] > 0).toArray();
    double[] v = Arrays.stream(known).mapToDouble(i -> value[i]).toArray();
    double[] c = Arrays.stream(known).mapToDouble(i -> count[i]).toArray();
    // What robots of a team differ by is part of the error here: nothing finer matters.
    double[] e =
        Arrays.stream(known)
            .mapToDouble(i -> Math.hypot(error[i], HALF_WIDTH * value[i]))
            .toArray();
    return known.length == 0 ? 0 : open(limit, new Search(v, e, c, HALF_WIDTH).strongest(share));
  }

  /** The error that covers both where it is not known whether a higher value is the limit. */
  private static double open(double limit, double higher) {
    return 0.5 * Math.max(0, higher - limit);
  }

  private static double sum(double[] count, int[] rows, int n) {
    double sum = 0;
    for (int k = 0; k < n; k++) {
      sum += count[rows[k]];
    }
    return sum;
  }

  /** The same where it is not known whether a higher value is the limit: the error covers both. */
  private UpperEdge orUpTo(double higher) {
    return new UpperEdge(
        value, Math.hypot(error, open(value, higher)), scatter, hidden, mass, share);
  }

  /**
   * What lies in a window of the distribution.
   *
   * @param from first value of the grid
   * @param to last value of the grid
   * @param mass how many manoeuvres
   * @param value their mean
   */
  private record Heap(int from, int to, double mass, double value) {}

  /** The distribution, and the edge of it. */
  private static final class Search {
    private final double[] value;
    private final double[] error;
    private final double[] count;
    private final double step;
    private final double lowest;
    private final double[] mass;
    private final int[] first;
    private final double[][] likelihood;
    private final double total;

    Search(double[] value, double[] error, double[] count, double step) {
      this.value = value;
      this.error = error;
      this.count = count;
      this.step = step;
      total = Arrays.stream(count).sum();
      double high = 0;
      double low = Double.POSITIVE_INFINITY;
      for (int i = 0; i < value.length; i++) {
        high = Math.max(high, value[i] + REACH * error[i]);
        low = Math.min(low, lowest(i));
      }
      lowest = Math.log(low);
      mass = new double[(int) Math.ceil((Math.log(high) - lowest) / step) + 2];
      first = new int[value.length];
      likelihood = new double[value.length][];
      for (int i = 0; i < value.length; i++) {
        first[i] = (int) ((Math.log(lowest(i)) - lowest) / step);
        int last = (int) ((Math.log(value[i] + REACH * error[i]) - lowest) / step) + 1;
        likelihood[i] = new double[last - first[i] + 1];
        for (int j = 0; j < likelihood[i].length; j++) {
          double z = (value[i] - grid(first[i] + j)) / error[i];
          likelihood[i][j] = likelihood(z);
        }
      }
      Arrays.fill(mass, total / mass.length);
    }

    private double lowest(int i) {
      return Math.max(value[i] - REACH * error[i], LEAST * value[i]);
    }

    private static double likelihood(double z) {
      return Math.pow(1 + z * z / FREEDOM, -0.5 * (FREEDOM + 1));
    }

    private double grid(int j) {
      return Math.exp(lowest + j * step);
    }

    /** How many manoeuvres each value of the grid has. */
    private void deconvolve() {
      for (int k = 0; k < ITERATIONS; k++) {
        expect(new double[value.length]);
      }
    }

    /** One iteration: how many manoeuvres each value of the grid has, if values are found elsewhere with the given likelihoods. */
    private void expect(double[] elsewhere) {
      double[] factor = new double[mass.length];
      for (int i = 0; i < value.length; i++) {
        double share = count[i] / (expected(i) + elsewhere[i]);
        double[] row = likelihood[i];
        int from = first[i];
        for (int j = 0; j < row.length; j++) {
          factor[from + j] += share * row[j];
        }
      }
      for (int j = 0; j < mass.length; j++) {
        mass[j] *= factor[j];
      }
    }

    /** In four partial sums, so that the processor need not wait for each addition. */
    private double expected(int i) {
      double[] row = likelihood[i];
      int from = first[i];
      double sum0 = Double.MIN_NORMAL;
      double sum1 = 0;
      double sum2 = 0;
      double sum3 = 0;
      int j = 0;
      for (; j + 3 < row.length; j += 4) {
        sum0 += row[j] * mass[from + j];
        sum1 += row[j + 1] * mass[from + j + 1];
        sum2 += row[j + 2] * mass[from + j + 2];
        sum3 += row[j + 3] * mass[from + j + 3];
      }
      for (; j < row.length; j++) {
        sum0 += row[j] * mass[from + j];
      }
      return sum0 + sum1 + (sum2 + sum3);
    }

    UpperEdge find() {
      deconvolve();
      Heap large = highest(SHARE);
      Heap small = highest(SMALL_SHARE);
      if (large == null || small == null) {
        return large == null && small == null ? null : describe(large == null ? small : large);
      }
      if (small.value() > (1 + APART) * large.value()) {
        return describe(small);
      }
      Heap main = largest();
      boolean tail =
          large.mass() < CLEAR * main.mass() && large.value() <= (1 + APART) * main.value();
      return describe(tail ? main : large).orUpTo(small.value());
    }

    /** The value that the given share of the manoeuvres has or exceeds. */
    double strongest(double share) {
      deconvolve();
      double above = 0;
      int j = mass.length;
      while (j > 0 && above < share * total) {
        above += mass[--j];
      }
      return grid(j);
    }

    /** The window that holds most. */
    private Heap largest() {
      int half = (int) Math.round(HALF_WIDTH / step);
      int best = 0;
      double most = 0;
      for (int j = 0; j < mass.length; j++) {
        double there = massBetween(j - half, j + half);
        if (there > most) {
          most = there;
          best = j;
        }
      }
      return heap(best, half);
    }

    private Heap highest(double share) {
      double needed = Math.max(FEWEST, share * total);
      int half = (int) Math.round(HALF_WIDTH / step);
      for (int j = mass.length - 1; j >= 0; j--) {
        if (massBetween(j - half, j + half) >= needed) {
          return heap(centred(j, half), half);
        }
      }
      return null;
    }

    private double massBetween(int from, int to) {
      double sum = 0;
      for (int j = Math.max(0, from); j <= Math.min(mass.length - 1, to); j++) {
        sum += mass[j];
      }
      return sum;
    }

    /** Down to where most are: the mean of the window, until it stays. */
    private int centred(int start, int half) {
      int centre = start;
      for (int k = 0; k < half * half; k++) {
        double sum = 0;
        for (int j = Math.max(0, centre - half);
            j <= Math.min(mass.length - 1, centre + half);
            j++) {
          sum += j * mass[j];
        }
        int next = (int) Math.round(sum / massBetween(centre - half, centre + half));
        if (next == centre) {
          break;
        }
        centre = next;
      }
      return centre;
    }

    /**
     * How far above a heap the limit may lie without being noticed, rms. The limit is a heap of at least {@link #CLEAR} of the largest one, so the question is how high a part of this heap of that size can lie. For each
     * level, the likelihood is that of the manoeuvres if so many of them have this value, and all others the distribution that then fits best. The levels are weighted with their likelihoods.
     */
    private double hidden(double centre, double there) {
      double part = CLEAR / (1 + CLEAR) * there;
      double[] kept = mass.clone();
      scale(1 - part / total);
      double likeliest = Double.NEGATIVE_INFINITY;
      double weights = 0;
      double squares = 0;
      for (int level = 0; level * step <= APART; level++) {
        double above = centre * Math.expm1(level * step);
        double log = logLikelihood(centre + above, part);
        if (log > likeliest) {
          double smaller = Math.exp(likeliest - log);
          weights *= smaller;
          squares *= smaller;
          likeliest = log;
        }
        if (log < likeliest - UNLIKELY) {
          break;
        }
        double weight = Math.exp(log - likeliest);
        weights += weight;
        squares += weight * above * above;
      }
      System.arraycopy(kept, 0, mass, 0, mass.length);
      return Math.sqrt(squares / weights);
    }

    /** Of all values, if that part of them has this level and the others have the distribution that then fits them best; finds that distribution. */
    private double logLikelihood(double level, double part) {
      double[] there = new double[value.length];
      for (int i = 0; i < there.length; i++) {
        there[i] = part * likelihood((value[i] - level) / error[i]);
      }
      for (int k = 0; k < ADAPTING; k++) {
        expect(there);
        scale((total - part) / massBetween(0, mass.length - 1));
      }
      double log = 0;
      for (int i = 0; i < there.length; i++) {
        log += count[i] * Math.log(expected(i) + there[i]);
      }
      return log;
    }

    private void scale(double factor) {
      for (int j = 0; j < mass.length; j++) {
        mass[j] *= factor;
      }
    }

    private Heap heap(int centre, int half) {
      int from = Math.max(0, centre - half);
      int to = Math.min(mass.length - 1, centre + half);
      double there = massBetween(from, to);
      double mean = 0;
      for (int j = from; j <= to; j++) {
        mean += grid(j) * mass[j] / there;
      }
      return new Heap(from, to, there, mean);
    }

    private UpperEdge describe(Heap heap) {
      int from = heap.from();
      int to = heap.to();
      double there = heap.mass();
      double mean = heap.value();
      double variance = 0;
      for (int j = from; j <= to; j++) {
        variance += mass[j] / there * (grid(j) - mean) * (grid(j) - mean);
      }
      double weights = 0;
      double squares = 0;
      for (int i = 0; i < value.length; i++) {
        double inside = 0;
        for (int j = Math.max(from, first[i]);
            j <= to && j - first[i] < likelihood[i].length;
            j++) {
          inside += likelihood[i][j - first[i]] * mass[j];
        }
        double probability = inside / expected(i);
        double weight = probability / (error[i] * error[i] + variance);
        double off = value[i] - mean;
        weights += count[i] * weight;
        squares += count[i] * weight * weight * off * off;
      }
      return new UpperEdge(
          mean,
          Math.sqrt(squares) / weights,
          Math.sqrt(variance),
          hidden(mean, there),
          there,
          there / total);
    }
  }
}
