package fieldcal.fit;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Goal;
import fieldcal.kick.KickKind;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * How good the fit of one kick is: error over the Cramér–Rao bound, bias, coverage of the reported errors; kinds, noises and
 * conditions each with kicks of their own.
 */
public final class FitAccuracy {
  private static final double[] NOISE = {0.0007, 0.0014, 0.003};

  private FitAccuracy() {}

  /** What is wrong with the observations, and how near the bound the fit should come then. */
  private enum Condition {
    CLEAN("clean", 0, 0, 1.05, 1.15),
    OUTLIERS("5 % outliers", 0.05, 0, 1.25, 1.25),
    LOST("30 % lost", 0, 0.3, 1.25, 1.25);

    final String label;
    final double outliers;
    final double lost;
    final Goal median;
    final Goal worst;

    Condition(String label, double outliers, double lost, double median, double worst) {
      this.label = label;
      this.outliers = outliers;
      this.lost = lost;
      this.median = Goal.atMost(median, "%.2f");
      this.worst = Goal.atMost(worst, "%.2f");
    }
  }

  /** The rows of one kind, noise and condition. */
  private record Block(
      KickKind kind, double noise, Condition condition, List<ParameterScore> scores) {
    String title() {
      return String.format(
          Locale.ROOT, "%s, %.1f mm, %s", kind.id(), 1000 * noise, condition.label);
    }
  }

  /**
   * Prints the tables.
   *
   * @param settings number of kicks and seed
   * @param out where to
   */
  public static void run(BenchmarkSettings settings, PrintStream out) {
    out.printf(
        Locale.ROOT,
        "%d kicks per block; sampling error: RMSE/bound %.1f %%, bias %.3f, 68 %%: %.1f %%,"
            + " 95 %%: %.1f %%%n",
        settings.kicks(),
        100 * Math.sqrt(0.5 / settings.kicks()),
        Math.sqrt(1.0 / settings.kicks()),
        100 * Math.sqrt(0.68 * 0.32 / settings.kicks()),
        100 * Math.sqrt(0.95 * 0.05 / settings.kicks()));
    SplittableRandom random = new SplittableRandom(settings.seed());
    List<Block> blocks = new ArrayList<>();
    for (KickKind kind : KickKind.values()) {
      for (Condition condition : Condition.values()) {
        for (double noise : NOISE) {
          blocks.add(block(kind, noise, condition, settings.kicks(), random.split(), out));
        }
      }
    }
    summary(blocks, out);
  }

  private static Block block(
      KickKind kind,
      double noise,
      Condition condition,
      int kicks,
      SplittableRandom random,
      PrintStream out) {
    IdealKicks.Conditions drawn =
        new IdealKicks.Conditions(noise, condition.outliers, condition.lost);
    List<KickTrial> trials = KickTrial.run(kind, drawn, kicks, random);
    Block block = new Block(kind, noise, condition, ParameterScore.of(trials));
    int[] sizes =
        trials.stream().mapToInt(t -> t.fit().kick().observations().size()).sorted().toArray();
    out.printf(
        Locale.ROOT,
        "%n%s: %d observations in the median, %d wrong minima, %d without a fit%n",
        block.title(),
        sizes[sizes.length / 2],
        trials.stream().filter(KickTrial::wrong).count(),
        trials.stream().filter(KickTrial::failed).count());
    ParameterScore.print(block.scores, condition.worst, out);
    return block;
  }

  private static void summary(List<Block> blocks, PrintStream out) {
    out.printf(
        "%nsummary over the parameters of a block%n%-26s %22s %22s %18s %14s %14s  %s%n",
        "", "RMSE/bound, median", "worst", "bias/bound, worst", "68 %", "95 %", Goal.VERDICT);
    int met = 0;
    for (Block block : blocks) {
      double[] rmse = block.scores.stream().mapToDouble(ParameterScore::rmse).sorted().toArray();
      double[] bias = block.scores.stream().mapToDouble(s -> Math.abs(s.bias())).sorted().toArray();
      double[] in68 = block.scores.stream().mapToDouble(ParameterScore::in68).sorted().toArray();
      double[] in95 = block.scores.stream().mapToDouble(ParameterScore::in95).sorted().toArray();
      int last = rmse.length - 1;
      double median = 0.5 * (rmse[last / 2] + rmse[rmse.length / 2]);
      boolean good =
          block.condition.median.met(median)
              && block.scores.stream().allMatch(s -> s.meets(block.condition.worst));
      met += good ? 1 : 0;
      out.printf(
          Locale.ROOT,
          "%-26s %13.3f (%s) %13.3f (%s) %9.3f (%s) %13s %14s  %s%n",
          block.title(),
          median,
          block.condition.median,
          rmse[last],
          block.condition.worst,
          bias[last],
          ParameterScore.BIAS,
          String.format(Locale.ROOT, "%.1f–%.1f", in68[0], in68[last]),
          String.format(Locale.ROOT, "%.1f–%.1f", in95[0], in95[last]),
          Goal.verdict(good));
    }
    out.printf(
        "%d of %d blocks meet all goals (68 %%: %s, 95 %%: %s)%n",
        met, blocks.size(), ParameterScore.COVERAGE_68, ParameterScore.COVERAGE_95);
  }
}
