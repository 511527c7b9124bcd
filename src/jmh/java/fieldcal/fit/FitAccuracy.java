package fieldcal.fit;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.kick.KickKind;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
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

    double medianError() {
      double[] rmse = scores.stream().mapToDouble(ParameterScore::rmse).sorted().toArray();
      return 0.5 * (rmse[(rmse.length - 1) / 2] + rmse[rmse.length / 2]);
    }
  }

  /**
   * Prints the tables.
   *
   * @param settings number of kicks and seed
   * @param out where to
   * @param findings the numbers with a goal
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
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
    List<Block> clean = blocks.stream().filter(b -> b.condition() == Condition.CLEAN).toList();
    List<Block> disturbed = blocks.stream().filter(b -> !clean.contains(b)).toList();
    errors("", clean, settings.kicks(), findings);
    errors(", 5 % outliers or 30 % of the frames lost", disturbed, settings.kicks(), findings);
    coverage(blocks, settings.kicks(), findings);
  }

  private static void errors(String when, List<Block> blocks, int kicks, Findings findings) {
    double error = Math.sqrt(0.5 / kicks);
    Condition condition = blocks.get(0).condition();
    double median = blocks.stream().mapToDouble(Block::medianError).max().orElseThrow();
    double worst =
        blocks.stream()
            .flatMap(b -> b.scores().stream())
            .mapToDouble(ParameterScore::rmse)
            .max()
            .orElseThrow();
    String what = "RMSE over the Cramér–Rao bound" + when;
    findings.extreme(
        what + ": highest median of the parameters", "%.3f", median, error, condition.median);
    findings.extreme(what + ": worst parameter", "%.3f", worst, error, condition.worst);
  }

  private static void coverage(List<Block> blocks, int kicks, Findings findings) {
    List<ParameterScore> all = blocks.stream().flatMap(b -> b.scores().stream()).toList();
    DoubleSummaryStatistics bias =
        all.stream().mapToDouble(s -> Math.abs(s.bias())).summaryStatistics();
    findings.extreme(
        "bias over the bound, largest",
        "%.3f",
        bias.getMax(),
        Math.sqrt(1.0 / kicks),
        ParameterScore.BIAS);
    DoubleSummaryStatistics one =
        all.stream().mapToDouble(ParameterScore::in68).summaryStatistics();
    DoubleSummaryStatistics two =
        all.stream().mapToDouble(ParameterScore::in95).summaryStatistics();
    double error = 100 * Math.sqrt(0.68 * 0.32 / kicks);
    String within = "truth within %s, %s, %%";
    String name = within.formatted("one standard error", "lowest");
    findings.extreme(name, "%.1f", one.getMin(), error, ParameterScore.COVERAGE_68);
    name = within.formatted("one standard error", "highest");
    findings.extreme(name, "%.1f", one.getMax(), error, ParameterScore.COVERAGE_68);
    error = 100 * Math.sqrt(0.95 * 0.05 / kicks);
    name = within.formatted("1.96 standard errors", "lowest");
    findings.extreme(name, "%.1f", two.getMin(), error, ParameterScore.COVERAGE_95);
    name = within.formatted("1.96 standard errors", "highest");
    findings.extreme(name, "%.1f", two.getMax(), error, ParameterScore.COVERAGE_95);
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
      double median = block.medianError();
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
