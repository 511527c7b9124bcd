package fieldcal.live;

import fieldcal.benchmark.BenchmarkSettings;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeSet;

/**
 * Which samples should leave a tree, and when a warning should begin: designs beside each other on drawn series of samples. How soon a carpet that brakes 30 % more is warned about, how often without a change.
 */
public final class SampleTreeStudy {
  private static final int SERIES = 300;
  private static final int BEFORE = 100;
  private static final int AFTER = 120;
  private static final int WITHOUT_CHANGE = 200;
  private static final double CHANGE = 1.3;
  private static final double WRONG = 0.05;
  private static final double WARN = 0.2;

  private SampleTreeStudy() {}

  /** What watches one parameter whose published value is 1. */
  private interface Design {
    /** Takes a sample and says whether a warning is on. */
    boolean warns(BallSample sample);
  }

  /** A name and how to begin. */
  private record Candidate(String name, java.util.function.Supplier<Design> begin) {}

  /** The league's tree: above 31 samples the smallest and the largest leave; perhaps also those that are too old. */
  private static final class Extremes implements Design {
    private final TreeSet<BallSample> tree =
        new TreeSet<>(
            Comparator.comparingDouble(BallSample::value).thenComparingDouble(BallSample::time));
    private final int age;

    Extremes(int age) {
      this.age = age;
    }

    @Override
    public boolean warns(BallSample sample) {
      tree.add(sample);
      tree.removeIf(s -> s.time() <= sample.time() - age);
      if (tree.size() > SampleTree.ENOUGH) {
        tree.pollFirst();
        tree.pollLast();
      }
      if (tree.size() < SampleTree.ENOUGH - 2) {
        return false;
      }
      double[] v = tree.stream().mapToDouble(BallSample::value).toArray();
      return Math.abs(0.5 * (v[(v.length - 1) / 2] + v[v.length / 2]) - 1) > WARN;
    }
  }

  /** A ring; its median warns, and ends warning below another limit. */
  private static final class Ring implements Design {
    private final SampleTree tree;
    private final double clear;
    private boolean on;

    Ring(int size, double clear) {
      tree = new SampleTree(size);
      this.clear = clear;
    }

    @Override
    public boolean warns(BallSample sample) {
      tree.add(sample);
      on = tree.enough() && Math.abs(tree.median() - 1) > (on ? clear : WARN);
      return on;
    }
  }

  /** What the monitor does. */
  private static final class Ours implements Design {
    private final SampleTree tree = new SampleTree(SampleTree.ENOUGH);
    private final WarningRule rule = new WarningRule(LiveSettings.defaults());
    private boolean on;

    @Override
    public boolean warns(BallSample sample) {
      tree.add(sample);
      on = rule.judge(tree, Double.NaN, 1, on).warn();
      return on;
    }
  }

  /**
   * Prints the table.
   *
   * @param settings the seed
   * @param out gets it
   */
  public static void run(BenchmarkSettings settings, PrintStream out) {
    List<Candidate> candidates =
        List.of(
            new Candidate("extremes leave", () -> new Extremes(Integer.MAX_VALUE)),
            new Candidate("extremes, age 45", () -> new Extremes(45)),
            new Candidate("extremes, age 62", () -> new Extremes(62)),
            new Candidate("ring 61", () -> new Ring(61, WARN)),
            new Candidate("ring 31", () -> new Ring(31, WARN)),
            new Candidate("ring 31, clear 0.17", () -> new Ring(31, 0.17)),
            new Candidate("ring 31 and step", Ours::new));
    out.printf(
        "%d series each; a carpet that brakes 30 %% more: samples until the warning (95 %% within),"
            + " warnings per change; without a change: share of the series with a warning%n",
        SERIES);
    for (double published : new double[] {1, 1.077}) {
      for (double scatter : new double[] {0.03, 0.08, 0.12}) {
        out.printf(
            Locale.ROOT,
            "%ntruth %.3f of the published, scatter %.0f %%%n",
            published,
            100 * scatter);
        for (Candidate c : candidates) {
          line(c, published, scatter, new Random(settings.seed()), out);
        }
      }
    }
  }

  private static void line(
      Candidate candidate, double truth, double scatter, Random random, PrintStream out) {
    int[] delays = new int[SERIES];
    int raised = 0;
    int wrong = 0;
    for (int i = 0; i < SERIES; i++) {
      Design design = candidate.begin().get();
      delays[i] = Integer.MAX_VALUE;
      boolean before = false;
      for (int n = 0; n < BEFORE + AFTER; n++) {
        boolean on = design.warns(draw(n, n < BEFORE ? truth : truth * CHANGE, scatter, random));
        if (on && !before) {
          raised++;
          delays[i] = n >= BEFORE ? Math.min(delays[i], n - BEFORE + 1) : delays[i];
        }
        before = on;
      }
      Design unchanged = candidate.begin().get();
      boolean any = false;
      for (int n = 0; n < WITHOUT_CHANGE; n++) {
        any |= unchanged.warns(draw(n, truth, scatter, random));
      }
      wrong += any ? 1 : 0;
    }
    Arrays.sort(delays);
    out.printf(
        Locale.ROOT,
        "  %-20s %4d (%3d)   %.2f   %.3f%n",
        candidate.name(),
        delays[SERIES / 2],
        delays[(int) (0.95 * SERIES)],
        raised / (double) SERIES,
        wrong / (double) SERIES);
  }

  private static BallSample draw(int n, double truth, double scatter, Random random) {
    double factor =
        random.nextDouble() < WRONG
            ? 0.5 + 1.3 * random.nextDouble()
            : 1 + scatter * random.nextGaussian();
    return new BallSample(n, truth * factor, 0.01, false);
  }
}
